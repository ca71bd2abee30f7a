#include "loads/edge_values.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace ashlar::loads {

namespace {

using geometry::Point;

const core::Dimension metre{1, 0, 0};

std::string at_text(Point p) {
  return "(" + core::format_quantity(p.x, {}) + ", " + core::format_quantity(p.y, {}) + ")";
}

constexpr core::Dimension pascal{-1, 1, -2};

/// A number, or a function called at points; nothing counts as 0.
class PointValue {
 public:
  explicit PointValue(const core::Value& value) : place_(value.place), function_(value.function()) {
    if (const core::Quantity* number = value.quantity()) constant_ = number->value;
  }
  int degree() const { return function_ ? function_degree : 0; }
  double operator()(Point p) const {
    if (!function_) return constant_;
    const double arguments[] = {p.x, p.y};
    const double value = function_->number(arguments, pascal);
    if (std::isfinite(value)) return value;
    throw core::InputError(core::Mistake{
        place_, "the function must return a finite number, but it is not finite at " + at_text(p), {}});
  }

 private:
  core::Place place_;
  std::shared_ptr<const core::Function> function_;
  double constant_ = 0;
};

}  // namespace

bool Table::holds(double height) const {
  const double slack = 1e-9 * (y.back() - y.front());
  return height >= y.front() - slack && height <= y.back() + slack;
}

double Table::at(double height) const {
  assert(holds(height));
  const auto above = std::upper_bound(y.begin() + 1, y.end() - 1, height);
  const std::size_t i = above - y.begin();
  const double t = std::clamp((height - y[i - 1]) / (y[i] - y[i - 1]), 0.0, 1.0);
  return (1 - t) * p[i - 1] + t * p[i];
}

Table read_table(const core::Value& value, core::Mistakes& mistakes) {
  Table table;
  table.place = value.place;
  for (const core::Value& item : value.table()->items) {
    const core::Table* row = item.table();
    if (!row || row->items.size() != 2 || !row->entries.empty()) {
      mistakes.add(item.place, "must be a row {y, p}: height and pressure");
      continue;
    }
    const auto y = core::read_number(row->items[0], metre, mistakes);
    const auto p = core::read_number(row->items[1], core::parse_dimension("Pa"), mistakes);
    if (!y || !p) continue;
    if (!table.y.empty() && *y <= table.y.back())
      mistakes.add(item.place, "heights must ascend: " + core::format_quantity(*y, metre) + " comes after " +
                                   core::format_quantity(table.y.back(), metre));
    table.y.push_back(*y);
    table.p.push_back(*p);
  }
  if (value.table()->items.size() < 2)
    mistakes.add(value.place, "a table of pressures needs at least two rows {y, p}");
  return table;
}

model::EdgeTraction traction(const core::Settings& components) {
  const PointValue x(components.value("x")), y(components.value("y"));
  return {[=](Point at, Point) { return Point{x(at), y(at)}; }, std::max(x.degree(), y.degree()), {}};
}

model::EdgeTraction pressure(const core::Value& value) {
  if (value.table()) {
    core::Mistakes mistakes;
    const Table table = read_table(value, mistakes);
    mistakes.throw_if_any();
    return {[=](Point at, Point outward) { return -table.at(at.y) * outward; }, 1, table.y};
  }
  const PointValue p(value);
  return {[=](Point at, Point outward) { return -p(at) * outward; }, p.degree(), {}};
}

}  // namespace ashlar::loads
