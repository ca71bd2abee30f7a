#pragma once
// Tractions and pressures as the scene gives them: numbers, functions of (x, y), tables over y.

#include "model/edge_load.hpp"

namespace ashlar::loads {

/// Degree up to which functions of (x, y) are integrated exactly along an edge.
constexpr int function_degree = 8;

/// A pressure over height: straight lines between rows.
struct Table {
  std::vector<double> y, p;  ///< y strictly ascending, at least two rows
  core::Place place;
  /// Inside the table, but for round-off (1e-9 of its height).
  bool holds(double height) const;
  /// For heights that it holds.
  double at(double height) const;
};

/// Reads { {y, p}, … }. Mistakes: a row that is no pair, fewer than two rows, y that does not ascend.
Table read_table(const core::Value& value, core::Mistakes& mistakes);

/// From `{ x = …, y = … }`. Functions that do not return one finite number throw InputError at their place.
model::EdgeTraction traction(const core::Settings& components);

/// From a number, function or (sound) table; acts against the outward normal.
model::EdgeTraction pressure(const core::Value& value);

}  // namespace ashlar::loads
