#pragma once
// A page to draw on: thin lines, texts, images. One unit is 1/400 of the page's width; a page printed at
// column width (85 mm) has texts of 6 to 7 points. Included by pictures/*.cpp only.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "output/pictures/colors.hpp"
#include "output/pictures/raster.hpp"

// Cairo's own declaration; tests read this header without cairo's.
using cairo_t = struct _cairo;  // NOLINT

namespace ashlar::output {

constexpr double page_width = 400;       ///< units
constexpr double pixels_per_unit = 3.5;  ///< of PNG files, and of images inside SVG files

enum class Align { left, center, right };

struct TextStyle {
  double size = 8.5;
  Color color{0.13, 0.14, 0.16};
  Align align = Align::left;
  bool bold = false;
  bool halo = false;  ///< a white rim, for texts on colours
  double turn = 0;    ///< quarter turns counter-clockwise
};

struct LineStyle {
  Color color{0.13, 0.14, 0.16};
  double width = 0.6;
  double dash = 0;  ///< length of dashes and gaps; 0: a full line
  double opacity = 1;
};

struct Box {
  geometry::Point corner;  ///< upper left, in units
  double width = 0, height = 0;
};
/// Length that the boxes share in both directions; 0 if they do not overlap.
double overlap(const Box& a, const Box& b);

/// A text as it stands on a page: the box around its ink.
struct TextBox {
  std::string markup;
  Box box;
};

class Canvas {
 public:
  explicit Canvas(cairo_t* cairo);

  /// Baseline at y. "*x*" is set in italics, "u_{y}" with a subscript.
  void text(double x, double y, const std::string& markup, const TextStyle& style = {});
  double text_width(const std::string& markup, const TextStyle& style = {});
  /// All texts so far.
  const std::vector<TextBox>& texts() const { return texts_; }
  /// `markup`, cut short with "…" until it fits.
  std::string fitted(std::string markup, double width, const TextStyle& style = {});

  void polyline(std::span<const geometry::Point> points, const LineStyle& style = {}, bool closed = false);
  void line(geometry::Point a, geometry::Point b, const LineStyle& style = {});
  void fill(std::span<const geometry::Point> ring, Color color);
  void rectangle(geometry::Point corner, double width, double height, Color color);
  void disc(geometry::Point center, double radius, Color color, const LineStyle& rim);
  /// The image with its upper left corner at `corner`.
  void image(geometry::Point corner, const Image& image, double pixels_per_unit);
  /// Nothing drawn by `draw` leaves the rectangle.
  void clipped(geometry::Point corner, double width, double height, const std::function<void()>& draw);

 private:
  template <class Use>
  double each_run(const std::string& markup, const TextStyle& style, Use&& use);
  void trace(std::span<const geometry::Point> points, bool closed);
  void stroke(const LineStyle& style);
  void remember(double x, double y, const std::string& markup, const TextStyle& style);
  cairo_t* cairo_;
  std::vector<TextBox> texts_;
};

/// Width of a text before there is a page to set it on.
double measured(const std::string& markup, const TextStyle& style = {});

/// A page of `height` units drawn by `draw`, as the bytes of a PNG or SVG file.
std::string png_page(double height, const std::function<void(Canvas&)>& draw);
std::string svg_page(double height, const std::function<void(Canvas&)>& draw);
/// The texts that `draw` sets, and where.
std::vector<TextBox> page_texts(const std::function<void(Canvas&)>& draw);

}  // namespace ashlar::output
