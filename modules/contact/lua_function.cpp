#include "contact/lua_function.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>

namespace ashlar::contact {

namespace {

// The cube root of rounding balances it against curvature.
constexpr double step = 6e-6;

std::mutex& one_call_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace

double LuaFunction::operator()(std::initializer_list<double> arguments) const {
  static const std::vector<std::string> a_number = {""};
  std::vector<core::NumberTable> said;
  for (const double argument : arguments) said.push_back({a_number, {argument}});
  said.push_back(parameters_);
  std::array<core::NumberTable, 1> result = {{{a_number, {0.0}}}};
  const std::lock_guard lock(one_call_at_a_time());
  function_->call_tables(said, result);
  return result[0].values[0];
}

double LuaFunction::operator()(std::initializer_list<double> arguments, std::span<const double> state,
                               std::span<double> next) const {
  static const std::vector<std::string> a_number = {""};
  std::vector<core::NumberTable> said;
  for (const double argument : arguments) said.push_back({a_number, {argument}});
  said.push_back({{}, {state.begin(), state.end()}});
  said.push_back(parameters_);
  std::array<core::NumberTable, 2> results = {{{a_number, {0.0}}, {{}, {next.begin(), next.end()}}}};
  const std::lock_guard lock(one_call_at_a_time());
  function_->call_tables(said, results);
  std::ranges::copy(results[1].values, next.begin());
  return results[0].values[0];
}

Neighbours neighbours(double at, double least) {
  const double h = step * std::max(std::abs(at), least);
  return {at - h, at + h};
}

}  // namespace ashlar::contact
