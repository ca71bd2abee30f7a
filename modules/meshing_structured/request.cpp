#include "meshing_structured/request.hpp"

namespace ashlar::meshing_structured {

namespace {

using core::Mistakes;
using core::Settings;

// What `said` says takes the place of what stood in the request before.
void read(const Settings& said, Request& request) {
  if (said.has("size")) {
    request.size = said.number("size");
    request.cells = {0, 0};
  }
  if (said.has("cells")) {
    const auto [columns, rows] = said.point("cells");
    request.cells = {static_cast<int>(columns), static_cast<int>(rows)};
    request.size = 0;
  }
  if (!said.has("grading")) return;
  if (said.value("grading").quantity()) {
    request.grading.fill(said.number("grading"));
  } else {
    const auto [along_x, along_y] = said.point("grading");
    request.grading = {along_x, along_y};
  }
}

}  // namespace

std::vector<Request> requests(const Settings& settings, const std::vector<std::string>& regions) {
  Mistakes mistakes;
  Request common;
  read(settings, common);
  std::vector<Request> result(regions.size(), common);
  for (std::size_t r = 0; r < regions.size(); ++r) {
    for (const auto& [name, said] : settings.objects("regions"))
      if (name == regions[r]) read(said, result[r]);
    if (result[r].cells[0] > 0 || result[r].size > 0) continue;
    mistakes.add(settings.place, "region '" + regions[r] + "' has no cells and no size",
                 "size = 0.5 or cells = {nx, ny}");
  }
  mistakes.throw_if_any();
  return result;
}

}  // namespace ashlar::meshing_structured
