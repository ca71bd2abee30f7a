#include "contact/contact.hpp"

#include <algorithm>

#include "contact/laws.hpp"
#include "contact/repeated.hpp"
#include "core/log.hpp"
#include "mesh/match_lips.hpp"
#include "model/place.hpp"

namespace ashlar::contact {

namespace {

// Lips that overlap by more than this share of the mesh size at the start are a mistake in the drawing, less
// is rounding of coordinates that the first stage presses out.
constexpr double overlap_allowed = 1e-3;

/// "1.2 MPa/m … 3.4 MPa/m": how stiffly points are held; "exactly".
std::string stiffness_text(const JointContact& joint) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ContactPoint& point : joint.points) {
    const double k = 1 / joint.enforcement->hold(point, {0, 0}, 1).normal;
    least = std::min(least, k);
    most = std::max(most, k);
  }
  if (std::isinf(least)) return "held exactly";
  const core::Dimension unit = core::parse_dimension("Pa/m");
  const std::string low = core::format_quantity(least, unit), high = core::format_quantity(most, unit);
  return "stiffness " + (low == high ? low : low + " … " + high);
}

void check_overlap(const JointContact& joint, const core::Place& place, core::Mistakes& mistakes) {
  const auto deepest = std::ranges::max_element(joint.points, {}, &ContactPoint::overlap);
  if (deepest == joint.points.end() || deepest->overlap <= 0) return;
  const std::string words = "the bodies of joint '" + joint.name + "' overlap at the start by " +
                            core::format_quantity(deepest->overlap, {1, 0, 0}) + " at " +
                            model::place_text(deepest->at);
  if (deepest->overlap > overlap_allowed * deepest->h)
    mistakes.add(place, words, "draw them apart, or so that they just touch");
  else
    core::log().warning(words + ": the first stage presses it out");
}

}  // namespace

int slave_lip(const mesh::JointLips& joint, const std::string& named) {
  const auto is = [&](const std::string& side) { return named == side || named == joint.name + "." + side; };
  if (!named.empty()) return is(joint.sides[0]) ? 0 : 1;
  return joint.lips[1].size() > joint.lips[0].size() ? 1 : 0;
}

void Contact::check(const model::Scene& scene, core::Mistakes& mistakes) const {
  for (const model::JointData& joint : scene.joints) check_joint(joint, mistakes);
}

void Contact::check_joint(const model::JointData& joint, core::Mistakes& mistakes) const {
  const core::Settings& settings = joint.settings;
  const std::string name = "joint '" + joint.line.name + "'";
  if (!settings.said("friction"))
    mistakes.add({settings.place.file, settings.place.line, settings.place.path + ".friction"},
                 name + " does not say its friction", core::did_you_mean("", registry_.names("friction")));
  make_joint_law(registry_, settings, mistakes);
  if (settings.text("sliding") == "finite" && settings.entry("pairing").object &&
      !part<MakePairing>(settings, "pairing", "pairing")->follows())
    mistakes.add(settings.place_of("sliding"),
                 name + " is to slide far, but its pairing stays as in the undeformed mesh",
                 "pairing = \"mortar\" or \"node_to_segment\" in one pass");
  const std::string slave = settings.text("slave");
  if (slave.empty()) return;
  const std::vector<std::string> lips = {joint.line.name + "." + joint.line.sides[0],
                                         joint.line.name + "." + joint.line.sides[1]};
  for (const std::string& lip : lips)
    if (slave == lip || joint.line.name + "." + slave == lip) return;
  mistakes.add(settings.place_of("slave"), name + " has no lip '" + slave + "'",
               core::did_you_mean(slave, lips));
}

void Contact::shape_mesh(const model::Scene& scene, mesh::Mesh& mesh, core::Mistakes&) const {
  for (std::size_t j = 0; j < mesh.joints.size(); ++j)
    for (const model::JointData& joint : scene.joints) {
      const core::Settings& pairing = joint.settings.object("pairing");
      if (joint.line.name != mesh.joints[j].name || pairing.name != "node_insertion") continue;
      const Index inserted = mesh::match_lips(mesh, j, pairing.number("reach"));
      core::log().info("joint '" + joint.line.name + "': " + std::to_string(inserted) +
                       " points inserted, so that both lips have the same");
    }
}

JointContact Contact::make_joint(const model::Model& model, const mesh::JointLips& lips,
                                 const core::Settings& settings, core::Mistakes& mistakes) const {
  JointContact joint;
  joint.name = lips.name;
  joint.law = make_joint_law(registry_, settings, mistakes);
  joint.enforcement = part<MakeEnforcement>(settings, "enforcement", "enforce");
  const int slave = slave_lip(lips, settings.text("slave"));
  const auto pairing = part<MakePairing>(settings, "pairing", "pairing");
  std::vector<std::string> remarks;
  joint.points = pairing->pair(model, lips, slave, &remarks);
  for (const std::string& remark : remarks) core::log().warning("joint '" + joint.name + "': " + remark);
  if (settings.text("sliding") == "finite") joint.follow = pairing;
  if (joint.points.empty()) {
    core::log().warning("joint '" + joint.name + "' has no contact points: it is welded all along");
    return joint;
  }
  check_overlap(joint, settings.place, mistakes);
  core::log().info("joint '" + joint.name + "': " + std::to_string(joint.points.size()) +
                   " contact points on lip '" + joint.name + "." + lips.sides[slave] + "', " +
                   stiffness_text(joint));
  return joint;
}

std::shared_ptr<ContactTerm> Contact::make_term(const model::StageContext& context) const {
  std::vector<JointContact> joints;
  for (const mesh::JointLips& lips : context.model.mesh.joints) {
    const auto said = std::ranges::find_if(
        context.scene.joints, [&](const model::JointData& data) { return data.line.name == lips.name; });
    if (said == context.scene.joints.end()) continue;
    JointContact joint = make_joint(context.model, lips, said->settings, context.mistakes);
    if (!joint.points.empty()) joints.push_back(std::move(joint));
  }
  if (const int joined = join_repeated(joints); joined > 0)
    core::log().info(
        "where joints meet or turn, " + std::to_string(joined) +
        " rigid points repeat what others hold: each is held in the mean with the next of its joint");
  const core::Settings& rule = context.scene.root.object("cycle_rule");
  return std::make_shared<ContactTerm>(context.model, std::move(joints),
                                       registry_.make<MakeCycleRule>("cycle_rule", rule.name)(rule));
}

void Contact::contribute(const model::StageContext& context, model::Terms& terms) {
  if (model_ != &context.model) term_ = make_term(context);
  model_ = &context.model;
  if (term_->joints().empty()) return;
  term_->add_state(context.state);
  terms.local.push_back(term_);
}

}  // namespace ashlar::contact
