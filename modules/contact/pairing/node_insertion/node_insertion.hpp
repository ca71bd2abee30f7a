#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// Node-to-node pairing on lips whose points were made to correspond: README.md has the equations.
class NodeInsertion final : public Pairing {
 public:
  std::vector<ContactPoint> pair(const model::Model& model, const mesh::JointLips& joint, int slave,
                                 std::vector<std::string>* remarks = nullptr) const override;
};

}  // namespace ashlar::contact
