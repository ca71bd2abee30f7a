#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// One-pass node-to-segment pairing on the undeformed lips: README.md has the equations.
class NodeToSegment final : public Pairing {
 public:
  enum class Weight { tributary, equal };
  explicit NodeToSegment(Weight weight) : weight_(weight) {}
  std::vector<ContactPoint> pair(const model::Model& model, const mesh::JointLips& joint,
                                 int slave) const override;

 private:
  Weight weight_;
};

}  // namespace ashlar::contact
