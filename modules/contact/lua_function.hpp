#pragma once
// A function of the script inside a law: numbers in, one number out, its parameters as the last argument.

#include "core/schema.hpp"

namespace ashlar::contact {

/// Calls go one at a time, whatever the number of threads.
class LuaFunction {
 public:
  LuaFunction(std::shared_ptr<const core::Function> function, core::NumberTable parameters)
      : function_(std::move(function)), parameters_(std::move(parameters)) {}
  explicit operator bool() const { return function_ != nullptr; }
  /// Throws InputError with the function's place if it fails or returns no number.
  double operator()(std::initializer_list<double> arguments) const;
  /// The same of a function that remembers: a list of numbers before the parameters, and the next list after
  /// the result.
  double operator()(std::initializer_list<double> arguments, std::span<const double> state,
                    std::span<double> next) const;

 private:
  std::shared_ptr<const core::Function> function_;
  core::NumberTable parameters_;
};

/// Two places to take a difference between: `step` parts of `at`, or of `least` if that is more, to both
/// sides.
struct Neighbours {
  double left = 0, right = 0;
  double slope(double at_left, double at_right) const { return (at_right - at_left) / (right - left); }
};
Neighbours neighbours(double at, double least);

}  // namespace ashlar::contact
