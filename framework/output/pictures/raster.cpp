#include "output/pictures/raster.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/polygon.hpp"

namespace ashlar::output {

using geometry::Point;
using mesh::Index;

namespace {

struct Corner {
  Point p;  ///< pixels
  double value = 0;
};

/// Calls paint(row, begin, end) for the pixels whose centres lie in the triangle; shared edges once.
template <class Paint>
void scan(const Image& image, const Corner& a, const Corner& b, const Corner& c, Paint&& paint) {
  const double top = std::min({a.p.y, b.p.y, c.p.y}), bottom = std::max({a.p.y, b.p.y, c.p.y});
  const int first = std::max(0, static_cast<int>(std::ceil(top - 0.5)));
  const int last = std::min(image.height, static_cast<int>(std::ceil(bottom - 0.5)));
  const std::array<const Corner*, 3> corners = {&a, &b, &c};
  for (int row = first; row < last; ++row) {
    const double y = row + 0.5;
    double low = 1e300, high = -1e300;
    for (int i = 0; i < 3; ++i) {
      // Each edge from its upper end: both of its cells then find the same crossing.
      const Point& p = corners[i]->p;
      const Point& q = corners[(i + 1) % 3]->p;
      const Point& upper = p.y < q.y ? p : q;
      const Point& lower = p.y < q.y ? q : p;
      if (y < upper.y || y >= lower.y) continue;
      const double x = upper.x + (y - upper.y) / (lower.y - upper.y) * (lower.x - upper.x);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    const int begin = std::max(0, static_cast<int>(std::ceil(low - 0.5)));
    const int end = std::min(image.width, static_cast<int>(std::ceil(high - 0.5)));
    if (begin < end) paint(row, begin, end);
  }
}

/// Calls use(triangle) for triangles that fill a cell: about the mean of its corners if all lie round it.
template <class Use>
void each_triangle(std::span<const Corner> corners, Use&& use) {
  const std::size_t n = corners.size();
  if (n == 3) return use(corners[0], corners[1], corners[2]);
  Corner middle;
  for (const Corner& c : corners) {
    middle.p = middle.p + c.p;
    middle.value += c.value;
  }
  middle.p = (1.0 / static_cast<double>(n)) * middle.p;
  middle.value /= static_cast<double>(n);
  bool round = true;
  for (std::size_t i = 0; i < n && round; ++i)
    round = geometry::cross(corners[i].p - middle.p, corners[(i + 1) % n].p - middle.p) <= 1e-12;
  if (round) {
    for (std::size_t i = 0; i < n; ++i) use(middle, corners[i], corners[(i + 1) % n]);
    return;
  }
  // Rows count downward, so the ring turns the wrong way for the triangulation.
  geometry::Ring ring;
  for (const Corner& c : corners) ring.push_back({c.p.x, -c.p.y});
  for (const auto& t : geometry::triangulate(ring)) use(corners[t[0]], corners[t[1]], corners[t[2]]);
}

template <class Use>
void each_cell(const View& view, const Shape& shape, std::span<const double> values, Use&& use) {
  std::vector<Corner> corners;
  for (Index cell = 0; cell < shape.cells.size(); ++cell) {
    const auto ring = shape.cells[cell];
    const auto from = static_cast<std::size_t>(shape.cells.offsets()[cell]);
    corners.resize(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
      corners[i] = {view.pixel(shape.points[ring[i]]), values.empty() ? 0 : values[from + i]};
    use(cell, std::span<const Corner>(corners));
  }
}

std::uint32_t mix_packed(std::uint32_t a, std::uint32_t b, double share) {
  const auto weight = static_cast<std::uint32_t>(std::lround(256 * share));
  std::uint32_t result = 0;
  for (const int shift : {0, 8, 16, 24}) {
    const std::uint32_t x = (a >> shift) & 0xFF, y = (b >> shift) & 0xFF;
    result |= ((x * (256 - weight) + y * weight) >> 8) << shift;
  }
  return result | 0xFF000000u;
}

/// Colours pixels of one triangle, in which the band number is linear: at + x·(column − x0) + y·(row − y0).
class BandPainter {
 public:
  BandPainter(Image& image, const Bands& bands) : image_(image), bands_(bands) {
    for (const Color& c : bands.colors) {
      fill_.push_back(packed(c));
      line_.push_back(packed(mixed(c, Color{0, 0, 0}, 0.22)));
    }
  }

  void triangle(const Corner& a, const Corner& b, const Corner& c) {
    const Point ab = b.p - a.p, ac = c.p - a.p;
    const double area = geometry::cross(ab, ac);
    if (area == 0) return;
    const double vb = (b.value - a.value) / bands_.step, vc = (c.value - a.value) / bands_.step;
    const Point slope = {(vb * ac.y - vc * ab.y) / area, (vc * ab.x - vb * ac.x) / area};
    const double start = (a.value - bands_.first) / bands_.step;
    const double per_pixel = geometry::norm(slope);
    // Flat to round-off: no border of bands runs through it, even where it lies on one.
    if (per_pixel < 1e-7) {
      const int band = std::clamp(static_cast<int>(std::floor(start + 1e-6)), 0, bands_.count() - 1);
      scan(image_, a, b, c, [&](int row, int begin, int end) {
        std::uint32_t* pixel = &image_.pixels[static_cast<std::size_t>(row) * image_.width];
        std::fill(pixel + begin, pixel + end, fill_[band]);
      });
      return;
    }
    scan(image_, a, b, c, [&](int row, int begin, int end) {
      double v = start + slope.x * (begin + 0.5 - a.p.x) + slope.y * (row + 0.5 - a.p.y);
      std::uint32_t* pixel = &image_.pixels[static_cast<std::size_t>(row) * image_.width];
      for (int x = begin; x < end; ++x, v += slope.x) pixel[x] = color(v, per_pixel);
    });
  }

 private:
  std::uint32_t color(double v, double per_pixel) const {
    const int last = bands_.count() - 1;
    const int band = v <= 0 ? 0 : std::min(last, static_cast<int>(v));
    const double down = v - band, up = band + 1 - v;
    const double near = std::min(std::abs(down), std::abs(up));
    // Farther than a pixel from every border of bands: the common case.
    if (near >= per_pixel || v <= -per_pixel || v >= bands_.count() + per_pixel) return fill_[band];
    const bool lower = std::abs(down) < std::abs(up);
    const int other = std::clamp(lower ? band - 1 : band + 1, 0, last);
    if (other == band) return fill_[band];
    const double distance = near / per_pixel;  // in pixels, across the border
    const std::uint32_t smooth =
        distance < 0.5 ? mix_packed(fill_[other], fill_[band], 0.5 + distance) : fill_[band];
    return mix_packed(smooth, line_[band], 1 - distance);
  }

  Image& image_;
  const Bands& bands_;
  std::vector<std::uint32_t> fill_, line_;
};

}  // namespace

void fill_bands(Image& image, const View& view, const Shape& shape, std::span<const double> corner_values,
                const Bands& bands) {
  BandPainter painter(image, bands);
  each_cell(view, shape, corner_values, [&](Index, std::span<const Corner> corners) {
    each_triangle(corners,
                  [&](const Corner& a, const Corner& b, const Corner& c) { painter.triangle(a, b, c); });
  });
}

void fill_cells(Image& image, const View& view, const Shape& shape, std::span<const std::uint32_t> colors) {
  each_cell(view, shape, {}, [&](Index cell, std::span<const Corner> corners) {
    each_triangle(corners, [&](const Corner& a, const Corner& b, const Corner& c) {
      scan(image, a, b, c, [&](int row, int begin, int end) {
        std::fill_n(&image.pixels[static_cast<std::size_t>(row) * image.width + begin], end - begin,
                    colors[cell]);
      });
    });
  });
}

void draw_edges(Image& image, const View& view, std::span<const Point> points,
                std::span<const std::array<Index, 2>> edges, double width, double darkest) {
  std::vector<float> ink(image.pixels.size(), 0.0F);
  const auto strength = static_cast<float>(width);
  auto drop = [&](int x, int y, float amount) {
    if (x >= 0 && y >= 0 && x < image.width && y < image.height)
      ink[static_cast<std::size_t>(y) * image.width + x] += amount;
  };
  for (const auto& [from, to] : edges) {
    Point a = view.pixel(points[from]), b = view.pixel(points[to]);
    const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
    if (steep) {
      std::swap(a.x, a.y);
      std::swap(b.x, b.y);
    }
    if (a.x > b.x) std::swap(a, b);
    const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
    for (int x = static_cast<int>(std::floor(a.x)); x <= static_cast<int>(std::floor(b.x)); ++x) {
      // How much of this column the line covers, and how it shares between two rows.
      const auto part = static_cast<float>(std::min(b.x, x + 1.0) - std::max(a.x, static_cast<double>(x)));
      const double y = a.y + slope * (x + 0.5 - a.x) - 0.5;
      const int row = static_cast<int>(std::floor(y));
      const auto below = static_cast<float>(y - row);
      const float amount = strength * std::max(part, 0.0F);
      steep ? drop(row, x, amount * (1 - below)) : drop(x, row, amount * (1 - below));
      steep ? drop(row + 1, x, amount * below) : drop(x, row + 1, amount * below);
    }
  }
  constexpr std::uint32_t dark = 0xFF2A2E34u;
  for (std::size_t i = 0; i < ink.size(); ++i)
    if (ink[i] > 0.004F && image.pixels[i] != 0)
      image.pixels[i] = mix_packed(image.pixels[i], dark, darkest * (1 - std::exp(-ink[i] / darkest)));
}

}  // namespace ashlar::output
