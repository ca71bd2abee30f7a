#pragma once
// What the settings ask for in each region.

#include <array>
#include <string>
#include <vector>

#include "core/schema.hpp"

namespace ashlar::meshing_structured {

struct Request {
  std::array<int, 2> cells = {0, 0};  ///< columns and rows; 0: by size
  double size = 0;                    ///< [m]; 0: by cells
  std::array<double, 2> grading = {1, 1};
};

/// One request for each region. Throws InputError for a region with neither cells nor size, or with both
/// said.
std::vector<Request> requests(const core::Settings& settings, const std::vector<std::string>& regions);

}  // namespace ashlar::meshing_structured
