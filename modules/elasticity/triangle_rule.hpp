#pragma once
// Quadrature on triangles in area coordinates; weights sum to 1.

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/quadrature.hpp"

namespace ashlar::elasticity {

struct TrianglePoint {
  double a, b, weight;
};

/// Exact for degree 2: three inner points (Strang and Fix 1973).
inline constexpr std::array<TrianglePoint, 3> triangle_rule_2 = {
    {{1.0 / 6, 1.0 / 6, 1.0 / 3}, {2.0 / 3, 1.0 / 6, 1.0 / 3}, {1.0 / 6, 2.0 / 3, 1.0 / 3}}};

/// Orbits of symmetric rules: (a, a, 1 − 2a) has three points, (a, b, 1 − a − b) six.
struct ThreePoints {
  double a, weight;
};
struct SixPoints {
  double a, b, weight;
};

constexpr void add_orbit(ThreePoints o, auto& at) {
  const double rest = 1 - 2 * o.a;
  for (const auto& [a, b] : {std::pair{o.a, o.a}, {rest, o.a}, {o.a, rest}}) *at++ = {a, b, o.weight};
}
constexpr void add_orbit(SixPoints o, auto& at) {
  const double rest = 1 - o.a - o.b;
  for (const auto& [a, b] :
       {std::pair{o.a, o.b}, {o.b, o.a}, {o.a, rest}, {rest, o.a}, {o.b, rest}, {rest, o.b}})
    *at++ = {a, b, o.weight};
}

template <std::size_t count>
constexpr std::array<TrianglePoint, count> orbits(const auto&... each) {
  std::array<TrianglePoint, count> points{};
  auto at = points.begin();
  (add_orbit(each, at), ...);
  return points;
}

/// Exact for degree 4 and 6: six and twelve points (Dunavant, Int. J. Numer. Methods Engrg. 21, 1985).
inline constexpr auto triangle_rule_4 =
    orbits<6>(ThreePoints{0.44594849091596488632, 0.22338158967801146570},
              ThreePoints{0.09157621350977074346, 0.10995174365532186764});
inline constexpr auto triangle_rule_6 =
    orbits<12>(ThreePoints{0.24928674517091042129, 0.11678627572637936603},
               ThreePoints{0.06308901449150222834, 0.05084490637020681692},
               SixPoints{0.05314504984481694735, 0.31035245103378440542, 0.08285107561837357519});

/// 3, 6 or 12 points as above, or n² points that are exact for degree 2n − 2: Gauss–Legendre in a square that
/// is folded into the triangle (Duffy, SIAM J. Numer. Anal. 19, 1982).
inline std::vector<TrianglePoint> triangle_rule(int points) {
  if (points == 3) return {triangle_rule_2.begin(), triangle_rule_2.end()};
  if (points == 6) return {triangle_rule_4.begin(), triangle_rule_4.end()};
  if (points == 12) return {triangle_rule_6.begin(), triangle_rule_6.end()};
  const int n = static_cast<int>(std::lround(std::sqrt(points)));
  const geometry::Rule& rule = geometry::gauss_legendre(2 * n - 1);
  std::vector<TrianglePoint> folded;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto s = static_cast<std::size_t>(i), t = static_cast<std::size_t>(j);
      const double a = rule.at[s], rest = 1 - a;
      folded.push_back({a, rest * rule.at[t], 2 * rest * rule.weight[s] * rule.weight[t]});
    }
  return folded;
}

}  // namespace ashlar::elasticity
