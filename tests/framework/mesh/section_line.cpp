#include "mesh/section_line.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "testing/meshes.hpp"

namespace ashlar::mesh {
namespace {

using Side = LinePiece::Cell;

double length_of(const SectionLine& line, Side but) {
  double sum = 0;
  for (const LinePiece& piece : line.pieces)
    if (piece.side != but) sum += distance(piece.from.at, piece.to.at);
  return sum;
}

TEST(section_line, covers_its_way_through_any_cells_without_gaps) {
  for (const auto& family : testing::ugly_families()) {
    SCOPED_TRACE(family.name);
    const Mesh mesh = testing::square_mesh(family.make(6));
    for (const auto& path : {std::vector<Point>{{0.31, 0}, {0.44, 1}}, std::vector<Point>{{0, 0}, {1, 1}},
                             std::vector<Point>{{-3, 0.37}, {0.5, 0.7}, {2, -0.2}}}) {
      const SectionLine line = trace(mesh, path, 1e-10);
      ASSERT_FALSE(line.pieces.empty());
      double reached = line.pieces.front().from.s;
      for (const LinePiece& piece : line.pieces) {
        if (piece.side != Side::right) {
          EXPECT_NEAR(piece.from.s, reached, 1e-9);
        }
        reached = std::max(reached, piece.to.s);
      }
      EXPECT_NEAR(length_of(line, Side::right), reached - line.pieces.front().from.s, 1e-9);
      EXPECT_FALSE(line.ends_inside);
    }
  }
}

TEST(section_line, knows_the_cells_on_both_sides_of_edges_that_it_follows) {
  const Mesh mesh = testing::square_mesh(testing::structured_square(4));
  const SectionLine line = trace(mesh, {{0, 0.5}, {1, 0.5}}, 1e-10);
  EXPECT_EQ(line.pieces.size(), 8u);
  EXPECT_EQ(line.cells.size(), 8u);
  for (const TouchedCell& each : line.cells)
    EXPECT_EQ(each.side, each.cell >= 8 ? Side::left : Side::right) << each.cell;
  EXPECT_NEAR(length_of(line, Side::right), 1, 1e-12);
  EXPECT_GT(line.side({0.2, 0.6}), 0);
  EXPECT_LT(line.side({7, 0.4}), 0);
  EXPECT_EQ(line.side({0.2, 0.5 + 1e-11}), 0);
}

TEST(section_line, on_a_border_has_the_body_on_one_side) {
  const Mesh mesh = testing::square_mesh(testing::structured_square(3));
  EXPECT_FALSE(trace(mesh, {{0, 0}, {1, 0}}, 1e-10).body_on_right());
  EXPECT_TRUE(trace(mesh, {{1, 0}, {0, 0}}, 1e-10).body_on_right());
}

TEST(section_line, an_end_inside_a_cell_moves_out_to_its_border) {
  const Mesh mesh = testing::square_mesh(testing::structured_square(4));
  const SectionLine line = trace(mesh, {{0.3, 0.1}, {0.3, 0.6}}, 1e-10);
  EXPECT_EQ(line.first(), (Point{0.3, 0}));
  EXPECT_NEAR(line.last().y, 0.75, 1e-14);
  EXPECT_NEAR(line.pieces.front().from.s, -0.1, 1e-14);
  EXPECT_TRUE(line.ends_inside);
}

TEST(section_line, off_the_body_has_no_pieces) {
  const Mesh mesh = testing::square_mesh(testing::structured_square(2));
  EXPECT_TRUE(trace(mesh, {{0, 2}, {1, 2}}, 1e-10).pieces.empty());
  EXPECT_TRUE(trace(mesh, {{2, 0}, {3, 0}}, 1e-10).pieces.empty());
}

}  // namespace
}  // namespace ashlar::mesh
