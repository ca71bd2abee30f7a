#include "meshing_structured/request.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::meshing_structured {

namespace {

using core::Mistakes;
using core::Value;

constexpr double most_cells = 1e5;

// Two numbers {a, b}, or one for both if `single` allows it.
std::array<double, 2> pair_of(const Value& value, bool single, const std::string& what, Mistakes& mistakes) {
  if (single && value.quantity()) return {value.quantity()->value, value.quantity()->value};
  const core::Table* table = value.table();
  if (table && table->items.size() == 2 && table->entries.empty() && table->items[0].quantity() &&
      table->items[1].quantity()) {
    return {table->items[0].quantity()->value, table->items[1].quantity()->value};
  }
  mistakes.add(value.place, what + " must be two numbers, got " + value.type_name());
  return {1, 1};
}

void read_cells(const Value& value, Request& request, Mistakes& mistakes) {
  const auto cells = pair_of(value, false, "cells", mistakes);
  for (int k = 0; k < 2; ++k) {
    if (cells[k] >= 1 && cells[k] <= most_cells && cells[k] == std::floor(cells[k])) {
      request.cells[k] = static_cast<int>(cells[k]);
    } else {
      mistakes.add(value.place, "cells must be whole numbers from 1 to 100000");
    }
  }
  request.size = 0;
}

void read_size(const Value& value, Request& request, Mistakes& mistakes) {
  const auto size = core::read_number(value, core::Dimension{1, 0, 0}, mistakes);
  if (!size) return;
  if (!(*size > 0)) mistakes.add(value.place, "size must be above 0 m");
  request.size = *size;
  request.cells = {0, 0};
}

void read_grading(const Value& value, Request& request, Mistakes& mistakes) {
  request.grading = pair_of(value, true, "grading", mistakes);
  for (const double g : request.grading) {
    if (!(g >= 1e-4 && g <= 1e4)) mistakes.add(value.place, "grading must be from 0.0001 to 10000");
  }
}

void read_region(const Value& value, Request& request, Mistakes& mistakes) {
  if (!value.table()) {
    mistakes.add(value.place, "a region's settings must be a table, got " + value.type_name());
    return;
  }
  for (const auto& [key, entry] : value.table()->entries) {
    if (key == "cells")
      read_cells(entry, request, mistakes);
    else if (key == "size")
      read_size(entry, request, mistakes);
    else if (key == "grading")
      read_grading(entry, request, mistakes);
    else
      mistakes.add(entry.place, "unknown key '" + key + "'",
                   core::did_you_mean(key, {"cells", "size", "grading"}));
  }
}

}  // namespace

std::vector<Request> requests(const core::Settings& settings, const std::vector<std::string>& regions) {
  Mistakes mistakes;
  Request common;
  if (settings.has("cells") && settings.has("size")) {
    mistakes.add(settings.place_of("size"), "give cells or size, not both");
  }
  if (settings.has("size")) read_size(settings.value("size"), common, mistakes);
  if (settings.has("cells")) read_cells(settings.value("cells"), common, mistakes);
  if (settings.has("grading")) read_grading(settings.value("grading"), common, mistakes);
  std::vector<Request> result(regions.size(), common);
  if (settings.has("regions")) {
    for (const auto& [name, value] : settings.value("regions").table()->entries) {
      const auto found = std::find(regions.begin(), regions.end(), name);
      if (found == regions.end()) {
        mistakes.add(value.place, "there is no region '" + name + "'", core::did_you_mean(name, regions));
      } else {
        read_region(value, result[found - regions.begin()], mistakes);
      }
    }
  }
  mistakes.throw_if_any();
  for (std::size_t r = 0; r < regions.size(); ++r) {
    if (result[r].cells[0] > 0 || result[r].size > 0) continue;
    mistakes.add(settings.place, "region '" + regions[r] + "' has no cells and no size",
                 "size = 0.5 or cells = {nx, ny}");
  }
  mistakes.throw_if_any();
  return result;
}

}  // namespace ashlar::meshing_structured
