// Prints the jointed dam's probes by Ashlar and by CalculiX, mesh after mesh, and how far they lie apart; or
// the pressure of examples/hertz by CalculiX, its nodes at the contact SPACING metres apart; or draws it
// beside Ashlar's.
//   crosscheck [CELLS…]
//   crosscheck hertz SPACING
//   crosscheck hertz_picture FILE

#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>

#include "crosscheck/compare.hpp"
#include "crosscheck/hertz_picture.hpp"
#include "crosscheck/hertz_reference.hpp"

namespace {

using namespace ashlar::test;

void print_table(const Comparison& now, const std::optional<Comparison>& before) {
  std::printf("\n%d cells, CalculiX %.1f s of CPU; displacements in mm\n", now.cells, now.calculix_cpu);
  std::printf("%-5s %-12s %-2s %10s %10s %11s %11s\n", "stage", "probe", "", "Ashlar", "CalculiX",
              "difference", "our change");
  for (std::size_t stage = 0; stage < now.ours.size(); ++stage)
    for (const auto& [probe, u] : now.ours[stage])
      for (std::size_t axis = 0; axis < u.size(); ++axis) {
        const double theirs = now.theirs[stage].at(probe)[axis];
        std::printf("%-5zu %-12s u%c %10.5f %10.5f %11.5f", stage + 1, probe.c_str(), "xy"[axis],
                    1e3 * u[axis], 1e3 * theirs, 1e3 * (u[axis] - theirs));
        if (before) std::printf(" %11.5f", 1e3 * (u[axis] - before->ours[stage].at(probe)[axis]));
        std::printf("\n");
      }
}

void print_summary(const Comparison& now, const std::optional<Comparison>& before) {
  std::printf("all probes: difference %.3f %%", 100 * relative_difference(now.ours, now.theirs));
  if (before)
    std::printf(", change from the mesh before: Ashlar %.3f %%, CalculiX %.3f %%",
                100 * relative_difference(before->ours, now.ours),
                100 * relative_difference(before->theirs, now.theirs));
  std::printf("\n");
  std::fflush(stdout);
}

std::filesystem::path scratch() {
  return std::filesystem::temp_directory_path() / "ashlar_crosscheck";
}

void print_dam(const std::vector<std::string>& words) {
  std::vector<int> sizes;
  for (const std::string& word : words) sizes.push_back(std::stoi(word));
  if (sizes.empty()) sizes = {500, 2000, 8000, 20000};
  std::optional<Comparison> before;
  for (const int cells : sizes) {
    Comparison now = compare_dam(cells, scratch());
    print_table(now, before);
    print_summary(now, before);
    before = std::move(now);
  }
}

void draw_hertz(const std::string& file) {
  std::ofstream(file, std::ios::binary) << hertz_picture();
}

}  // namespace

int main(int count, char** words) {
  try {
    const std::vector<std::string> said(words + 1, words + count);
    if (said.size() == 2 && said[0] == "hertz")
      write_reference(std::cout, compute_reference(std::stod(said[1]), scratch()), std::stod(said[1]));
    else if (said.size() == 2 && said[0] == "hertz_picture")
      draw_hertz(said[1]);
    else
      print_dam(said);
    return 0;
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "crosscheck: %s\n", problem.what());
    return 1;
  }
}
