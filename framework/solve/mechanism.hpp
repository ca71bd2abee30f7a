#pragma once
// How bodies move that their joints do not hold.

#include <string>
#include <vector>

#include <Eigen/Core>

#include "model/model.hpp"
#include "model/scene.hpp"

namespace ashlar::solve {

/// A displacement that meets no resistance, of any size, in the sense in which the load does work.
struct Mechanism {
  std::vector<mesh::Index> dofs;
  Eigen::VectorXd motion;  ///< by dof; empty: not known
};

/// ": 'block' slides along (-0.87, -0.50); 'cap' turns about (3 m, 1 m)": the rigid motion of each body that
/// moves, from that of its points on joints; the fastest first. Empty if the mechanism is not known.
std::string moving_bodies(const model::Model& model, const model::Scene& scene, const Mechanism& mechanism);

}  // namespace ashlar::solve
