// Made-up runs whose limit, order, front and price are known by hand.

#include "study/numerics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ashlar::study {
namespace {

std::vector<Refined> runs_of(const std::vector<double>& sizes, double limit, double factor, double order) {
  std::vector<Refined> runs;
  for (const double h : sizes) runs.push_back({h, limit + factor * std::pow(h, order)});
  return runs;
}

TEST(extrapolation, finds_limit_and_order_of_three_runs) {
  const auto found = extrapolate(runs_of({1, 0.5, 0.25}, 2, 3, 1.5));
  EXPECT_NEAR(found.limit, 2, 1e-9);
  EXPECT_NEAR(found.order, 1.5, 1e-7);
  // 1.25 (limit − finest): 3 · 0.25^1.5 = 0.375
  EXPECT_NEAR(found.uncertainty, 1.25 * 0.375, 1e-7);
  EXPECT_TRUE(found.sound);
}

TEST(extrapolation, takes_any_ratio_any_order_of_runs_and_either_side) {
  const auto found = extrapolate(runs_of({0.1, 0.9, 0.31, 0.44, 0.2}, -1e-4, -2e-5, 0.9));
  EXPECT_NEAR(found.limit, -1e-4, 1e-12);
  EXPECT_NEAR(found.order, 0.9, 1e-5);
  EXPECT_TRUE(found.sound);
}

TEST(extrapolation, scatter_widens_the_bracket_and_the_truth_stays_in_it) {
  auto runs = runs_of({1, 0.7, 0.5, 0.35, 0.25}, 10, 1, 1);
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].value += i % 2 == 0 ? 0.01 : -0.01;
  const auto found = extrapolate(runs);
  EXPECT_TRUE(found.sound);
  EXPECT_GT(found.uncertainty, 1.25 * std::abs(found.limit - runs.back().value));
  EXPECT_LT(std::abs(found.limit - 10), found.uncertainty);
}

TEST(extrapolation, says_so_where_runs_come_from_both_sides) {
  const auto found = extrapolate(std::vector<Refined>{{1, 1}, {0.5, 2}, {0.25, 1.5}});
  EXPECT_FALSE(found.sound);
  EXPECT_TRUE(std::isnan(found.order));
  EXPECT_EQ(found.limit, 1.5);
  EXPECT_EQ(found.uncertainty, 3);
  EXPECT_NE(found.why.find("one side"), std::string::npos);
}

TEST(extrapolation, is_wide_where_there_is_no_limit_or_an_order_that_no_method_has) {
  const auto none = extrapolate(std::vector<Refined>{{1, 0}, {0.5, 1}, {0.25, 3}});
  EXPECT_FALSE(none.sound);
  EXPECT_EQ(none.uncertainty, 9);
  const auto strange = extrapolate(runs_of({1, 0.8, 0.6}, 1, 1, 8));
  EXPECT_FALSE(strange.sound);
  EXPECT_NEAR(strange.order, 8, 1e-4);
  EXPECT_NEAR(strange.uncertainty, 3 * std::pow(0.6, 8), 1e-7);
}

TEST(extrapolation, needs_three_sizes_and_knows_equal_runs) {
  EXPECT_FALSE(extrapolate(std::vector<Refined>{{1, 1}, {0.5, 2}}).sound);
  EXPECT_FALSE(extrapolate(std::vector<Refined>{{1, 1}, {0.5, 2}, {0.5, 2}}).sound);
  const auto equal = extrapolate(std::vector<Refined>{{1, 5}, {0.5, 5}, {0.25, 5}});
  EXPECT_TRUE(equal.sound);
  EXPECT_EQ(equal.limit, 5);
  EXPECT_EQ(equal.uncertainty, 0);
}

TEST(slopes, are_those_of_powers) {
  std::vector<std::pair<double, double>> points;
  for (const double x : {1.0, 3.0, 10.0, 47.0}) points.emplace_back(x, 7 * std::pow(x, -0.75));
  EXPECT_NEAR(slope(points), -0.75, 1e-12);
  EXPECT_TRUE(std::isnan(slope(std::vector<std::pair<double, double>>{{2, 3}, {2, 4}})));
}

TEST(front, holds_what_no_other_run_beats) {
  const std::vector<Bargain> runs = {{5, 0.1}, {1, 1}, {2, 0.5}, {3, 0.7}, {5, 0.1}, {9, 0.2}, {2, 0.6}};
  EXPECT_EQ(pareto_front(runs), (std::vector<std::size_t>{1, 2, 0}));
  EXPECT_TRUE(pareto_front({}).empty());
}

TEST(prices, lie_on_the_front) {
  const std::vector<Bargain> front = {{1, 1e-1}, {10, 1e-3}};
  const Price between = price_of(front, 1e-2);
  EXPECT_EQ(between.known, Price::Known::between);
  EXPECT_NEAR(between.cost, std::sqrt(10.0), 1e-12);
  const Price cheap = price_of(front, 0.5);
  EXPECT_EQ(cheap.known, Price::Known::at_most);
  EXPECT_EQ(cheap.cost, 1);
  const Price beyond = price_of(front, 1e-4);
  EXPECT_EQ(beyond.known, Price::Known::beyond);
  EXPECT_NEAR(beyond.cost, 10 * std::sqrt(10.0), 1e-10);
  EXPECT_EQ(price_of(std::vector<Bargain>{{1, 0.1}}, 0.01).known, Price::Known::unknown);
  EXPECT_EQ(price_of({}, 0.01).known, Price::Known::unknown);
}

TEST(prices, next_power_of_ten) {
  EXPECT_NEAR(ten_above(0.011), 0.1, 1e-15);
  EXPECT_NEAR(ten_above(0.1), 0.1, 1e-15);
  EXPECT_NEAR(ten_above(3e-5), 1e-4, 1e-18);
}

}  // namespace
}  // namespace ashlar::study
