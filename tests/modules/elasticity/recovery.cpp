#include "elasticity/recovery.hpp"

#include <gtest/gtest.h>

#include "elasticity/bulk.hpp"
#include "elasticity/materials/elastic/elastic.hpp"
#include "elasticity/vem.hpp"
#include "geometry/polygon.hpp"
#include "testing/meshes.hpp"

namespace ashlar::elasticity {
namespace {

using model::Plane;

model::Model square(mesh::Mesh mesh) {
  model::Model model;
  model.mesh = std::move(mesh);
  model.materials = {std::make_shared<Elastic>(1e9, 0.3, Plane::strain)};
  model.element = std::make_shared<VemElement>(std::make_shared<BendingStabilisation>());
  model.dofs = fields::DofMap(model.mesh, {"displacement", "m"});
  return model;
}

/// Cells whose stress is that of a given field at their centroids.
template <class Field>
CellStresses sampled(const model::Model& model, Field field) {
  CellStresses cells;
  std::vector<Point> ring;
  cells.start = {0};
  for (Index c = 0; c < model.mesh.cell_count(); ++c) {
    const auto corners = model.mesh.corners(c, ring);
    const Point at = geometry::centroid(corners);
    cells.sample.push_back({at, geometry::signed_area(corners), field(c, at)});
    cells.stress.push_back(cells.sample.back().stress);
    cells.start.push_back(cells.sample.size());
  }
  return cells;
}

TEST(recovery, linear_stresses_come_out_exactly_at_every_point) {
  const auto field = [](Index, Point p) {
    return Stress{1 + 2 * p.x - p.y, 3 - p.x, 0.5 * p.y, 1.2 - 0.3 * p.x + p.y};
  };
  for (const auto& family : testing::ugly_families()) {
    SCOPED_TRACE(family.name);
    const model::Model model = square(testing::square_mesh(family.make(6)));
    const std::vector<Stress> points = recover_at_points(model, sampled(model, field));
    for (Index p = 0; p < model.mesh.point_count(); ++p)
      for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(points[p][k], field(0, model.mesh.points[p])[k], 1e-12);
  }
}

TEST(recovery, takes_the_mean_of_both_sides_where_stiffness_changes_and_no_patch_crosses) {
  model::Model model = square(testing::square_mesh(testing::structured_square(4)));
  model.materials.push_back(std::make_shared<Elastic>(5e9, 0.3, Plane::strain));
  model.mesh.regions.push_back("stiff");
  for (Index c = 0; c < model.mesh.cell_count(); ++c) model.mesh.cell_region[c] = c % 4 < 2 ? 0 : 1;
  const auto field = [&](Index c, Point) {
    return Stress{model.mesh.cell_region[c] == 0 ? 1.0 : 7.0, 0, 0, 0};
  };
  const std::vector<Stress> points = recover_at_points(model, sampled(model, field));
  for (Index p = 0; p < model.mesh.point_count(); ++p) {
    const double x = model.mesh.points[p].x;
    EXPECT_NEAR(points[p][0], x < 0.5 ? 1 : x > 0.5 ? 7 : 4, 1e-13) << x;
  }
}

// Fitted across the border, x² at x = ½ is the mean of the cells beside it; one-sided fits would give 0.203.
TEST(recovery, regions_of_equal_stiffness_are_fitted_together) {
  model::Model model = square(testing::square_mesh(testing::structured_square(4)));
  model.materials.push_back(std::make_shared<Elastic>(1e9, 0.3, Plane::strain));
  model.mesh.regions.push_back("same");
  for (Index c = 0; c < model.mesh.cell_count(); ++c) model.mesh.cell_region[c] = c % 4 < 2 ? 0 : 1;
  const auto field = [](Index, Point p) { return Stress{p.x * p.x, 0, 0, 0}; };
  const std::vector<Stress> points = recover_at_points(model, sampled(model, field));
  const Index middle = mesh::nearest_point(model.mesh, {0.5, 0.5});
  EXPECT_NEAR(points[middle][0], 0.5 * (0.375 * 0.375 + 0.625 * 0.625), 1e-13);
}

TEST(recovery, never_reaches_across_a_joint) {
  mesh::JointLine joint;
  joint.name = "cut";
  joint.path = {{0.5, 0}, {0.5, 1}};
  const model::Model model = square(testing::square_mesh(testing::structured_square(4), {joint}));
  const auto field = [](Index, Point p) { return Stress{p.x < 0.5 ? 1.0 : 7.0, 0, 0, 0}; };
  const auto cells = sampled(model, field);
  const std::vector<Stress> points = recover_at_points(model, cells);
  int left = 0, right = 0;
  for (const Stress& s : points) {
    left += std::abs(s[0] - 1) < 1e-13;
    right += std::abs(s[0] - 7) < 1e-13;
  }
  EXPECT_EQ(left, 15);
  EXPECT_EQ(right, 15);
}

TEST(principal, known_states) {
  const Principal tension = principal({3, 1, 0, 0});
  EXPECT_EQ(tension.s1, 3);
  EXPECT_EQ(tension.s3, 1);
  EXPECT_EQ(tension.angle, 0);
  EXPECT_EQ(principal({1, 3, 0, 0}).angle, 90);
  const Principal shear = principal({0, 0, 2, 0});
  EXPECT_EQ(shear.s1, 2);
  EXPECT_EQ(shear.s3, -2);
  EXPECT_DOUBLE_EQ(shear.angle, 45);
  EXPECT_DOUBLE_EQ(principal({0, 0, -2, 0}).angle, -45);
  EXPECT_DOUBLE_EQ(von_mises({0, 0, 2, 0}), 2 * std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(von_mises({5, 0, 0, 0}), 5);
  EXPECT_EQ(von_mises({4, 4, 0, 4}), 0);
}

}  // namespace
}  // namespace ashlar::elasticity
