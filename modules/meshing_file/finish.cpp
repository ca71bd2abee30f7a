#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon.hpp"
#include "mesh/edge_table.hpp"
#include "meshing_file/contents.hpp"

namespace ashlar::meshing_file {

namespace {

class Finisher {
 public:
  Finisher(Contents contents, const Cursor& cursor) : said_(std::move(contents)), cursor_(cursor) {}

  mesh::RawMesh run() {
    if (said_.cells.size() == 0) fail_file("there are no cells in it");
    check_points();
    merge_points();
    for (Index c = 0; c < said_.cells.size(); ++c) add_cell(c);
    for (const auto& [name, edges] : said_.edges) {
      for (const auto& [a, b] : edges) {
        if (number_[a] != number_[b]) raw_.edge_groups[name].push_back({number_[a], number_[b]});
      }
    }
    for (const auto& [name, points] : said_.point_groups) {
      for (const Index p : points) raw_.point_groups[name].push_back(number_[p]);
    }
    check_edges();
    raw_.notes.emplace_back("file", cursor_.file());
    if (turned_ > 0) raw_.notes.emplace_back("clockwise cells turned", std::to_string(turned_));
    const std::size_t merged = said_.points.size() - raw_.points.size();
    if (merged > 0) raw_.notes.emplace_back("equal points merged", std::to_string(merged));
    return std::move(raw_);
  }

 private:
  [[noreturn]] void fail_file(const std::string& what) const {
    core::Mistake mistake;
    mistake.place.file = cursor_.file();
    mistake.what = what;
    throw core::InputError(std::move(mistake));
  }

  void check_points() const {
    std::array<double, 3> low = said_.points.front(), high = low;
    for (std::size_t i = 0; i < said_.points.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const double x = said_.points[i][k];
        // Squares of coordinates must stay finite too.
        if (!std::isfinite(x) || std::abs(x) > 1e100)
          cursor_.fail_at(said_.point_at[i], "a point's coordinate is not a finite number");
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
      }
    }
    const double extent = std::hypot(high[0] - low[0], high[1] - low[1]);
    if (high[2] - low[2] > 1e-9 * extent)
      fail_file("the mesh is not plane: z must be the same for all points");
  }

  // Exactly equal points get one number, that of the first of them.
  void merge_points() {
    std::vector<Index> order(said_.points.size());
    std::iota(order.begin(), order.end(), 0);
    auto key = [this](Index i) { return std::tuple(said_.points[i][0], said_.points[i][1], i); };
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    std::vector<Index> first(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool same = k > 0 && said_.points[order[k]][0] == said_.points[order[k - 1]][0] &&
                        said_.points[order[k]][1] == said_.points[order[k - 1]][1];
      first[order[k]] = same ? first[order[k - 1]] : order[k];
    }
    number_.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (first[i] != static_cast<Index>(i)) {
        number_[i] = number_[first[i]];
        continue;
      }
      number_[i] = static_cast<Index>(raw_.points.size());
      raw_.points.push_back({said_.points[i][0], said_.points[i][1]});
    }
  }

  void add_cell(Index c) {
    std::vector<Index> cell;
    std::vector<Point> corners;
    for (const Index p : said_.cells[c]) {
      cell.push_back(number_[p]);
      corners.push_back(raw_.points[cell.back()]);
    }
    const std::size_t at = said_.cell_at[c];
    constexpr std::size_t most_corners = 1000;  // the test of simplicity grows with the square
    if (cell.size() > most_corners) cursor_.fail_at(at, "a cell has more than 1000 corners");
    if (cell.size() < 3) cursor_.fail_at(at, "a cell has fewer than three corners");
    const double area = geometry::signed_area(corners);
    if (area == 0 && cell.size() == 3) cursor_.fail_at(at, "a cell has no area");
    if (area == 0 || !geometry::is_simple(corners)) cursor_.fail_at(at, "a cell crosses or touches itself");
    if (area < 0) {
      std::reverse(cell.begin(), cell.end());
      ++turned_;
    }
    raw_.cell_points.append(cell);
    raw_.cell_region.push_back(region(said_.cell_group[c]));
  }

  Index region(const std::string& name) {
    const auto [entry, is_new] = regions_.emplace(name, static_cast<Index>(raw_.regions.size()));
    if (is_new) raw_.regions.push_back(name);
    return entry->second;
  }

  void check_edges() const {
    try {
      const mesh::EdgeTable table(raw_.cell_points, raw_.points);
      for (const auto& [name, edges] : raw_.edge_groups) {
        for (const auto& [a, b] : edges) {
          if (table.find(a, b) < 0) fail_file("group '" + name + "' has an edge that is no cell's edge");
        }
      }
    } catch (const core::InputError& error) {
      fail_file(error.mistakes().front().what);
    }
  }

  Contents said_;
  const Cursor& cursor_;
  mesh::RawMesh raw_;
  std::vector<Index> number_;
  std::map<std::string, Index> regions_;
  int turned_ = 0;
};

}  // namespace

mesh::RawMesh finish(Contents contents, const Cursor& cursor) {
  return Finisher(std::move(contents), cursor).run();
}

}  // namespace ashlar::meshing_file
