#include "contact/contact.hpp"

#include <algorithm>

#include "contact/enforcement/penalty/penalty.hpp"
#include "contact/friction/none/none.hpp"
#include "contact/normal_laws/unilateral/unilateral.hpp"
#include "contact/pairing/node_to_segment/node_to_segment.hpp"
#include "core/log.hpp"

namespace ashlar::contact {

namespace {

/// "1.2 MPa/m … 3.4 MPa/m": the slopes of the pressure over the points of a joint.
std::string stiffness_text(const JointContact& joint) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ContactPoint& point : joint.points) {
    const double k = -joint.enforcement->pressure(point.gap, point).by_gap;
    least = std::min(least, k);
    most = std::max(most, k);
  }
  const core::Dimension unit = core::parse_dimension("Pa/m");
  const std::string low = core::format_quantity(least, unit), high = core::format_quantity(most, unit);
  return low == high ? low : low + " … " + high;
}

}  // namespace

int slave_lip(const mesh::JointLips& joint, const std::string& named) {
  const auto is = [&](const std::string& side) { return named == side || named == joint.name + "." + side; };
  if (!named.empty()) return is(joint.sides[0]) ? 0 : 1;
  return joint.lips[1].size() > joint.lips[0].size() ? 1 : 0;
}

void Contact::check(const model::Scene& scene, core::Mistakes& mistakes) const {
  for (const model::JointData& joint : scene.joints) {
    check_joint(joint, mistakes);
    if (scene.order > 1 && joint.settings.entry("pairing").object &&
        joint.settings.object("pairing").name == "node_to_segment")
      mistakes.add(joint.settings.place_of("pairing"),
                   "node_to_segment pairs the points of elements of order 1, but the scene says order " +
                       std::to_string(scene.order),
                   "say order = 1");
  }
}

void Contact::check_joint(const model::JointData& joint, core::Mistakes& mistakes) const {
  const core::Settings& settings = joint.settings;
  const std::string name = "joint '" + joint.line.name + "'";
  if (!settings.said("friction"))
    mistakes.add({settings.place.file, settings.place.line, settings.place.path + ".friction"},
                 name + " does not say its friction", core::did_you_mean("", registry_.names("friction")));
  const std::string slave = settings.text("slave");
  if (slave.empty()) return;
  const std::vector<std::string> lips = {joint.line.name + "." + joint.line.sides[0],
                                         joint.line.name + "." + joint.line.sides[1]};
  for (const std::string& lip : lips)
    if (slave == lip || joint.line.name + "." + slave == lip) return;
  mistakes.add(settings.place_of("slave"), name + " has no lip '" + slave + "'",
               core::did_you_mean(slave, lips));
}

JointContact Contact::make_joint(const model::Model& model, const mesh::JointLips& lips,
                                 const core::Settings& settings) const {
  const auto make = [&]<class Make>(const char* kind, const char* key) {
    const core::Settings& part = settings.object(key);
    return registry_.make<Make>(kind, part.name)(part);
  };
  JointContact joint;
  joint.name = lips.name;
  joint.slave = slave_lip(lips, settings.text("slave"));
  joint.law = make.operator()<MakeNormalLaw>("normal_law", "normal_law");
  joint.enforcement = make.operator()<MakeEnforcement>("enforcement", "enforce");
  joint.friction = make.operator()<MakeFriction>("friction", "friction");
  joint.points = make.operator()<MakePairing>("pairing", "pairing")->pair(model, lips, joint.slave);
  return joint;
}

std::shared_ptr<ContactTerm> Contact::make_term(const model::Scene& scene, const model::Model& model) const {
  std::vector<JointContact> joints;
  for (const mesh::JointLips& lips : model.mesh.joints) {
    const auto said = std::find_if(scene.joints.begin(), scene.joints.end(),
                                   [&](const model::JointData& data) { return data.line.name == lips.name; });
    if (said == scene.joints.end()) continue;
    JointContact joint = make_joint(model, lips, said->settings);
    if (joint.points.empty()) {
      core::log().warning("joint '" + joint.name + "' has no contact points: it is welded all along");
      continue;
    }
    core::log().info("joint '" + joint.name + "': " + std::to_string(joint.points.size()) +
                     " contact points on lip '" + joint.name + "." + lips.sides[joint.slave] +
                     "', stiffness " + stiffness_text(joint));
    joints.push_back(std::move(joint));
  }
  return std::make_shared<ContactTerm>(model, std::move(joints));
}

void Contact::contribute(const model::StageContext& context, model::Terms& terms) {
  if (model_ != &context.model) term_ = make_term(context.scene, context.model);
  model_ = &context.model;
  if (term_->joints().empty()) return;
  term_->add_state(context.state);
  terms.local.push_back(term_);
}

}  // namespace ashlar::contact

namespace {

using namespace ashlar;
using core::Settings;

std::shared_ptr<const contact::Pairing> make_pairing(const Settings& settings) {
  using Weight = contact::NodeToSegment::Weight;
  return std::make_shared<contact::NodeToSegment>(settings.text("weight") == "equal" ? Weight::equal
                                                                                     : Weight::tributary);
}

std::shared_ptr<const contact::Enforcement> make_penalty(const Settings& settings) {
  return std::make_shared<contact::Penalty>(settings.number("factor"), settings.number("stiffness", 0));
}

}  // namespace

ASHLAR_MODULE(registry) {
  registry.add_make("effect", "contact", std::function<model::MakeEffect>([](core::Registry& all) {
                      return std::make_unique<contact::Contact>(all);
                    }));
  registry.add_make("pairing", "node_to_segment", std::function<contact::MakePairing>(make_pairing));
  registry.add_make("normal_law", "unilateral", std::function<contact::MakeNormalLaw>([](const Settings&) {
                      return std::make_shared<contact::Unilateral>();
                    }));
  registry.add_make("friction", "none", std::function<contact::MakeFriction>([](const Settings&) {
                      return std::make_shared<contact::Frictionless>();
                    }));
  registry.add_make("enforcement", "penalty", std::function<contact::MakeEnforcement>(make_penalty));
}
