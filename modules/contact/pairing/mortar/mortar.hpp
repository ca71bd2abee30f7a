#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// Segment-to-segment pairing with dual multipliers on the slave lip: README.md has the equations.
class Mortar final : public Pairing {
 public:
  std::vector<ContactPoint> pair(const model::Model& model, const mesh::JointLips& joint, int slave,
                                 std::vector<std::string>* remarks = nullptr) const override;
  bool follows() const override { return true; }
};

}  // namespace ashlar::contact
