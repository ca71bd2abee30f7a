#include "study/numerics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ashlar::study {

namespace {

constexpr double least_order = 0.05, greatest_order = 12;
constexpr double sound_least = 0.5, sound_greatest = 4.5;
constexpr double sound_safety = 1.25, wide_safety = 3;
constexpr double round_off = 1e-12;

struct Fit {
  double limit = 0, factor = 0;
  double misfit = std::numeric_limits<double>::infinity();  ///< weighted sum of squares
};

// value = limit + factor h^order, for a given order.
Fit fit(std::span<const Refined> runs, double order) {
  double w = 0, wx = 0, wy = 0, wxx = 0, wxy = 0;
  const double finest = runs.back().h;
  for (const Refined& run : runs) {
    const double weight = finest / run.h, x = std::pow(run.h / finest, order),
                 y = run.value - runs.back().value;
    w += weight, wx += weight * x, wy += weight * y, wxx += weight * x * x, wxy += weight * x * y;
  }
  const double det = w * wxx - wx * wx;
  Fit found;
  if (!(det > 0)) return found;
  found.factor = (w * wxy - wx * wy) / det;
  found.limit = (wy - found.factor * wx) / w;
  found.misfit = 0;
  for (const Refined& run : runs) {
    const double r =
        run.value - runs.back().value - found.limit - found.factor * std::pow(run.h / finest, order);
    found.misfit += finest / run.h * r * r;
  }
  found.limit += runs.back().value;
  return found;
}

// Scan first: the misfit may have more than one hollow; then golden section.
double best_order(std::span<const Refined> runs) {
  constexpr int steps = 240;
  const double ratio = std::pow(greatest_order / least_order, 1.0 / steps);
  double best = least_order, least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double order = least_order * std::pow(ratio, i), misfit = fit(runs, order).misfit;
    if (misfit < least) best = order, least = misfit;
  }
  const double golden = (std::sqrt(5.0) - 1) / 2;
  double a = best / ratio, b = best * ratio;
  for (int i = 0; i < 80; ++i) {
    const double c = b - golden * (b - a), d = a + golden * (b - a);
    (fit(runs, c).misfit < fit(runs, d).misfit ? b : a) = fit(runs, c).misfit < fit(runs, d).misfit ? d : c;
  }
  return std::clamp((a + b) / 2, least_order, greatest_order);
}

// By falling h; runs of (nearly) the same h count once.
std::vector<Refined> by_size(std::span<const Refined> runs) {
  std::vector<Refined> sorted(runs.begin(), runs.end());
  std::ranges::sort(sorted, std::greater(), &Refined::h);
  const auto twins = [](const Refined& a, const Refined& b) { return a.h < 1.02 * b.h; };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), twins), sorted.end());
  return sorted;
}

Extrapolation wide(std::span<const Refined> runs, std::string why) {
  const auto last = runs.last(std::min<std::size_t>(3, runs.size()));
  const auto [low, high] = std::ranges::minmax(last, {}, &Refined::value);
  return {runs.back().value, std::numeric_limits<double>::quiet_NaN(), wide_safety * (high.value - low.value),
          false, std::move(why)};
}

bool monotone(std::span<const Refined> runs) {
  bool rises = true, falls = true;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    rises = rises && runs[i].value >= runs[i - 1].value;
    falls = falls && runs[i].value <= runs[i - 1].value;
  }
  return rises || falls;
}

}  // namespace

Extrapolation extrapolate(std::span<const Refined> all) {
  const std::vector<Refined> runs = by_size(all);
  if (runs.size() < 3)
    return runs.empty() ? Extrapolation{} : wide(runs, "three runs of different size are needed");
  const auto [low, high] = std::ranges::minmax(runs, {}, &Refined::value);
  const double scale = std::max(std::abs(low.value), std::abs(high.value)), spread = high.value - low.value;
  if (spread <= round_off * scale)
    return {runs.back().value, std::numeric_limits<double>::quiet_NaN(), spread, true,
            "all runs agree to round-off"};
  if (!monotone(runs)) return wide(runs, "the runs do not approach their limit from one side");
  const double order = best_order(runs);
  const Fit found = fit(runs, order);
  if (order <= 1.01 * least_order || order >= 0.99 * greatest_order)
    return wide(runs, "the runs show no order of convergence");
  const double spare = static_cast<double>(runs.size()) - 3;
  const double scatter = spare > 0 ? std::sqrt(found.misfit / spare) : 0;
  const bool sound = order >= sound_least && order <= sound_greatest;
  const double correction = std::abs(found.limit - runs.back().value);
  return {found.limit, order, (sound ? sound_safety : wide_safety) * correction + scatter, sound,
          sound ? "" : "the order is not one that the method has"};
}

double slope(std::span<const std::pair<double, double>> points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  const auto n = static_cast<double>(points.size());
  for (const auto& [px, py] : points) x += std::log(px) / n, y += std::log(py) / n;
  for (const auto& [px, py] : points) {
    const double dx = std::log(px) - x;
    xx += dx * dx, xy += dx * (std::log(py) - y);
  }
  return xx > 1e-9 ? xy / xx : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::size_t> pareto_front(std::span<const Bargain> runs) {
  std::vector<std::size_t> order(runs.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return std::pair(runs[i].cost, runs[i].error); });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || runs[i].error < runs[front.back()].error) front.push_back(i);
  return front;
}

Price price_of(std::span<const Bargain> front, double error) {
  if (front.empty()) return {};
  if (error >= front.front().error) return {front.front().cost, Price::Known::at_most, 0, 0};
  for (std::size_t i = 1; i < front.size(); ++i) {
    if (error < front[i].error) continue;
    const Bargain &a = front[i - 1], &b = front[i];
    // An error of zero has no logarithm: the run that has it is what it costs.
    if (b.error <= 0) return {b.cost, Price::Known::at_most, i, i};
    const double t = std::log(a.error / error) / std::log(a.error / b.error);
    return {a.cost * std::pow(b.cost / a.cost, t), Price::Known::between, i - 1, i};
  }
  const std::size_t last = front.size() - 1;
  std::vector<std::pair<double, double>> end;
  for (std::size_t i = last < 2 ? 0 : last - 2; i <= last; ++i)
    end.emplace_back(front[i].error, front[i].cost);
  const double steep = end.size() < 2 ? 0 : slope(end);
  if (!(steep < 0)) return {};
  return {front[last].cost * std::pow(error / front[last].error, steep), Price::Known::beyond, last, last};
}

double ten_above(double x) {
  return std::pow(10, std::ceil(std::log10(x) - 1e-9));
}

}  // namespace ashlar::study
