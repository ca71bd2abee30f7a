#pragma once
// Pressure along the contact of examples/hertz: by Hertz's theory, by the stored reference, by Ashlar; and
// how far two of them lie apart.

#include <filesystem>
#include <iosfwd>
#include <map>

#include "crosscheck/hertz_mesh.hpp"
#include "support/scene_run.hpp"

namespace ashlar::test {

/// By rising x; straight between its points, zero beyond the last.
struct Profile {
  std::vector<double> x, p;  ///< [m], [Pa], of the undeformed block
  double at(double place) const;
  double peak() const;
  double force() const;  ///< ∫ p dx, of half the contact [N]
};
using Profiles = std::map<Loading, Profile>;

/// Hertz's half-width [m] and pressure [Pa] for two half-spaces: a = √(4FR/(πE*)), p = √(FE*/(πR)) √(1 −
/// (x/a)²).
double hertz_half_width();
double hertz_pressure(double x);

/// examples/hertz, and the reference that lies in it.
std::filesystem::path hertz_example();
Profiles stored_reference();
/// As stored_reference reads it; `spacing` of its rings [m].
void write_reference(std::ostream& out, const Profiles& profiles, double spacing);

/// Joint and mesh of one run of examples/hertz.
struct HertzRun {
  Profile profile;
  double max_pressure = 0;  ///< [Pa]
  mesh::Index cells = 0;
};
/// `cells`: 389, 600 or 1155, as the scene's parameter has it.
HertzRun run_hertz(Loading loading, int cells, int order);

/// Differences at the profile's own points, over the reference's peak.
struct Apart {
  double inner = 0;   ///< the greatest out to x = 1.1 m
  double inside = 0;  ///< out to 0.9 a
  double edge = 0;    ///< beyond
  double l2 = 0;      ///< √(∫ (p − p_ref)² / ∫ p_ref²), between the points too
};
Apart apart(const Profile& profile, const Profile& reference);

}  // namespace ashlar::test
