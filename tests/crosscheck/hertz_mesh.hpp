#pragma once
// The model of examples/hertz in quadratic cells: rings about the place where disc and block touch, at the
// same x in both bodies, so that the nodes of the contact stand opposite each other in pairs.

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "geometry/point.hpp"

namespace ashlar::test {

/// Names of the scene's own parameter `loading`: a lower half disc under an even load on its flat top, or a
/// full disc with the load on a facet of 5° at its upper pole.
enum class Loading { flat_top, pole };
std::string name_of(Loading loading);

struct HertzModel {
  enum Body { disc, block };
  struct Cell {
    Body body;
    std::vector<int> nodes;  ///< three or four corners counter-clockwise, then the middles of the sides
  };
  struct Pair {
    int disc = 0, block = 0;
  };
  std::vector<geometry::Point> points;
  std::vector<Cell> cells;
  std::vector<Pair> pairs;        ///< from x = 0 on; every second one is the middle of a side
  std::vector<double> gaps;       ///< of the pairs, along y [m]
  std::map<int, double> loads;    ///< vertical forces [N], 100 N downwards in all
  std::vector<int> axis, bottom;  ///< held in x; held
};

/// `spacing` of the rings out to x = 2 m [m].
HertzModel make_hertz(Loading loading, double spacing);

}  // namespace ashlar::test
