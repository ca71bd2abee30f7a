#pragma once

#include "contact/parts.hpp"

namespace ashlar::contact {

/// Node-to-segment pairing on the undeformed lips, in one pass or two: README.md has the equations.
class NodeToSegment final : public Pairing {
 public:
  enum class Weight { tributary, equal };
  explicit NodeToSegment(Weight weight, int passes = 1) : weight_(weight), passes_(passes) {}
  std::vector<ContactPoint> pair(const model::Model& model, const mesh::JointLips& joint, int slave,
                                 std::vector<std::string>* remarks = nullptr) const override;
  bool follows() const override { return passes_ == 1; }

 private:
  std::vector<ContactPoint> pass(const model::Model& model, const mesh::JointLips& joint, int slave,
                                 std::vector<std::string>* remarks) const;

  Weight weight_;
  int passes_;
};

}  // namespace ashlar::contact
