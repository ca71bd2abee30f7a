#include "stability/patch_run.hpp"

#include <stdexcept>

#include "elasticity/vem_high.hpp"

namespace ashlar::stability {

std::shared_ptr<const model::Element> element_of(int order) {
  const auto rest = std::make_shared<elasticity::BendingStabilisation>();
  if (order == 1) return std::make_shared<elasticity::VemElement>(rest);
  return std::make_shared<elasticity::VemHigh>(order, rest);
}

void add_patch_tests(const mesh::Mesh& mesh, const PatchRun& how, Fault fault, Outcome& outcome) {
  const double mu = 1e10;
  const auto law = std::make_shared<elasticity::Elastic>(2 * mu * (1 + how.nu), how.nu, model::Plane::strain);
  for (int order = 1; order <= 3; ++order)
    for (int degree = 1; degree <= order; ++degree) {
      const patch::Exact exact = patch::kolosov(degree, mu, how.nu, model::Plane::strain, how.centre);
      patch::Solid solid(mesh, law, with_fault(element_of(order), fault, mesh));
      solid.hold_border(exact.displacement);
      if (solid.solve().empty()) throw std::runtime_error(solid.failure);
      const patch::Errors found = patch::errors(solid, exact);
      const double bound = how.stretch * patch_bound(order);
      const std::string name = "order " + std::to_string(order);
      outcome.worst(name + " u", found.displacement, bound);
      outcome.worst(name + " σ", found.stress, 100 * how.stress_stretch * bound);
    }
}

}  // namespace ashlar::stability
