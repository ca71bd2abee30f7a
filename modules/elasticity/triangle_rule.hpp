#pragma once
// Quadrature on triangles in area coordinates; weights sum to 1.

#include <array>

namespace ashlar::elasticity {

struct TrianglePoint {
  double a, b, weight;
};

/// Exact for degree 2: three inner points (Strang and Fix 1973).
inline constexpr std::array<TrianglePoint, 3> triangle_rule_2 = {
    {{1.0 / 6, 1.0 / 6, 1.0 / 3}, {2.0 / 3, 1.0 / 6, 1.0 / 3}, {1.0 / 6, 2.0 / 3, 1.0 / 3}}};

/// Exact for degree 4: six points (Dunavant, Int. J. Numer. Methods Engrg. 21, 1985).
inline constexpr std::array<TrianglePoint, 6> triangle_rule_4 = {{
    {0.445948490915965, 0.445948490915965, 0.223381589678011},
    {0.108103018168070, 0.445948490915965, 0.223381589678011},
    {0.445948490915965, 0.108103018168070, 0.223381589678011},
    {0.091576213509771, 0.091576213509771, 0.109951743655322},
    {0.816847572980459, 0.091576213509771, 0.109951743655322},
    {0.091576213509771, 0.816847572980459, 0.109951743655322},
}};

}  // namespace ashlar::elasticity
