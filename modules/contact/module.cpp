// What the module registers: the effect, and the entries of its four kinds of parts.

#include "contact/contact.hpp"
#include "contact/cycle_rules/cycle_rules.hpp"
#include "contact/enforcement/augmented_lagrange/augmented_lagrange.hpp"
#include "contact/enforcement/lagrange/lagrange.hpp"
#include "contact/enforcement/penalty/penalty.hpp"
#include "contact/joint_driver.hpp"
#include "contact/laws.hpp"
#include "contact/pairing/mortar/mortar.hpp"
#include "contact/pairing/node_insertion/node_insertion.hpp"
#include "contact/pairing/node_to_segment/node_to_segment.hpp"

namespace {

using namespace ashlar;
using namespace ashlar::contact;
using core::Settings;

void add_pairings(core::Registry& registry) {
  registry.add_make("pairing", "node_to_segment", std::function<MakePairing>([](const Settings& settings) {
                      const auto weight = settings.text("weight") == "equal"
                                              ? NodeToSegment::Weight::equal
                                              : NodeToSegment::Weight::tributary;
                      return std::make_shared<NodeToSegment>(weight, settings.integer("passes"));
                    }));
  registry.add_make("pairing", "node_insertion", std::function<MakePairing>([](const Settings&) {
                      return std::make_shared<NodeInsertion>();
                    }));
  registry.add_make("pairing", "mortar",
                    std::function<MakePairing>([](const Settings&) { return std::make_shared<Mortar>(); }));
}

void add_enforcements(core::Registry& registry) {
  registry.add_make("enforcement", "penalty", std::function<MakeEnforcement>([](const Settings& settings) {
                      return std::make_shared<Penalty>(settings.number("factor"),
                                                       settings.number("stiffness", 0));
                    }));
  registry.add_make("enforcement", "lagrange", std::function<MakeEnforcement>([](const Settings&) {
                      return std::make_shared<Lagrange>();
                    }));
  registry.add_make("enforcement", "augmented_lagrange",
                    std::function<MakeEnforcement>([](const Settings& settings) {
                      return std::make_shared<AugmentedLagrange>(
                          settings.number("factor"), settings.number("cap"), settings.number("tolerance"));
                    }));
}

}  // namespace

ASHLAR_MODULE(registry) {
  registry.add_make("effect", "contact", std::function<model::MakeEffect>([](core::Registry& all) {
                      return std::make_unique<Contact>(all);
                    }));
  add_pairings(registry);
  add_enforcements(registry);
  registry.add_make("cycle_rule", "worst_point", std::function<MakeCycleRule>([](const Settings&) {
                      return std::make_shared<WorstPoint>();
                    }));
  registry.add_make("cycle_rule", "first_point", std::function<MakeCycleRule>([](const Settings&) {
                      return std::make_shared<FirstPoint>();
                    }));
  register_laws(registry);
  registry.add_make("driven_joint", "contact_point",
                    std::function<model::MakeJointDriver>(make_joint_driver));
}
