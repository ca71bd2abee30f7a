#include "core/log.hpp"
#include "core/registry.hpp"
#include "elasticity/bulk.hpp"
#include "elasticity/fem.hpp"
#include "elasticity/materials/drucker_prager/drucker_prager.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/materials/lua/lua.hpp"
#include "elasticity/materials/mohr_coulomb/mohr_coulomb.hpp"
#include "elasticity/materials/orthotropic/orthotropic.hpp"
#include "elasticity/vem.hpp"
#include "elasticity/vem_high.hpp"
#include "elasticity/vem_projected.hpp"

namespace ashlar::elasticity {

namespace {

bool has_order(const core::Settings& settings, int order, int highest, core::Mistakes& mistakes) {
  if (order >= 1 && order <= highest) return true;
  mistakes.add(settings.place, "element \"" + settings.name + "\" has no order " + std::to_string(order),
               "valid: order = 1 to " + std::to_string(highest));
  return false;
}

/// The stabilisation that the scene asks for, or the usual one; null: none.
std::shared_ptr<const Stabilisation> chosen_stabilisation(core::Registry& registry,
                                                          const core::Settings& settings, bool yielding) {
  const bool said = settings.has("stabilisation");
  if (said) {
    const core::Settings& choice = settings.object("stabilisation");
    if (choice.name == "none") return nullptr;
    if (yielding)
      core::log().warning(
          core::to_string(choice.place) +
          ": cells that yield keep the stabilisation of the elastic law, and near collapse they "
          "carry too much; stabilisation = \"none\" has no such part");
    return registry.make<MakeStabilisation>("stabilisation", choice.name)(choice);
  }
  if (!yielding) return std::make_shared<BendingStabilisation>();
  core::log().info("element vem without stabilisation, as some law yields");
  return nullptr;
}

std::shared_ptr<const model::Element> make_vem(core::Registry& registry, const core::Settings& settings,
                                               const model::ElementRequest& request,
                                               core::Mistakes& mistakes) {
  if (!has_order(settings, request.order, 3, mistakes)) return nullptr;
  const bool axisymmetric = request.plane == model::Plane::axisymmetric;
  const auto stabilisation = chosen_stabilisation(registry, settings, request.yielding);
  if (!stabilisation) return std::make_shared<VemProjected>(request.order, axisymmetric, nullptr);
  std::shared_ptr<const model::Element> element;
  if (request.order == 1)
    element = std::make_shared<VemElement>(stabilisation);
  else
    element = std::make_shared<VemHigh>(request.order, stabilisation);
  if (axisymmetric) return std::make_shared<VemProjected>(request.order, true, element);
  return element;
}

std::shared_ptr<const model::Element> make_fem(const core::Settings& settings,
                                               const model::ElementRequest& request,
                                               core::Mistakes& mistakes) {
  if (!has_order(settings, request.order, 2, mistakes)) return nullptr;
  const bool incompatible = settings.flag("incompatible");
  if (incompatible && request.order > 1)
    mistakes.add(settings.place_of("incompatible"), "incompatible modes are for order = 1");
  if (incompatible && request.plane == model::Plane::axisymmetric)
    mistakes.add(settings.place_of("incompatible"),
                 "incompatible modes are for plane scenes: around an axis they fail the patch test");
  return std::make_shared<FiniteElement>(request.order, incompatible);
}

}  // namespace

ASHLAR_MODULE(registry) {
  const auto add_stabilisation = [&](const char* name, std::function<MakeStabilisation> make) {
    registry.add_make("stabilisation", name, std::move(make));
  };
  add_stabilisation("bending",
                    [](const core::Settings&) { return std::make_shared<BendingStabilisation>(); });
  add_stabilisation("shear", [](const core::Settings& settings) {
    return std::make_shared<ShearStabilisation>(settings.number("factor"));
  });
  add_stabilisation("diagonal",
                    [](const core::Settings&) { return std::make_shared<DiagonalStabilisation>(); });

  const auto add_material = [&](const char* name, model::MakeMaterial make) {
    registry.add_make("material", name, std::function<model::MakeMaterial>(make));
  };
  add_material("elastic", make_elastic);
  add_material("orthotropic", make_orthotropic);
  add_material("mohr_coulomb", make_mohr_coulomb);
  add_material("drucker_prager", make_drucker_prager);
  add_material("lua", make_lua_law);
  registry.add_make(
      "element", "vem",
      std::function<model::MakeElement>(
          [&registry](const core::Settings& settings, const model::ElementRequest& request,
                      core::Mistakes& mistakes) { return make_vem(registry, settings, request, mistakes); }));
  registry.add_make("element", "fem", std::function<model::MakeElement>(make_fem));
  // Yielding is the laws' own part of the solid's terms.
  registry.add_make("effect", "plasticity", std::function<model::MakeEffect>([](core::Registry&) {
                      return std::make_unique<Plasticity>();
                    }));
  registry.add_make("effect", "elasticity", std::function<model::MakeEffect>([](core::Registry&) {
                      return std::make_unique<Elasticity>();
                    }));
}

}  // namespace ashlar::elasticity
