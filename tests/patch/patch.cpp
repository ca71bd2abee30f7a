#include <gtest/gtest.h>

#include "modules/elasticity/cells.hpp"
#include "patch/linear_field.hpp"
#include "testing/meshes.hpp"

namespace ashlar::patch {
namespace {

using elasticity::Elastic;
using model::Plane;

class EachMesh : public ::testing::TestWithParam<testing::MeshFamily> {};
INSTANTIATE_TEST_SUITE_P(patch, EachMesh, ::testing::ValuesIn(testing::ugly_families()),
                         [](const auto& info) {
                           std::string name = info.param.name;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST_P(EachMesh, linear_fields_are_exact_in_both_planes_up_to_incompressible) {
  for (const auto& [choice, stabilisation] : elasticity::testing::stabilisations())
    for (const Plane plane : {Plane::strain, Plane::stress})
      for (const double nu : {0.0, 0.3, 0.4999}) {
        SCOPED_TRACE(choice + ", nu " + std::to_string(nu) +
                     (plane == Plane::strain ? ", strain" : ", stress"));
        Solid solid(testing::square_mesh(GetParam().make(6)), std::make_shared<Elastic>(1e10, nu, plane),
                    stabilisation);
        expect_exact(solid);
      }
}

TEST_P(EachMesh, bodies_have_three_free_motions) {
  const Solid solid(testing::square_mesh(GetParam().make(3)),
                    std::make_shared<Elastic>(1, 0.3, Plane::strain));
  const algebra::Adjacency* lists[] = {&solid.bulk->groups()};
  algebra::SymmetricMatrix k{algebra::make_pattern(solid.model.dofs.size(), lists), {}};
  k.value.resize(k.pattern.entries());
  solid.bulk->add_tangent(algebra::ScatterMap(k.pattern, solid.bulk->groups()), k.value);
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(k.pattern.size, k.pattern.size);
  for (Index j = 0; j < k.pattern.size; ++j)
    for (Index p = k.pattern.column_start[j]; p < k.pattern.column_start[j + 1]; ++p)
      full(k.pattern.row[p], j) = full(j, k.pattern.row[p]) = k.value[p];
  const Eigen::VectorXd values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(full).eigenvalues();
  EXPECT_LT(values.head(3).cwiseAbs().maxCoeff(), 1e-13 * values.maxCoeff());
  EXPECT_GT(values[3], 1e-5 * values.maxCoeff());
}

TEST_P(EachMesh, internal_forces_are_the_stiffness_times_the_displacement) {
  const Solid solid(testing::square_mesh(GetParam().make(5)),
                    std::make_shared<Elastic>(3, 0.2, Plane::strain));
  const algebra::Adjacency* lists[] = {&solid.bulk->groups()};
  algebra::SymmetricMatrix k{algebra::make_pattern(solid.model.dofs.size(), lists), {}};
  k.value.resize(k.pattern.entries());
  solid.bulk->add_tangent(algebra::ScatterMap(k.pattern, solid.bulk->groups()), k.value);
  std::vector<double> u(solid.load.size()), force(u.size()), expected(u.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = std::sin(1.0 + 1.7 * static_cast<double>(i));
  solid.bulk->add_internal_force(u, force);
  algebra::multiply(k, u, expected);
  const double scale = algebra::infinity_norm(k);
  for (std::size_t i = 0; i < u.size(); ++i) EXPECT_NEAR(force[i], expected[i], 1e-13 * scale);
}

}  // namespace
}  // namespace ashlar::patch
