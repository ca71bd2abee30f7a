// Ugly meshes: on each the polynomials of the element's order must come out exactly.

#include <cmath>

#include "meshing_voronoi/voronoi.hpp"
#include "patch/voronoi_settings.hpp"
#include "stability/hard_meshes.hpp"
#include "stability/patch_run.hpp"
#include "testing/meshes.hpp"

namespace ashlar::stability {

namespace {

const char* const issue_bound = "the patch test's";

using Meshes = std::vector<mesh::RawMesh>;

Case patch_row(std::string name, std::string risk, std::function<Meshes()> make,
               std::vector<Fault> plants = {Fault::wrong_sign, Fault::dropped_edge}) {
  Case row;
  row.group = "Meshes";
  row.name = std::move(name);
  row.risk = std::move(risk);
  row.bound = issue_bound;
  row.plants = std::move(plants);
  row.run = [make = std::move(make)](Fault fault) {
    Outcome outcome;
    for (mesh::RawMesh& raw : make()) add_patch_tests(bare(std::move(raw)), {}, fault, outcome);
    return outcome;
  };
  return row;
}

/// Columns of a square mesh squeezed to cells `aspect` times as long as high.
Case aspect_row() {
  Case row;
  row.group = "Meshes";
  row.name = "cells 1 to 10⁴ times as long as high";
  row.risk = "bases of monomials and stabilisation lose the short side";
  row.bound =
      std::string(issue_bound) +
      "; times the aspect, as a strain across a cell is a difference of displacements over its height";
  row.plants = {Fault::wrong_sign, Fault::dropped_edge};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const double aspect : {1.0, 10.0, 1e2, 1e3, 1e4}) {
      const auto raw = mapped(testing::distorted_square(6, 0.15), [&](Point p) {
        return Point{p.x, p.y / aspect};
      });
      add_patch_tests(bare(raw), {{0.3, 0.1 / aspect}, 0.3, aspect, 1}, fault, outcome);
    }
    return outcome;
  };
  return row;
}

Case needle_row() {
  Case row;
  row.group = "Meshes";
  row.name = "a cell collapsing to a needle, 10⁻¹ to 10⁻⁸ high";
  row.risk = "its area, its moments and the slopes of its shape functions vanish in round-off";
  row.bound =
      std::string(
          "the needle is 1/flatness stiffer than its neighbours: what round-off (2e-16) leaves of its forces "
          "moves them by 2e-16/flatness, where that is above ") +
      issue_bound;
  row.plants = {Fault::wrong_sign, Fault::dropped_edge};
  row.run = [](Fault fault) {
    Outcome outcome;
    for (const int corners : {3, 4, 8})
      for (const double flat : {1e-1, 1e-2, 1e-4, 1e-6, 1e-8})
        add_patch_tests(bare(regular_cell(corners, flat)), {{0.5, 0.5}, 0.3, std::max(1.0, 2e-4 / flat), 1},
                        fault, outcome);
    return outcome;
  };
  return row;
}

Meshes regular_cells(int from, int to, int step) {
  Meshes meshes;
  for (int n = from; n <= to; n += step) meshes.push_back(regular_cell(n));
  return meshes;
}

}  // namespace

std::vector<Case> mesh_rows() {
  using namespace testing;
  std::vector<Case> rows;
  rows.push_back(aspect_row());
  rows.push_back(patch_row("edges of 10⁻¹⁰ of the cell's size", "their slopes and lengths drown in round-off",
                           [] { return Meshes{short_edge_square(6, 1e-10)}; }));
  rows.push_back(patch_row("cells of 3 to 60 corners", "matrices grow; weights of many corners cancel",
                           [] { return regular_cells(3, 60, 3); }));
  rows.push_back(patch_row("collinear runs of corners", "triangles of no area; edges of one direction", [] {
    return Meshes{collinear_square(6),
                  joined(structured_square(24), [](Point p) { return p.x < 0.5 ? 0 : 1; })};
  }));
  rows.push_back(patch_row("non-convex cells: chevrons and pegs", "integrals that take cells for convex", [] {
    return Meshes{chevron_square(6), pegboard_square(6)};
  }));
  rows.push_back(
      patch_row("stars of 4 to 12 points", "centroid and corners do not see each other's sectors", [] {
        return Meshes{star_cell(4), star_cell(5), star_cell(8), star_cell(12)};
      }));
  rows.push_back(patch_row("C-shaped cells with plugs", "the centroid lies outside of the cell", [] {
    return Meshes{c_shaped(1), c_shaped(3)};
  }));
  rows.push_back(needle_row());
  rows.push_back(
      patch_row("Kershaw's mesh, squeezed to 0.3, 0.1 and 0.03", "sheared cells of every aspect", [] {
        return Meshes{kershaw_square(12), kershaw_square(12, 0.1), kershaw_square(12, 0.03)};
      }));
  rows.push_back(
      patch_row("quadrilaterals distorted at random", "nearly triangular and non-convex quadrilaterals", [] {
        return Meshes{distorted_square(8, 0.28, 1), distorted_square(8, 0.35, 2),
                      distorted_square(8, 0.4, 3)};
      }));
  rows.push_back(patch_row("hexagons cut by the border", "slivers along the border",
                           [] { return Meshes{honeycomb_square(8)}; }));
  rows.push_back(
      patch_row("hanging nodes, 2 to 16 on one side", "sides of many edges beside sides of one", [] {
        return Meshes{hanging_square(6), many_to_one(4), many_to_one(16)};
      }));
  rows.push_back(patch_row("agglomerated cells", "heaps of cells: any number of corners, any shape", [] {
    return Meshes{agglomerated(12, 6, 1), agglomerated(12, 12, 2)};
  }));
  rows.push_back(
      patch_row("Voronoi cells, neither relaxed nor collapsed", "short edges and slivers as they come", [] {
        Meshes meshes;
        const mesh::Domain domain = square_domain();
        for (const int seed : {1, 2})
          meshes.push_back(meshing_voronoi::generate(domain, patch::voronoi_settings({80, seed, 0})));
        return meshes;
      }));
  return rows;
}

}  // namespace ashlar::stability
