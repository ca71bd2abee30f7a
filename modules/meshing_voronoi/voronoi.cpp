#include "voronoi.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include "cells.hpp"
#include "core/registry.hpp"
#include "corners.hpp"
#include "cover.hpp"
#include "mesh/near_lines.hpp"
#include "relax.hpp"

namespace ashlar::meshing_voronoi {

namespace {

constexpr int most_repairs = 8;
constexpr double close_enough = 0.03;  // of the wished number of cells; the rest is made up exactly
constexpr int most_scalings = 12;

struct Plan {
  mesh::SizeField wish;   ///< as the user said, and finer where repairs need it
  mesh::SizeField sizes;  ///< limited by the room that borders leave
  Border border;
  Index inside = 0;  ///< border sites that get cells
  Index free = 0;    ///< interior sites
};

[[noreturn]] void fail(core::Place place, std::string what, std::string advice) {
  core::Mistake mistake;
  mistake.place = std::move(place);
  mistake.what = std::move(what);
  mistake.advice = std::move(advice);
  throw core::InputError(mistake);
}

Index count_inside(const Border& border) {
  return static_cast<Index>(
      std::count_if(border.sites.begin(), border.sites.end(), [](const Site& s) { return s.face >= 0; }));
}

// Cells of the wished size that the border sites stand for: fewer than their number where they are small.
double worth(const mesh::Domain& domain, const mesh::SizeField& sizes, const Border& border) {
  double sum = 0;
  for (const Site& site : border.sites) {
    if (site.face < 0) continue;
    double radius = 0;
    int count = 0;
    for (const Index ball : site.balls) {
      if (ball < 0) continue;
      radius += border.balls[ball].radius;
      ++count;
    }
    const double share = std::sqrt(2.0) * radius / count / sizes.at(site.at, region_of(domain, site.face));
    sum += std::min(1.0, share * share);
  }
  return sum;
}

double wished_cells(const mesh::Domain& domain, const Plan& plan, const Cover& cover) {
  return cover.cells() - worth(domain, plan.sizes, plan.border) + plan.inside;
}

Plan plan_sizes(const mesh::Domain& domain, mesh::SizeField wish) {
  mesh::SizeField sizes = wish;
  Border border = protect(domain, sizes);
  const Index inside = count_inside(border);
  return {std::move(wish), std::move(sizes), std::move(border), inside, 0};
}

double area_of(const mesh::Domain& domain) {
  double area = 0;
  const Point origin = domain.points.front();
  for (const auto& segment : domain.segments) {
    const double half =
        0.5 * geometry::cross(domain.points[segment.from] - origin, domain.points[segment.to] - origin);
    if (region_of(domain, segment.left) >= 0) area += half;
    if (region_of(domain, segment.right) >= 0) area -= half;
  }
  return area;
}

// Scales the base size until about the wished number of cells fits; interior sites then make it exact.
Plan plan_cells(const mesh::Domain& domain, const core::Settings& settings, Index cells) {
  double size = std::sqrt(area_of(domain) / cells);
  mesh::require_lines_apart(domain, mesh::SizeField::read(domain, settings, size));
  for (int round = 0;; ++round) {
    Plan plan = plan_sizes(domain, mesh::SizeField::read(domain, settings, size));
    const Cover cover(domain, plan.sizes, plan.border);
    const double wished = wished_cells(domain, plan, cover);
    plan.free = std::max(0, cells - plan.inside);
    if (std::abs(wished - cells) <= close_enough * cells + 1 && plan.inside <= cells) return plan;
    if (round == most_scalings) {
      if (plan.inside <= cells) return plan;
      fail(settings.place_of("cells"), std::to_string(cells) + " cells are too few for this geometry",
           "borders and joints alone need " + std::to_string(plan.inside));
    }
    size *= std::clamp(std::sqrt(wished / cells), 0.5, 2.0);
  }
}

Plan make_plan(const mesh::Domain& domain, const core::Settings& settings) {
  if (settings.has("cells")) return plan_cells(domain, settings, settings.integer("cells"));
  mesh::SizeField wish = mesh::SizeField::read(domain, settings, 1.0);
  mesh::require_lines_apart(domain, wish);
  Plan plan = plan_sizes(domain, std::move(wish));
  plan.free = -1;
  return plan;
}

Cells make_cells(const mesh::Domain& domain, Plan& plan, const core::Settings& settings) {
  const Cover cover(domain, plan.sizes, plan.border);
  const double wished = wished_cells(domain, plan, cover);
  const Index free =
      plan.free >= 0 ? plan.free : std::max(0, static_cast<Index>(std::llround(wished)) - plan.inside);
  std::vector<Site> sites = plan.border.sites;
  const std::size_t fixed = sites.size();
  const auto seed = static_cast<std::uint64_t>(settings.integer("seed"));
  const std::vector<Site> interior = cover.sample(free, seed);
  sites.insert(sites.end(), interior.begin(), interior.end());
  relax(sites, fixed, domain, plan.sizes, cover, settings.integer("iterations"));
  return cut_cells(sites, plan.border.balls);
}

std::string number(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

mesh::RawMesh to_raw(const mesh::Domain& domain, const Cells& cells) {
  mesh::RawMesh raw;
  raw.points = cells.points;
  raw.cell_points = mesh::Adjacency(cells.offsets, cells.corners);
  for (const Index face : cells.faces) raw.cell_region.push_back(domain.faces[face].region);
  return raw;
}

void add_notes(mesh::RawMesh& raw, const core::Settings& settings, const Plan& plan, Index collapsed,
               int repairs) {
  double least = std::numeric_limits<double>::infinity(), greatest = 0;
  for (std::size_t c = 0; c < raw.cell_region.size(); ++c) {
    const Point p = raw.points[raw.cell_points[static_cast<Index>(c)][0]];
    const double size = plan.sizes.at(p, raw.cell_region[c]);
    least = std::min(least, size);
    greatest = std::max(greatest, size);
  }
  raw.notes = {{"generator", "voronoi"},
               {"seed", std::to_string(settings.integer("seed"))},
               {"iterations", std::to_string(settings.integer("iterations"))},
               {"collapsed edges", std::to_string(collapsed)},
               {"wished size", number(least) + " to " + number(greatest) + " m"}};
  if (repairs > 0) raw.notes.push_back({"local refinements to follow borders", std::to_string(repairs)});
  const Index made = raw.cell_points.size();
  if (settings.has("cells") && made != settings.integer("cells")) {
    raw.notes.push_back(
        {"cells", std::to_string(made) + " instead of " + std::to_string(settings.integer("cells"))});
  }
}

}  // namespace

mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings) {
  Plan plan = make_plan(domain, settings);
  for (int repairs = 0;; ++repairs) {
    Cells cells = make_cells(domain, plan, settings);
    const Index collapsed = collapse_short_edges(cells, settings.number("collapse"));
    const std::vector<Point> faults = find_faults(domain, plan.border, cells);
    if (faults.empty()) {
      drop_unused_points(cells);
      mesh::RawMesh raw = to_raw(domain, cells);
      add_notes(raw, settings, plan, collapsed, repairs);
      return raw;
    }
    if (repairs == most_repairs) {
      fail(settings.place,
           "mesh.voronoi cannot make sound cells near (" + number(faults[0].x) + ", " + number(faults[0].y) +
               ")",
           "look for details that are very small, or choose another seed");
    }
    const Index wanted = plan.free < 0 ? -1 : plan.free + plan.inside;
    for (const Point fault : faults) plan.wish.add({fault, fault, 0.5 * plan.sizes.at(fault, -1), 0});
    plan.wish.prepare();
    plan = plan_sizes(domain, std::move(plan.wish));
    plan.free = wanted < 0 ? -1 : std::max(0, wanted - plan.inside);
  }
}

}  // namespace ashlar::meshing_voronoi

ASHLAR_MODULE(registry) {
  registry.add_make("mesh", "voronoi",
                    std::function<ashlar::mesh::GenerateMesh>(ashlar::meshing_voronoi::generate));
}
