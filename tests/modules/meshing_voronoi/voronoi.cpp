#include "meshing_voronoi/voronoi.hpp"

#include <gtest/gtest.h>

#include <random>

#include "framework/mesh/conformity.hpp"
#include "framework/mesh/zoo.hpp"

using namespace ashlar::mesh;
namespace core = ashlar::core;
namespace geo = ashlar::geometry;

namespace {

core::Settings filled(const GeneratorSettings& said) {
  return said.with({{"size", {}},
                    {"cells", {}},
                    {"refine", {}},
                    {"seed", core::make_value(1.0)},
                    {"iterations", core::make_value(12.0)},
                    {"grading", core::make_value(0.3)},
                    {"collapse", core::make_value(0.08)}});
}

RawMesh generate(const Domain& domain, const GeneratorSettings& said) {
  return ashlar::meshing_voronoi::generate(domain, filled(said));
}

std::string mistake(const Domain& domain, const GeneratorSettings& said) {
  try {
    generate(domain, said);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "";
}

bool holds(const RawMesh& mesh, Point p) {
  return std::find(mesh.points.begin(), mesh.points.end(), p) != mesh.points.end();
}

std::vector<Point> ring_of(const RawMesh& mesh, Index cell) {
  std::vector<Point> ring;
  for (const Index p : mesh.cell_points[cell]) ring.push_back(mesh.points[p]);
  return ring;
}

double roundness(const std::vector<Point>& ring) {
  double perimeter = 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    perimeter += geo::distance(ring[k], ring[(k + 1) % ring.size()]);
  return 4 * M_PI * geo::signed_area(ring) / (perimeter * perimeter);
}

/// Mean √area of the cells whose centroid is within `radius` of p.
double size_near(const RawMesh& mesh, Point p, double radius) {
  double sum = 0;
  int count = 0;
  for (Index c = 0; c < mesh.cell_points.size(); ++c) {
    const auto ring = ring_of(mesh, c);
    if (geo::distance(geo::centroid(ring), p) > radius) continue;
    sum += std::sqrt(geo::signed_area(ring));
    ++count;
  }
  return sum / count;
}

class Linear : public core::Function {
 public:
  std::vector<double> call(std::span<const double> at) const override { return {0.05 + 0.05 * at[0]}; }
};

class Negative : public core::Function {
 public:
  std::vector<double> call(std::span<const double>) const override { return {-1.0}; }
};

core::Value function_value(std::shared_ptr<const core::Function> function) {
  core::Value value;
  value.data = std::move(function);
  return value;
}

// A star-shaped polygon and up to four joints that do not leave it; some end on its border.
Domain random_domain(unsigned seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const int count = 4 + static_cast<int>(unit() * 9);
  std::vector<Point> corners;
  for (int k = 0; k < count; ++k) {
    const double angle = 2 * M_PI * (k + 0.8 * unit()) / count, radius = 1 + 4 * unit();
    corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  const auto inside = [&] {
    const int k = static_cast<int>(unit() * count);
    const double u = unit(), scale = std::min(1.0, 1.4 * unit());
    return scale * ((1 - u) * corners[k] + u * corners[(k + 1) % count]);
  };
  std::vector<JointLine> joints;
  for (int tries = 0; tries < 6 && joints.size() < 4; ++tries) {
    joints.push_back(joint("j" + std::to_string(tries), {inside(), inside()}));
    core::Mistakes mistakes;
    make_domain({region("body", polygon(corners))}, joints, 0.25, mistakes);
    if (!mistakes.empty()) joints.pop_back();
  }
  return zoo_domain({region("body", polygon(corners))}, joints);
}

}  // namespace

TEST(voronoi, conforms_over_the_zoo) {
  for (const auto& [name, domain, size] : zoo()) {
    const RawMesh mesh = generate(domain, GeneratorSettings().set("size", size));
    EXPECT_EQ(Conformity(domain, mesh).faults(), "") << name;
  }
}

TEST(voronoi, conforms_without_collapse_and_without_iterations) {
  for (const auto& [name, domain, size] : zoo()) {
    const auto settings = GeneratorSettings().set("size", size).set("collapse", 0.0).set("iterations", 0.0);
    EXPECT_EQ(Conformity(domain, generate(domain, settings)).faults(), "") << name;
  }
}

TEST(voronoi, conforms_to_random_polygons_with_random_joints) {
  int too_near = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Domain domain = random_domain(seed);
    try {
      const RawMesh mesh = generate(domain, GeneratorSettings().set("size", 0.4).set("seed", seed));
      EXPECT_EQ(Conformity(domain, mesh).faults(), "") << "seed " << seed;
    } catch (const core::InputError& error) {
      ++too_near;
      EXPECT_NE(std::string(error.what()).find("the mesh cannot tell them apart"), std::string::npos);
    }
  }
  EXPECT_LE(too_near, 6);
}

TEST(voronoi, the_check_sees_a_moved_point_and_a_missing_cell) {
  const Domain domain = jointed_dam();
  const RawMesh good = generate(domain, GeneratorSettings().set("cells", 300));
  EXPECT_EQ(Conformity(domain, good).faults(), "");
  RawMesh moved = good;
  *std::find(moved.points.begin(), moved.points.end(), Point{10, 4}) = Point{10, 4 + 1e-6};
  EXPECT_NE(Conformity(domain, moved).faults(), "");
  RawMesh holed = good;
  holed.cell_points = Adjacency();
  holed.cell_region.pop_back();
  for (Index c = 0; c + 1 < good.cell_points.size(); ++c) holed.cell_points.append(good.cell_points[c]);
  EXPECT_NE(Conformity(domain, holed).faults(), "");
}

TEST(voronoi, gives_the_number_of_cells_asked_for) {
  const Domain domain = jointed_dam();
  for (const int cells : {60, 200, 500, 1000, 5000, 20000}) {
    const RawMesh mesh = generate(domain, GeneratorSettings().set("cells", cells));
    EXPECT_EQ(mesh.cell_points.size(), cells);
    EXPECT_EQ(Conformity(domain, mesh).faults(), "") << cells;
  }
  EXPECT_NE(mistake(domain, GeneratorSettings().set("cells", 5)).find("too few"), std::string::npos);
}

TEST(voronoi, counts_are_exact_with_refinement) {
  const auto settings = GeneratorSettings()
                            .set("cells", 3000)
                            .refine("joint", core::make_value(std::string("fault")), 0.15, 0.3);
  const RawMesh mesh = generate(jointed_dam(), settings);
  EXPECT_EQ(mesh.cell_points.size(), 3000);
  EXPECT_LT(size_near(mesh, {7, 7}, 0.4), 0.2);
}

TEST(voronoi, tip_and_mouth_are_points_of_the_mesh) {
  for (const int cells : {100, 700, 5000}) {
    const RawMesh mesh = generate(jointed_dam(), GeneratorSettings().set("cells", cells));
    EXPECT_TRUE(holds(mesh, {4, 10}));
    EXPECT_TRUE(holds(mesh, {10, 4}));
  }
}

TEST(voronoi, same_seed_same_bits_other_seed_other_mesh) {
  const Domain domain = jointed_dam();
  const auto mesh = [&](int seed) {
    return generate(domain, GeneratorSettings().set("cells", 2000).set("seed", seed));
  };
  const RawMesh a = mesh(7), b = mesh(7), c = mesh(8);
  EXPECT_EQ(a.points, b.points);
  EXPECT_TRUE(std::ranges::equal(a.cell_points.values(), b.cell_points.values()));
  EXPECT_EQ(a.cell_region, b.cell_region);
  EXPECT_NE(a.points, c.points);
}

TEST(voronoi, cells_are_round_and_even_and_have_no_short_edges) {
  const RawMesh mesh = generate(jointed_dam(), GeneratorSettings().set("cells", 5000));
  std::vector<double> round, sizes;
  for (Index c = 0; c < mesh.cell_points.size(); ++c) {
    const auto ring = ring_of(mesh, c);
    round.push_back(roundness(ring));
    sizes.push_back(std::sqrt(geo::signed_area(ring)));
    // Collapsing takes area from neighbours: a little below the tolerance of 0.08 is what may remain.
    for (std::size_t k = 0; k < ring.size(); ++k) {
      EXPECT_GT(geo::distance(ring[k], ring[(k + 1) % ring.size()]), 0.07 * sizes.back());
    }
  }
  std::sort(round.begin(), round.end());
  std::sort(sizes.begin(), sizes.end());
  EXPECT_GT(round[2500], 0.86);  // a regular hexagon has 0.907, a square 0.785
  EXPECT_GT(round[0], 0.5);
  EXPECT_LT(sizes[4750] / sizes[250], 1.25);
}

TEST(voronoi, size_may_differ_by_region) {
  core::Table map;
  map.entries = {{"rock", core::make_value(1.0)}, {"dam", core::make_value(0.2)}};
  const RawMesh mesh = generate(jointed_dam(), GeneratorSettings().set("size", core::make_value(map)));
  EXPECT_EQ(Conformity(jointed_dam(), mesh).faults(), "");
  EXPECT_NEAR(size_near(mesh, {11.5, 12.5}, 1), 0.2, 0.02);
  EXPECT_NEAR(size_near(mesh, {20, 4}, 3), 1.0, 0.1);
}

TEST(voronoi, size_may_be_a_function) {
  const Domain domain = zoo_domain({region("block", rectangle(6, 2))});
  const auto settings = GeneratorSettings().set("size", function_value(std::make_shared<Linear>()));
  const RawMesh mesh = generate(domain, settings);
  EXPECT_EQ(Conformity(domain, mesh).faults(), "");
  EXPECT_NEAR(size_near(mesh, {1, 1}, 0.4), 0.10, 0.01);
  EXPECT_NEAR(size_near(mesh, {5, 1}, 0.7), 0.30, 0.03);
}

TEST(voronoi, refines_toward_places_and_grows_slowly) {
  Domain domain = zoo_domain({region("block", rectangle(4, 4))});
  domain.named_points["center"] = {2, 2};
  const auto coarse = GeneratorSettings().set("size", 0.5);
  for (const auto& settings :
       {GeneratorSettings(coarse).refine("at", point_value({2, 2}), 0.05, 0.2),
        GeneratorSettings(coarse).refine("point", core::make_value(std::string("center")), 0.05, 0.2)}) {
    const RawMesh mesh = generate(domain, settings);
    EXPECT_EQ(Conformity(domain, mesh).faults(), "");
    EXPECT_NEAR(size_near(mesh, {2, 2}, 0.15), 0.05, 0.01);
    EXPECT_NEAR(size_near(mesh, {2.8, 2}, 0.15), 0.05 + 0.3 * 0.6, 0.05);
  }
}

TEST(voronoi, reports_wrong_settings) {
  const Domain domain = jointed_dam();
  const auto says = [&](const GeneratorSettings& settings, const std::string& part) {
    const std::string text = mistake(domain, settings);
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(GeneratorSettings().set("size", function_value(std::make_shared<Negative>())), "above 0 m");
}
