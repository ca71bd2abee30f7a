#include "mesh/segment_points.hpp"

#include <algorithm>

#include "geometry/polygon.hpp"

namespace ashlar::mesh {

namespace {

// Bins over the domain's box; each lists the segments that pass through it or its neighbours.
class SegmentBins {
 public:
  SegmentBins(const Domain& domain, double tolerance) {
    low_ = high_ = domain.points.front();
    for (const Point p : domain.points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high_ = {std::max(high_.x, p.x), std::max(high_.y, p.y)};
    }
    constexpr int bins_along = 512;
    width_ = std::max(std::max(high_.x - low_.x, high_.y - low_.y) / bins_along, 4 * tolerance);
    columns_ = static_cast<int>((high_.x - low_.x) / width_) + 1;
    rows_ = static_cast<int>((high_.y - low_.y) / width_) + 1;
    bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (Index i = 0; i < static_cast<Index>(domain.segments.size()); ++i) add(domain, i);
  }

  const std::vector<Index>* at(Point p) const {
    const int column = static_cast<int>(std::floor((p.x - low_.x) / width_));
    const int row = static_cast<int>(std::floor((p.y - low_.y) / width_));
    // One bin beyond the box, so that points off it by rounding are not lost.
    if (column < -1 || row < -1 || column > columns_ || row > rows_) return nullptr;
    return &bins_[bin(std::clamp(column, 0, columns_ - 1), std::clamp(row, 0, rows_ - 1))];
  }

 private:
  std::size_t bin(int column, int row) const { return static_cast<std::size_t>(row) * columns_ + column; }

  void add(const Domain& domain, Index number) {
    const Point a = domain.points[domain.segments[number].from],
                b = domain.points[domain.segments[number].to];
    const int steps = static_cast<int>(geometry::distance(a, b) / (0.5 * width_)) + 1;
    for (int k = 0; k <= steps; ++k) {
      const Point p = a + (static_cast<double>(k) / steps) * (b - a);
      const int column = static_cast<int>((p.x - low_.x) / width_),
                row = static_cast<int>((p.y - low_.y) / width_);
      for (int i = std::max(column - 1, 0); i <= std::min(column + 1, columns_ - 1); ++i) {
        for (int j = std::max(row - 1, 0); j <= std::min(row + 1, rows_ - 1); ++j) {
          auto& list = bins_[bin(i, j)];
          if (list.empty() || list.back() != number) list.push_back(number);
        }
      }
    }
  }

  Point low_, high_;
  double width_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<Index>> bins_;
};

}  // namespace

std::vector<std::vector<PointOnSegment>> points_on_segments(const Domain& domain,
                                                            const std::vector<Point>& points,
                                                            double tolerance) {
  std::vector<std::vector<PointOnSegment>> result(domain.segments.size());
  if (domain.segments.empty()) return result;
  const SegmentBins bins(domain, tolerance);
  for (Index p = 0; p < static_cast<Index>(points.size()); ++p) {
    const auto* near = bins.at(points[p]);
    if (!near) continue;
    for (const Index s : *near) {
      const auto& segment = domain.segments[s];
      double t = 0;
      const double d = geometry::distance_to_segment(points[p], domain.points[segment.from],
                                                     domain.points[segment.to], &t);
      if (d <= tolerance) result[s].push_back({t, p});
    }
  }
  for (auto& list : result) {
    std::sort(list.begin(), list.end(),
              [](const auto& a, const auto& b) { return std::pair(a.t, a.point) < std::pair(b.t, b.point); });
  }
  return result;
}

}  // namespace ashlar::mesh
