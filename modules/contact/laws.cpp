#include "contact/laws.hpp"

#include "contact/friction/barton_bandis/barton_bandis.hpp"
#include "contact/friction/coulomb/coulomb.hpp"
#include "contact/friction/lua/lua.hpp"
#include "contact/friction/none/none.hpp"
#include "contact/normal_laws/barton_bandis/barton_bandis.hpp"
#include "contact/normal_laws/cohesive/cohesive.hpp"
#include "contact/normal_laws/linear/linear.hpp"
#include "contact/normal_laws/lua/lua.hpp"
#include "contact/normal_laws/tension_cut_off/tension_cut_off.hpp"
#include "contact/normal_laws/unilateral/unilateral.hpp"

namespace ashlar::contact {

namespace {

using core::Mistakes;
using core::Settings;

/// The law of a kind that `joint` names; null if it is not said or something is wrong with it.
template <class Make, class Law>
std::shared_ptr<const Law> make_law(core::Registry& registry, const char* kind, const Settings& joint,
                                    Mistakes& mistakes) {
  if (!joint.entry(kind).object) return nullptr;
  const Settings& law = joint.object(kind);
  const core::Registry::Entry* entry = registry.find(kind, law.name);
  if (!entry || !law.complete(entry->schema)) return nullptr;
  return registry.make<Make>(kind, law.name)(law, mistakes);
}

// At c/tan φ itself rounding decides: a little less has to leave some strength.
void check_pull(const JointLaw& law, const Settings& joint, Mistakes& mistakes) {
  constexpr double within = 1 - 1e-9;
  const double pull = law.normal->tensile_strength({});
  if (pull == 0 || law.friction->frictionless()) return;
  if (law.friction->strength(-pull * within, 0).value > 0) return;
  mistakes.add(joint.place_of("normal_law"),
               "bears a pull of " + core::format_quantity(pull, core::parse_dimension("Pa")) +
                   ", under which friction '" + joint.object("friction").name +
                   "' has no shear strength left: the bond would slide freely",
               "a cohesion of at least tensile_strength*tan(friction_angle), a smaller tensile_strength, or "
               "friction = \"none\" if it shall slide");
}

}  // namespace

void register_laws(core::Registry& registry) {
  const auto add_normal = [&](const char* name, std::function<MakeNormalLaw> make) {
    registry.add_make("normal_law", name, std::move(make));
  };
  add_normal("unilateral", [](const Settings&, Mistakes&) { return std::make_shared<Unilateral>(); });
  add_normal("linear", make_linear);
  add_normal("tension_cut_off", make_tension_cut_off);
  add_normal("barton_bandis", make_barton_bandis_closure);
  add_normal("cohesive", make_cohesive);
  add_normal("lua", make_lua_normal);

  const auto add_friction = [&](const char* name, std::function<MakeFriction> make) {
    registry.add_make("friction", name, std::move(make));
  };
  add_friction("none", [](const Settings&, Mistakes&) { return std::make_shared<Frictionless>(); });
  add_friction("coulomb", make_coulomb);
  add_friction("barton_bandis", make_barton_bandis);
  add_friction("lua", make_lua_friction);
}

JointLaw make_joint_law(core::Registry& registry, const Settings& joint, Mistakes& mistakes) {
  JointLaw law;
  law.normal = make_law<MakeNormalLaw, NormalLaw>(registry, "normal_law", joint, mistakes);
  law.friction = make_law<MakeFriction, Friction>(registry, "friction", joint, mistakes);
  if (law.normal && law.friction) check_pull(law, joint, mistakes);
  return law;
}

}  // namespace ashlar::contact
