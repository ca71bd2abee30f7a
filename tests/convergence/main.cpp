// Prints the jointed dam's numbers over finer and finer meshes.
//   convergence [voronoi|quads|triangles [CELLS…]]

#include <cstdio>
#include <exception>

#include "convergence/dam_numbers.hpp"

namespace {

using namespace ashlar::test;

void print_row(const std::string& mesh, const DamNumbers& now, const DamNumbers* before) {
  if (!before) {
    std::printf("\n%s, stage %s; lengths in mm, forces in kN\n%8s", mesh.c_str(), now.stage.c_str(), "cells");
    for (const auto& [name, value] : now.settling) std::printf(" %11s", name.c_str());
    std::printf(" %11s %9s\n", "peak MPa", "change %");
  }
  std::printf("%8d", now.cells);
  for (const auto& [name, value] : now.settling) std::printf(" %11.5f", value);
  std::printf(" %11.3f", now.peak);
  if (before) std::printf(" %9.3f", 100 * relative_change(*before, now));
  std::printf("\n");
}

}  // namespace

int main(int count, char** words) {
  try {
    const std::string mesh = count > 1 ? words[1] : "voronoi";
    std::vector<int> sizes;
    for (int i = 2; i < count; ++i) sizes.push_back(std::stoi(words[i]));
    if (sizes.empty()) sizes = {500, 1000, 2000, 5000, 10000, 20000, 50000};
    std::vector<std::vector<DamNumbers>> meshes;
    for (const int cells : sizes) meshes.push_back(dam_numbers(mesh, cells));
    for (std::size_t stage = 0; stage < meshes.front().size(); ++stage)
      for (std::size_t i = 0; i < meshes.size(); ++i)
        print_row(mesh, meshes[i][stage], i > 0 ? &meshes[i - 1][stage] : nullptr);
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "convergence: %s\n", problem.what());
    return 1;
  }
}
