#include "meshing_structured/structured.hpp"

#include <algorithm>

#include "core/registry.hpp"
#include "geometry/polygon.hpp"
#include "meshing_structured/request.hpp"
#include "meshing_structured/sides.hpp"

namespace ashlar::meshing_structured {

namespace {

constexpr double most_cells = 2e7;

// Shares 0 … 1 of n divisions in geometric series; the last is `ratio` times the first.
std::vector<double> shares(int n, double ratio) {
  std::vector<double> at(static_cast<std::size_t>(n) + 1, 0.0);
  const double growth = n > 1 ? std::pow(ratio, 1.0 / (n - 1)) : 1.0;
  double sum = 0;
  for (int i = 1; i <= n; ++i) at[i] = sum += ratio == 1 ? 1.0 : std::pow(growth, i - 1);
  for (double& x : at) x /= sum;
  return at;
}

int divisions(const Side& a, const Side& b, const Request& request, int axis) {
  if (request.cells[axis] > 0) return request.cells[axis];
  return static_cast<int>(std::clamp(std::round(std::max(a.length, b.length) / request.size), 1.0, 1e5));
}

struct Block {
  Index region = -1;
  Sides sides;
  std::vector<SidePoint> bottom, right, top, left;
  int columns() const { return static_cast<int>(bottom.size()) - 1; }
  int rows() const { return static_cast<int>(left.size()) - 1; }
};

class Filler {
 public:
  Filler(mesh::RawMesh& raw, BorderPoints& border, const mesh::Domain& domain, const core::Place& place)
      : raw_(raw), border_(border), domain_(domain), place_(place) {}

  void fill(const Block& block) {
    number_points(block);
    const int nx = block.columns(), ny = block.rows();
    const auto bottom = border_.all_on(block.sides.bottom), top = border_.all_on(block.sides.top);
    const auto left = border_.all_on(block.sides.left), right = border_.all_on(block.sides.right);
    std::vector<Index> cell;
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        cell = {at(i, j)};
        if (j == 0) append(bottom, block.bottom[i], block.bottom[i + 1], cell, false);
        cell.push_back(at(i + 1, j));
        if (i == nx - 1) append(right, block.right[j], block.right[j + 1], cell, false);
        cell.push_back(at(i + 1, j + 1));
        if (j == ny - 1) append(top, block.top[i], block.top[i + 1], cell, true);
        cell.push_back(at(i, j + 1));
        if (i == 0) append(left, block.left[j], block.left[j + 1], cell, true);
        add_cell(cell, block.region);
      }
    }
  }

 private:
  Index at(int i, int j) const { return numbers_[static_cast<std::size_t>(j) * stride_ + i]; }

  void number_points(const Block& block) {
    const int nx = block.columns(), ny = block.rows();
    stride_ = nx + 1;
    numbers_.assign(static_cast<std::size_t>(nx + 1) * (ny + 1), -1);
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        Index& number = numbers_[static_cast<std::size_t>(j) * stride_ + i];
        if (j == 0)
          number = block.bottom[i].point;
        else if (j == ny)
          number = block.top[i].point;
        else if (i == 0)
          number = block.left[j].point;
        else if (i == nx)
          number = block.right[j].point;
        else {
          number = static_cast<Index>(raw_.points.size());
          raw_.points.push_back(transfinite(block, i, j));
        }
      }
    }
  }

  Point transfinite(const Block& block, int i, int j) const {
    const SidePoint &b = block.bottom[i], &t = block.top[i], &l = block.left[j], &r = block.right[j];
    const double du = t.at - b.at, dv = r.at - l.at;
    const double u = (b.at + l.at * du) / (1 - du * dv), v = l.at + u * dv;
    auto point = [&](const SidePoint& p) { return raw_.points[p.point]; };
    const Point sides = (1 - v) * point(b) + v * point(t) + (1 - u) * point(l) + u * point(r);
    const Point low = (1 - u) * point(block.bottom.front()) + u * point(block.bottom.back());
    const Point high = (1 - u) * point(block.top.front()) + u * point(block.top.back());
    return sides - (1 - v) * low - v * high;
  }

  // Points of the side strictly between two nodes, which the neighbour or a fixed corner has put there.
  static void append(const std::vector<SidePoint>& side, const SidePoint& from, const SidePoint& to,
                     std::vector<Index>& cell, bool backwards) {
    auto find = [&](Index p) {
      return std::find_if(side.begin(), side.end(), [p](const auto& q) { return q.point == p; });
    };
    std::vector<Index> between;
    for (auto p = find(from.point) + 1; p->point != to.point; ++p) between.push_back(p->point);
    if (backwards) std::reverse(between.begin(), between.end());
    cell.insert(cell.end(), between.begin(), between.end());
  }

  void add_cell(const std::vector<Index>& cell, Index region) {
    corners_.clear();
    for (const Index p : cell) corners_.push_back(raw_.points[p]);
    if (!(geometry::signed_area(corners_) > 0) || !geometry::is_simple(corners_)) {
      throw core::InputError(core::Mistake{
          place_,
          "the sides of region '" + domain_.regions[region] + "' are so curved that rows and columns cross",
          "use mesh.voronoi or mesh.gmsh, or divide the region"});
    }
    raw_.cell_points.append(cell);
    raw_.cell_region.push_back(region);
  }

  mesh::RawMesh& raw_;
  BorderPoints& border_;
  const mesh::Domain& domain_;
  core::Place place_;
  std::vector<Index> numbers_;
  std::size_t stride_ = 1;
  std::vector<Point> corners_;
};

}  // namespace

mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings) {
  if (domain.faces.empty()) {
    throw core::InputError(
        core::Mistake{settings.place, "there is no region to mesh", "give the scene a geometry"});
  }
  const auto wanted = requests(settings, domain.regions);
  core::Mistakes mistakes;
  std::vector<Block> blocks(domain.regions.size());
  double total = 0;
  for (std::size_t r = 0; r < blocks.size(); ++r) {
    try {
      blocks[r].sides = sides_of(domain, static_cast<Index>(r), settings.place);
    } catch (const core::InputError& error) {
      mistakes.add(error);
      continue;
    }
    const Sides& s = blocks[r].sides;
    total += static_cast<double>(divisions(s.bottom, s.top, wanted[r], 0)) *
             divisions(s.left, s.right, wanted[r], 1);
  }
  if (total > most_cells)
    mistakes.add(settings.place, "these settings ask for more than 20 million cells", "a larger size");
  mistakes.throw_if_any();

  mesh::RawMesh raw;
  BorderPoints border(domain, raw.points);
  for (std::size_t r = 0; r < blocks.size(); ++r) {
    Block& block = blocks[r];
    const Sides& s = block.sides;
    block.region = static_cast<Index>(r);
    const auto across = shares(divisions(s.bottom, s.top, wanted[r], 0), wanted[r].grading[0]);
    const auto up = shares(divisions(s.left, s.right, wanted[r], 1), wanted[r].grading[1]);
    block.bottom = border.divide(s.bottom, across);
    block.top = border.divide(s.top, across);
    block.left = border.divide(s.left, up);
    block.right = border.divide(s.right, up);
  }
  Filler filler(raw, border, domain, settings.place);
  for (const Block& block : blocks) filler.fill(block);
  return raw;
}

}  // namespace ashlar::meshing_structured

ASHLAR_MODULE(registry) {
  registry.add_make("mesh", "structured",
                    std::function<ashlar::mesh::GenerateMesh>(ashlar::meshing_structured::generate));
}
