#include "output/pictures/labels.hpp"

#include <algorithm>
#include <cmath>

namespace ashlar::output {

using geometry::Point;

namespace {

constexpr double rim = 2;  ///< between a label and the plot's border

// Whether the line touches the box: its part within the box's slabs is not empty.
bool crosses(const Box& box, Point a, Point b) {
  double from = 0, to = 1;
  const auto cut = [&](double start, double change, double low, double high) {
    if (change == 0) return start >= low && start <= high;
    const double t = (low - start) / change, u = (high - start) / change;
    from = std::max(from, std::min(t, u));
    to = std::min(to, std::max(t, u));
    return true;
  };
  return cut(a.x, b.x - a.x, box.corner.x, box.corner.x + box.width) &&
         cut(a.y, b.y - a.y, box.corner.y, box.corner.y + box.height) && from <= to;
}

}  // namespace

Box Labels::inside(Point corner, double width, double height) const {
  const double right = frame_.corner.x + frame_.width - rim - width;
  const double bottom = frame_.corner.y + frame_.height - rim - height;
  return {{std::max(frame_.corner.x + rim, std::min(corner.x, right)),
           std::max(frame_.corner.y + rim, std::min(corner.y, bottom))},
          width,
          height};
}

// Share of the box that the field covers.
double Labels::covered(const Box& box) const {
  int count = 0, filled = 0;
  for (double y = 0; y <= 1; y += 0.25)
    for (double x = 0; x <= 1; x += 0.0625) {
      const double right = box.corner.x + x * box.width, down = box.corner.y + y * box.height;
      const int column = static_cast<int>((right - frame_.corner.x) * pixels_per_unit);
      const int row = static_cast<int>((down - frame_.corner.y) * pixels_per_unit);
      ++count;
      if (column < 0 || row < 0 || column >= image_.width || row >= image_.height) continue;
      filled += image_.pixels[static_cast<std::size_t>(row) * image_.width + column] != 0;
    }
  return static_cast<double>(filled) / count;
}

double Labels::cost(const Box& box) const {
  const double share = covered(box);
  double sum = 4 * share * (1 - share) + 0.15 * share;
  for (const Box& other : taken_) sum += overlap(box, other) > 0 ? 100 + overlap(box, other) : 0;
  for (const Box& other : shunned_) sum += overlap(box, other) > 0 ? 6 : 0;
  const bool crossed =
      std::any_of(lines_.begin(), lines_.end(), [&](const auto& l) { return crosses(box, l[0], l[1]); });
  return sum + (crossed ? 3 : 0);
}

Box Labels::place(const std::vector<Point>& corners, double width, double height) {
  Box best;
  double lowest = 1e300, bias = 0;
  for (const Point& corner : corners) {
    const Box box = inside(corner, width, height);
    // A label that had to be moved may lie over its own mark.
    const double here = cost(box) + 0.1 * geometry::distance(corner, box.corner) + bias;
    if (here < lowest) best = box;
    lowest = std::min(lowest, here);
    bias += 0.01;
  }
  taken_.push_back(best);
  return best;
}

Box Labels::beside(Point mark, double off, double width, double height) {
  const double right = mark.x + off, left = mark.x - off - width, middle = mark.y - height / 2;
  const double above = mark.y - off - height, below = mark.y + off;
  return place({{right, middle},
                {left, middle},
                {right - off + 4, above},
                {left + off - 4, above},
                {right - off + 4, below},
                {left + off - 4, below},
                {right, above - height - 1},
                {left, above - height - 1},
                {right, below + height + 1},
                {left, below + height + 1}},
               width, height);
}

Box Labels::near(Point wish, double width, double height) {
  const Point corner = wish - Point{width / 2, height / 2};
  std::vector<Point> corners = {corner};
  for (const double reach : {1.0, 2.0, 3.5, 5.0, 8.0, 12.0})
    for (int turn = 0; turn < 8; ++turn) {
      const double angle = 0.785398163397448 * turn;
      corners.push_back(corner + reach * Point{1.2 * height * std::cos(angle) + width * std::cos(angle) / 4,
                                               -1.2 * height * std::sin(angle)});
    }
  return place(corners, width, height);
}

}  // namespace ashlar::output
