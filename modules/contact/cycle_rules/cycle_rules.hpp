#pragma once

#include <algorithm>

#include "contact/parts.hpp"

namespace ashlar::contact {

/// The point whose status is wrong by the most energy.
class WorstPoint final : public CycleRule {
 public:
  std::size_t choose(std::span<const double> misfits) const override {
    return static_cast<std::size_t>(std::ranges::max_element(misfits) - misfits.begin());
  }
};

/// The first of them, whatever its misfit: with a symmetric matrix and no friction that ends (K. G. Murty,
/// Note on a Bard-type scheme for solving the complementarity problem, Opsearch 11, 1974).
class FirstPoint final : public CycleRule {
 public:
  std::size_t choose(std::span<const double> /*misfits*/) const override { return 0; }
};

}  // namespace ashlar::contact
