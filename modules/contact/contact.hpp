#pragma once
// The effect "contact": checks the joints' parameters and builds their term on the mesh.

#include "contact/contact_term.hpp"
#include "model/effect.hpp"

namespace ashlar::contact {

/// The lip whose points carry the contact: the one named, else the one with more edges, the first of equals.
int slave_lip(const mesh::JointLips& joint, const std::string& named);

class Contact final : public model::Effect {
 public:
  explicit Contact(core::Registry& registry) : registry_(registry) {}
  void check(const model::Scene& scene, core::Mistakes& mistakes) const override;
  /// Makes the lips of joints correspond whose pairing is node insertion.
  void shape_mesh(const model::Scene& scene, mesh::Mesh& mesh, core::Mistakes& mistakes) const override;
  void contribute(const model::StageContext& context, model::Terms& terms) override;

 private:
  /// The part of this kind that the joint names, made by its module.
  template <class Make>
  auto part(const core::Settings& joint, const char* kind, const char* key) const {
    const core::Settings& named = joint.object(key);
    return registry_.make<Make>(kind, named.name)(named);
  }
  void check_joint(const model::JointData& joint, core::Mistakes& mistakes) const;
  JointContact make_joint(const model::Model& model, const mesh::JointLips& lips,
                          const core::Settings& settings, core::Mistakes& mistakes) const;
  std::shared_ptr<ContactTerm> make_term(const model::StageContext& context) const;

  core::Registry& registry_;
  const model::Model* model_ = nullptr;  ///< of `term_`
  std::shared_ptr<ContactTerm> term_;
};

}  // namespace ashlar::contact
