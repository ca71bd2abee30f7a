#include "output/pictures/canvas.hpp"

#include <cairo-svg.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace ashlar::output {

using geometry::Point;

namespace {

void set_color(cairo_t* cairo, Color c, double opacity = 1) {
  cairo_set_source_rgba(cairo, c.r, c.g, c.b, opacity);
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void demand(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

// Pixels as cairo keeps them, to three bytes each as PNG wants them.
std::string png_of(const unsigned char* rows, int width, int height, std::size_t stride, bool alpha) {
  const std::size_t channels = alpha ? 4 : 3;
  std::string bytes(static_cast<std::size_t>(width) * height * channels, '\0');
  char* out = bytes.data();
  for (int y = 0; y < height; ++y) {
    const auto* row = reinterpret_cast<const std::uint32_t*>(rows + static_cast<std::size_t>(y) * stride);
    for (int x = 0; x < width; ++x) {
      *out++ = static_cast<char>(row[x] >> 16);
      *out++ = static_cast<char>(row[x] >> 8);
      *out++ = static_cast<char>(row[x]);
      if (alpha) *out++ = static_cast<char>(row[x] >> 24);
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = alpha ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
  // Flat bands of colour pack well without searching; the search costs more than all the drawing.
  image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string file(size, '\0');
  if (!png_image_write_to_memory(&image, file.data(), &size, 0, bytes.data(), 0, nullptr))
    throw std::runtime_error(std::string("libpng: ") + image.message);
  file.resize(size);
  return file;
}

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

// One pixel, for measuring.
Surface speck() {
  return {cairo_image_surface_create(CAIRO_FORMAT_RGB24, 1, 1), cairo_surface_destroy};
}

}  // namespace

double overlap(const Box& a, const Box& b) {
  const double x = std::min(a.corner.x + a.width, b.corner.x + b.width) - std::max(a.corner.x, b.corner.x);
  const double y = std::min(a.corner.y + a.height, b.corner.y + b.height) - std::max(a.corner.y, b.corner.y);
  return std::max(0.0, std::min(x, y));
}

double measured(const std::string& markup, const TextStyle& style) {
  const Surface surface = speck();
  const Context cairo(cairo_create(surface.get()), cairo_destroy);
  return Canvas(cairo.get()).text_width(markup, style);
}

std::vector<TextBox> page_texts(const std::function<void(Canvas&)>& draw) {
  const Surface surface = speck();
  const Context cairo(cairo_create(surface.get()), cairo_destroy);
  Canvas canvas(cairo.get());
  draw(canvas);
  return canvas.texts();
}

Canvas::Canvas(cairo_t* cairo) : cairo_(cairo) {
  cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
}

// Runs of one style: use(text, size, drop) draws or measures and returns the run's width.
template <class Use>
double Canvas::each_run(const std::string& markup, const TextStyle& style, Use&& use) {
  double width = 0;
  bool italic = false, below = false;
  std::string run;
  auto flush = [&] {
    if (run.empty()) return;
    cairo_select_font_face(cairo_, "DejaVu Sans", italic ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
                           style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, below ? 0.72 * style.size : style.size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, run.c_str(), &extents);
    use(run, width, below ? 0.22 * style.size : 0.0);
    width += extents.x_advance;
    run.clear();
  };
  for (std::size_t i = 0; i < markup.size(); ++i) {
    if (markup[i] == '*') {
      flush();
      italic = !italic;
    } else if (markup.compare(i, 2, "_{") == 0) {
      flush();
      below = true;
      ++i;
    } else if (markup[i] == '}' && below) {
      flush();
      below = false;
    } else {
      run += markup[i];
    }
  }
  flush();
  return width;
}

double Canvas::text_width(const std::string& markup, const TextStyle& style) {
  return each_run(markup, style, [](const std::string&, double, double) {});
}

void Canvas::text(double x, double y, const std::string& markup, const TextStyle& style) {
  const double width = style.align == Align::left ? 0 : text_width(markup, style);
  cairo_save(cairo_);
  cairo_translate(cairo_, x, y);
  cairo_rotate(cairo_, -style.turn * std::numbers::pi / 2);
  cairo_translate(cairo_,
                  style.align == Align::right    ? -width
                  : style.align == Align::center ? -width / 2
                                                 : 0,
                  0);
  if (style.halo) {
    set_color(cairo_, {1, 1, 1}, 0.85);
    cairo_set_line_width(cairo_, 0.32 * style.size);
    each_run(markup, style, [this](const std::string& run, double at, double drop) {
      cairo_move_to(cairo_, at, drop);
      cairo_text_path(cairo_, run.c_str());
      cairo_stroke(cairo_);
    });
  }
  set_color(cairo_, style.color);
  each_run(markup, style, [this](const std::string& run, double at, double drop) {
    cairo_move_to(cairo_, at, drop);
    cairo_show_text(cairo_, run.c_str());
  });
  cairo_restore(cairo_);
  remember(x, y, markup, style);
}

void Canvas::remember(double x, double y, const std::string& markup, const TextStyle& style) {
  double top = 0, bottom = 0;
  const double width = each_run(markup, style, [&](const std::string& run, double, double drop) {
    cairo_text_extents_t ink;
    cairo_text_extents(cairo_, run.c_str(), &ink);
    top = std::min(top, drop + ink.y_bearing);
    bottom = std::max(bottom, drop + ink.y_bearing + ink.height);
  });
  const double from = style.align == Align::right ? -width : style.align == Align::center ? -width / 2 : 0;
  // A quarter turn counter-clockwise takes (x, y) to (y, −x).
  const bool turned = std::lround(style.turn) % 2 != 0;
  texts_.push_back({markup, turned ? Box{{x + top, y - from - width}, bottom - top, width}
                                   : Box{{x + from, y + top}, width, bottom - top}});
}

std::string Canvas::fitted(std::string markup, double width, const TextStyle& style) {
  if (text_width(markup, style) <= width) return markup;
  while (!markup.empty() && text_width(markup + "…", style) > width) {
    // Whole UTF-8 characters go.
    while (!markup.empty() && (markup.back() & 0xC0) == 0x80) markup.pop_back();
    if (!markup.empty()) markup.pop_back();
  }
  return markup + "…";
}

void Canvas::trace(std::span<const Point> points, bool closed) {
  for (std::size_t i = 0; i < points.size(); ++i)
    i == 0 ? cairo_move_to(cairo_, points[i].x, points[i].y)
           : cairo_line_to(cairo_, points[i].x, points[i].y);
  if (closed) cairo_close_path(cairo_);
}

void Canvas::stroke(const LineStyle& style) {
  set_color(cairo_, style.color, style.opacity);
  cairo_set_line_width(cairo_, style.width);
  cairo_set_dash(cairo_, &style.dash, style.dash > 0 ? 1 : 0, 0);
  cairo_stroke(cairo_);
}

void Canvas::polyline(std::span<const Point> points, const LineStyle& style, bool closed) {
  if (points.size() < 2) return;
  trace(points, closed);
  stroke(style);
}

void Canvas::line(Point a, Point b, const LineStyle& style) {
  const Point ends[] = {a, b};
  polyline(ends, style);
}

void Canvas::fill(std::span<const Point> ring, Color color) {
  trace(ring, true);
  set_color(cairo_, color);
  cairo_fill(cairo_);
}

void Canvas::rectangle(Point corner, double width, double height, Color color) {
  cairo_rectangle(cairo_, corner.x, corner.y, width, height);
  set_color(cairo_, color);
  cairo_fill(cairo_);
}

void Canvas::disc(Point center, double radius, Color color, const LineStyle& rim) {
  cairo_new_path(cairo_);
  cairo_arc(cairo_, center.x, center.y, radius, 0, 2 * std::numbers::pi);
  set_color(cairo_, color);
  cairo_fill_preserve(cairo_);
  stroke(rim);
}

void Canvas::image(Point corner, const Image& image, double scale) {
  // Cairo only reads the pixels, though its interface does not say so.
  auto* data = reinterpret_cast<unsigned char*>(const_cast<std::uint32_t*>(image.pixels.data()));
  const int stride = image.width * 4;
  const Surface surface(
      cairo_image_surface_create_for_data(data, CAIRO_FORMAT_ARGB32, image.width, image.height, stride),
      cairo_surface_destroy);
  demand(cairo_surface_status(surface.get()));
  if (cairo_surface_get_type(cairo_get_target(cairo_)) == CAIRO_SURFACE_TYPE_SVG) {
    auto* png =
        new std::string(png_of(data, image.width, image.height, static_cast<std::size_t>(stride), true));
    cairo_surface_set_mime_data(
        surface.get(), CAIRO_MIME_TYPE_PNG, reinterpret_cast<const unsigned char*>(png->data()), png->size(),
        [](void* held) { delete static_cast<std::string*>(held); }, png);
  }
  cairo_save(cairo_);
  cairo_translate(cairo_, corner.x, corner.y);
  cairo_scale(cairo_, 1 / scale, 1 / scale);
  cairo_set_source_surface(cairo_, surface.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cairo_), CAIRO_FILTER_NEAREST);
  cairo_paint(cairo_);
  cairo_restore(cairo_);
}

void Canvas::clipped(Point corner, double width, double height, const std::function<void()>& draw) {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, corner.x, corner.y, width, height);
  cairo_clip(cairo_);
  draw();
  cairo_restore(cairo_);
}

std::string png_page(double height, const std::function<void(Canvas&)>& draw) {
  const int columns = static_cast<int>(std::lround(page_width * pixels_per_unit));
  const int rows = static_cast<int>(std::lround(height * pixels_per_unit));
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows), cairo_surface_destroy);
  const Context cairo(cairo_create(surface.get()), cairo_destroy);
  set_color(cairo.get(), {1, 1, 1});
  cairo_paint(cairo.get());
  cairo_scale(cairo.get(), pixels_per_unit, pixels_per_unit);
  Canvas canvas(cairo.get());
  draw(canvas);
  demand(cairo_status(cairo.get()));
  cairo_surface_flush(surface.get());
  return png_of(cairo_image_surface_get_data(surface.get()), columns, rows,
                static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get())), false);
}

std::string svg_page(double height, const std::function<void(Canvas&)>& draw) {
  std::string bytes;
  {
    const Surface surface(cairo_svg_surface_create_for_stream(append, &bytes, page_width, height),
                          cairo_surface_destroy);
    const Context cairo(cairo_create(surface.get()), cairo_destroy);
    set_color(cairo.get(), {1, 1, 1});
    cairo_paint(cairo.get());
    Canvas canvas(cairo.get());
    draw(canvas);
    demand(cairo_status(cairo.get()));
    cairo_surface_finish(surface.get());
  }
  return bytes;
}

}  // namespace ashlar::output
