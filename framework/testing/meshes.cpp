#include "testing/meshes.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <random>

#include "geometry/polygon.hpp"

namespace ashlar::testing {

namespace {

using geometry::Index;
using geometry::Point;
using geometry::Ring;

// Cells from their corners' coordinates; equal corners (to 1e-11) are one point.
class Collector {
 public:
  void add(const Ring& corners) {
    std::vector<Index> cell;
    for (const Point p : corners) cell.push_back(number(p));
    raw_.cell_points.append(cell);
    raw_.cell_region.push_back(0);
  }
  mesh::RawMesh take() { return std::move(raw_); }

 private:
  Index number(Point p) {
    const long long x = std::llround(p.x * 1e11), y = std::llround(p.y * 1e11);
    for (const long long i : {x, x - 1, x + 1}) {
      for (const long long j : {y, y - 1, y + 1}) {
        if (const auto found = numbers_.find({i, j}); found != numbers_.end()) return found->second;
      }
    }
    raw_.points.push_back(p);
    return numbers_[{x, y}] = static_cast<Index>(raw_.points.size()) - 1;
  }
  mesh::RawMesh raw_;
  std::map<std::pair<long long, long long>, Index> numbers_;
};

// n × n quadrilaterals whose points are mapped by `place(i, j)`.
template <class Place>
mesh::RawMesh quadrilaterals(int n, Place place) {
  mesh::RawMesh raw;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) raw.points.push_back(place(i, j));
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const Index p = j * (n + 1) + i;
      raw.cell_points.append(std::array<Index, 4>{p, p + 1, p + n + 2, p + n + 1});
      raw.cell_region.push_back(0);
    }
  }
  return raw;
}

Point grid(int i, int j, int n) {
  return {static_cast<double>(i) / n, static_cast<double>(j) / n};
}

// The part of a convex ring where x (or y) is not below (or above) the limit; cut points lie on it exactly.
Ring clipped(const Ring& ring, double Point::*axis, double limit, double sense) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const double u = sense * (a.*axis - limit), v = sense * (b.*axis - limit);
    if (u >= 0) result.push_back(a);
    if (u * v >= 0) continue;
    Point cut = a + (u / (u - v)) * (b - a);
    cut.*axis = limit;
    result.push_back(cut);
  }
  return result;
}

}  // namespace

mesh::RawMesh structured_square(int n) {
  return quadrilaterals(n, [n](int i, int j) { return grid(i, j, n); });
}

mesh::RawMesh distorted_square(int n, double amount, unsigned seed) {
  std::mt19937 random(seed);
  auto shift = [&] { return amount / n * (2.0 * static_cast<double>(random()) / 4294967295.0 - 1.0); };
  return quadrilaterals(n, [&](int i, int j) {
    const bool inner = i > 0 && i < n && j > 0 && j < n;
    const double dx = shift(), dy = shift();
    return inner ? grid(i, j, n) + Point{dx, dy} : grid(i, j, n);
  });
}

mesh::RawMesh chevron_square(int n) {
  Collector cells;
  auto middle = [n](int i, int j) {
    return 0.5 * (grid(i, j, n) + grid(i + 1, j, n)) + Point{0, j > 0 && j < n ? 0.4 / n : 0};
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      cells.add({grid(i, j, n), middle(i, j), grid(i + 1, j, n), grid(i + 1, j + 1, n), middle(i, j + 1),
                 grid(i, j + 1, n)});
    }
  }
  return cells.take();
}

mesh::RawMesh pegboard_square(int n) {
  Collector cells;
  // The right side of column i−1, upwards; pegs reach a quarter of a cell into column i.
  auto side = [n](int i, int j) {
    const Point low = grid(i, j, n), up{0, 1.0 / n}, peg{i > 0 && i < n ? 0.25 / n : 0, 0};
    return Ring{low, low + (1.0 / 3) * up, low + (1.0 / 3) * up + peg, low + (2.0 / 3) * up + peg,
                low + (2.0 / 3) * up};
  };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      Ring ring = side(i + 1, j), left = side(i, j);
      ring.push_back(grid(i + 1, j + 1, n));
      ring.push_back(grid(i, j + 1, n));
      ring.insert(ring.end(), left.rbegin(), left.rend());
      // Outer sides have no peg: their points coincide in pairs.
      ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
      cells.add(ring);
    }
  }
  return cells.take();
}

mesh::RawMesh hanging_square(int n) {
  Collector cells;
  auto fine = [n](int i, int j) { return grid(i, j, 2 * n); };
  auto is_fine = [n](int i, int j) { return i >= 0 && i < n && j >= 0 && j < n && (i + j) % 2 == 0; };
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int x = 2 * i, y = 2 * j;
      if (is_fine(i, j)) {
        for (const auto& [a, b] : {std::pair{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}) {
          cells.add({fine(a, b), fine(a + 1, b), fine(a + 1, b + 1), fine(a, b + 1)});
        }
        continue;
      }
      Ring ring{fine(x, y)};
      if (is_fine(i, j - 1)) ring.push_back(fine(x + 1, y));
      ring.push_back(fine(x + 2, y));
      if (is_fine(i + 1, j)) ring.push_back(fine(x + 2, y + 1));
      ring.push_back(fine(x + 2, y + 2));
      if (is_fine(i, j + 1)) ring.push_back(fine(x + 1, y + 2));
      ring.push_back(fine(x, y + 2));
      if (is_fine(i - 1, j)) ring.push_back(fine(x, y + 1));
      cells.add(ring);
    }
  }
  return cells.take();
}

mesh::RawMesh short_edge_square(int n, double ratio) {
  mesh::RawMesh raw;
  const double half = 0.5 * std::sqrt(0.5) * ratio / n;
  std::vector<std::array<Index, 2>> pair;  // lower left and upper right point of each grid point
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool inner = i > 0 && i < n && j > 0 && j < n;
      const auto number = static_cast<Index>(raw.points.size());
      const Point p = grid(i, j, n);
      pair.push_back({number, inner ? number + 1 : number});
      raw.points.push_back(inner ? p - Point{half, half} : p);
      if (inner) raw.points.push_back(p + Point{half, half});
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto& sw = pair[j * (n + 1) + i];
      const auto& se = pair[j * (n + 1) + i + 1];
      const auto& ne = pair[(j + 1) * (n + 1) + i + 1];
      const auto& nw = pair[(j + 1) * (n + 1) + i];
      std::vector<Index> cell{sw[1], se[0], se[1], ne[0], nw[1], nw[0]};
      cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
      raw.cell_points.append(cell);
      raw.cell_region.push_back(0);
    }
  }
  return raw;
}

mesh::RawMesh collinear_square(int n) {
  Collector cells;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      Ring ring;
      const std::array<Point, 5> corners{grid(i, j, n), grid(i + 1, j, n), grid(i + 1, j + 1, n),
                                         grid(i, j + 1, n), grid(i, j, n)};
      for (int k = 0; k < 4; ++k) {
        const Point edge = corners[k + 1] - corners[k];
        ring.insert(ring.end(), {corners[k], corners[k] + 0.25 * edge, corners[k] + 0.75 * edge});
      }
      cells.add(ring);
    }
  }
  return cells.take();
}

mesh::RawMesh honeycomb_square(int n) {
  Collector cells;
  const double side = 1.0 / (1.5 * n), height = std::sqrt(3.0) * side;
  const Point shift{0.13 * side, 0.21 * side};  // no hexagon's corner falls on the border
  for (int i = -1; i <= n + 1; ++i) {
    for (int j = -1; j <= static_cast<int>(1 / height) + 2; ++j) {
      const Point center = shift + Point{1.5 * side * i, height * (j + (i % 2 != 0 ? 0.5 : 0.0))};
      Ring ring;
      for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3;
        ring.push_back(center + side * Point{std::cos(angle), std::sin(angle)});
      }
      ring = clipped(clipped(ring, &Point::x, 0, 1), &Point::x, 1, -1);
      ring = clipped(clipped(ring, &Point::y, 0, 1), &Point::y, 1, -1);
      if (ring.size() >= 3) cells.add(ring);
    }
  }
  return cells.take();
}

mesh::RawMesh kershaw_square(int n, double squeeze) {
  // y is squeezed toward the top or the bottom; along x one turns into the other and back.
  auto to_top = [squeeze](double y) { return y < 0.5 ? (2 - squeeze) * y : 1 - squeeze * (1 - y); };
  auto to_bottom = [squeeze](double y) { return y < 0.5 ? squeeze * y : 1 - (2 - squeeze) * (1 - y); };
  auto mixture = [](double x) {
    const double t = 6 * x;
    if (t <= 2) return std::max(0.0, t - 1);
    return t <= 4 ? 1 - 0.5 * (t - 2) : std::min(1.0, t - 4);
  };
  return quadrilaterals(n, [&](int i, int j) {
    const Point p = grid(i, j, n);
    const double w = mixture(p.x);
    return Point{p.x, (1 - w) * to_top(p.y) + w * to_bottom(p.y)};
  });
}

const std::vector<MeshFamily>& ugly_families() {
  static const std::vector<MeshFamily> families{
      {"structured", structured_square},
      {"distorted", [](int n) { return distorted_square(n); }},
      {"chevron", chevron_square},
      {"pegboard", pegboard_square},
      {"hanging", hanging_square},
      {"short_edge", [](int n) { return short_edge_square(n); }},
      {"collinear", collinear_square},
      {"honeycomb", honeycomb_square},
      {"kershaw", [](int n) { return kershaw_square(n); }},
  };
  return families;
}

mesh::Domain square_domain(const std::vector<mesh::JointLine>& joints) {
  geometry::Shape shape;
  shape.rings = {{{{0, 0}, "bottom", {}, {}},
                  {{1, 0}, "right", {}, {}},
                  {{1, 1}, "top", {}, {}},
                  {{0, 1}, "left", {}, {}}}};
  core::Mistakes mistakes;
  mesh::Domain domain = mesh::make_domain({{"square", shape, {}}}, joints, 1, mistakes);
  mistakes.throw_if_any();
  return domain;
}

mesh::Mesh square_mesh(mesh::RawMesh raw, const std::vector<mesh::JointLine>& joints) {
  return mesh::build_mesh(std::move(raw), square_domain(joints));
}

}  // namespace ashlar::testing
