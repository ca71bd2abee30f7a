#pragma once
// The pressure of examples/hertz by CalculiX alone: its own mesh, elements and solution.

#include <filesystem>

#include "crosscheck/hertz_profile.hpp"

namespace ashlar::test {

struct HertzReference {
  Profile profile;
  double force = 0;  ///< Σ of the pairs' forces [N]
};

/// Eight-node elements in plane strain on rings `spacing` apart [m]; `ccx` runs in `folder`. Closed pairs are
/// joined by equations u_disc − u_block = −gap; their set begins with those nearer than `first_guess` [m] and
/// is iterated until none pulls and none overlaps. Throws runtime_error if it does not settle or CalculiX
/// gives no result.
HertzReference compute_hertz(Loading loading, double spacing, const std::filesystem::path& folder,
                             double first_guess = 1.5);

/// Both loadings.
Profiles compute_reference(double spacing, const std::filesystem::path& folder);

}  // namespace ashlar::test
