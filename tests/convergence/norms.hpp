#pragma once
// True norms of a solid's error: the displacement that its cells' dofs stand for, and the strain that its
// element projects, against a smooth field, integrated over the cells.

#include <functional>

#include "patch/solid.hpp"

namespace ashlar::convergence {

using geometry::Point;
using mesh::Index;

/// A smooth displacement [m] with its strains (xx, yy, γ_xy) and the body force that holds it [N/m³].
struct Smooth {
  std::function<Point(Point)> displacement;
  std::function<model::Voigt(Point)> strain;
  std::function<Point(Point)> body_force;
};

/// u = (sin(2x + y + 0.3), cos(x − 2y)) for given moduli.
Smooth waves(double lambda, double mu);
/// u = curl of sin(2x + 0.3) cos(3y − 0.2): keeps its volume, whatever λ is.
Smooth swirl(double mu);

/// Virtual element of an order.
std::shared_ptr<const model::Element> vem(int order, std::shared_ptr<const elasticity::Stabilisation> rest);

/// Holds an edge's nodes at a field.
void hold(patch::Solid& solid, Index edge, const std::function<Point(Point)>& field);
/// Loads an edge by a traction [Pa] that varies.
void pull(patch::Solid& solid, Index edge, const std::function<Point(Point)>& traction);

struct Norms {
  double displacement = 0;  ///< (∫ |u − u_h|²)^½ [m²]
  double energy = 0;        ///< (∫ (ε−ε_h) : D (ε−ε_h))^½
};
Norms error_norms(const patch::Solid& solid, const Smooth& exact);

/// Leads the border along the field but for the top (y = 1), which gets its tractions: a border held all
/// round would ask nearly incompressible cells for what its chords enclose too much. Weighs and solves;
/// throws if it cannot.
Norms solved_norms(patch::Solid& solid, const Smooth& exact);

}  // namespace ashlar::convergence
