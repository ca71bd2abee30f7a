#pragma once
// How much of its strength a material uses: 1 at the limit, 0 unloaded, whatever the law does there.
//
// Mohr–Coulomb: the radius of Mohr's circle over the radius at which it touches the envelope with its centre
// kept ("relative shear stress"; R. B. J. Brinkgreve et al., PLAXIS 2D Reference Manual, output of stresses),
// or the greatest principal stress over the tensile strength T, whichever is more:
//   u = max( R / (c cos φ − s sin φ), σ1/T ),   R = (σ1 − σ3)/2,  s = (σ1 + σ3)/2,  of all three principal
// stresses, tension positive. Where s lies beyond the envelope's tip no radius is left: u is `most` there,
// which is also the greatest value given.

#include <limits>
#include <optional>
#include <set>
#include <string>

#include "elasticity/recovery.hpp"
#include "model/scene.hpp"

namespace ashlar::elasticity {

constexpr double most_utilisation = 10;

/// What a law with a strength is beside its model::Material.
class WithStrength {
 public:
  virtual ~WithStrength() = default;
  /// From 0 to most_utilisation.
  virtual double utilisation(const model::Voigt& stress) const = 0;
};

struct CoulombLimit {
  double cohesion = std::numeric_limits<double>::infinity();  ///< c [Pa]; infinite: no limit to shear
  double sin_friction = 0, cos_friction = 1;                  ///< of φ
  double tension = std::numeric_limits<double>::infinity();   ///< T [Pa]; infinite: no limit
};
double utilisation(const CoulombLimit& limit, const model::Voigt& stress);

/// shear / limit within 0 … most_utilisation; a limit of 0 or less is exceeded by any shear.
double share(double shear, double limit);

/// The strength that a linear law's settings name for comparison: "cohesion" and "friction", both or none,
/// and "tensile_strength" (default: c/tan φ). Nothing if they name none, or after a mistake.
std::optional<CoulombLimit> read_strength(const core::Settings& settings, core::Mistakes& mistakes);

/// Warns if the scene asks for utilisation by name and regions have no strength to compare with.
void warn_of_no_strength(const model::Scene& scene, const model::Model& model);

/// Adds the wanted ones of utilisation (cells) and utilisation_nodes, if any law has a strength; 0 where one
/// has none. At a point where laws meet: the greatest of all sides.
void add_utilisation(const model::Model& model, const CellStresses& cells,
                     const std::set<std::string>& wanted, model::StageResult& result);

}  // namespace ashlar::elasticity
