#pragma once
// The const model: mesh, materials, element, dofs. Terms read it; nothing changes it.

#include <memory>
#include <string>
#include <vector>

#include "fields/dof_map.hpp"
#include "fields/state.hpp"
#include "mesh/mesh.hpp"
#include "mesh/section_line.hpp"
#include "model/element.hpp"
#include "model/material.hpp"

namespace ashlar::model {

using mesh::Index;

struct Model {
  mesh::Mesh mesh;
  Plane plane = Plane::strain;
  double thickness = 1;                                    ///< [m]
  std::vector<std::shared_ptr<const Material>> materials;  ///< by region
  std::shared_ptr<const Element> element;
  fields::DofMap dofs;  ///< of the displacement
  double length = 1;    ///< diagonal of the bounding box [m]
  std::vector<mesh::SectionLine> sections;

  bool axisymmetric() const { return plane == Plane::axisymmetric; }
  /// One cell as its element sees it.
  Cell cell(std::span<const Point> corners) const { return {corners, thickness, axisymmetric()}; }
  /// What an area stands for out of the plane at a place [m].
  double depth(Point at) const { return model::depth(thickness, axisymmetric(), at); }
  const Material& material(Index cell) const { return *materials[mesh.cell_region[cell]]; }
};

/// Dofs that are held in a stage, with their displacements at the stage's end, and the numbers of the free
/// ones.
struct Constraints {
  std::vector<char> held;     ///< by dof
  std::vector<double> value;  ///< by dof: prescribed displacement [m]; 0 where free
  std::vector<char>
      in_place;  ///< by dof: held where the stage finds it; if also held at a value, both must agree
  std::vector<char> at_value;  ///< by dof: held at `value`
  std::vector<int> support;    ///< by dof: the stage's support that holds it first, -1 if free
  std::vector<Index> unknown;  ///< by dof: number of the free unknown, -1 if held
  std::vector<Index> dof;      ///< by unknown
  Index unknowns() const { return static_cast<Index>(dof.size()); }
  bool same_dofs(const Constraints& other) const { return held == other.held; }
};

}  // namespace ashlar::model
