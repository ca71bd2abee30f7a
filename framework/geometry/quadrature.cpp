#include "geometry/quadrature.hpp"

#include <cassert>
#include <cmath>
#include <numbers>

namespace ashlar::geometry {

namespace {

constexpr int most_points = 20;

/// P_n(x) and P_n'(x) by Bonnet's recursion.
std::pair<double, double> legendre(int n, double x) {
  double before = 1, value = x;
  for (int k = 2; k <= n; ++k) {
    const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
    before = value;
    value = next;
  }
  return {value, n * (x * value - before) / (x * x - 1)};
}

Rule make_rule(int n) {
  if (n == 1) return {{0.5}, {1.0}};
  Rule rule{std::vector<double>(n), std::vector<double>(n)};
  for (int i = 0; i < n; ++i) {
    double x = -std::cos(std::numbers::pi * (i + 0.75) / (n + 0.5));
    // Newton doubles the digits each time: from three to all of them in four, one more to be sure.
    for (int step = 0; step < 5; ++step) {
      const auto [value, slope] = legendre(n, x);
      x -= value / slope;
    }
    const double slope = legendre(n, x).second;
    rule.at[i] = 0.5 * (1 + x);
    rule.weight[i] = 1 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace

const Rule& gauss_legendre(int degree) {
  static const std::vector<Rule> rules = [] {
    std::vector<Rule> list;
    for (int n = 1; n <= most_points; ++n) list.push_back(make_rule(n));
    return list;
  }();
  assert(degree >= 0 && degree < 2 * most_points);
  return rules[degree / 2];
}

}  // namespace ashlar::geometry
