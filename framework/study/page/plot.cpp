#include "study/page/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ashlar::study {

namespace {

constexpr double width = 340, height = 262;
constexpr double least_gap = 46;  // between the texts of ticks
constexpr double left = 68, right = 20, top = 30, bottom = 44;

std::string at(double x, double y) {
  return printed("%.1f", x) + "," + printed("%.1f", y);
}

std::string text_at(double x, double y, const std::string& text, const std::string& more) {
  return "<text x=\"" + printed("%.1f", x) + "\" y=\"" + printed("%.1f", y) + "\" " + more + ">" +
         escaped(text) + "</text>\n";
}

std::string mark(double x, double y, std::size_t style) {
  const std::string colour = "fill=\"" + series_colour(style) + "\"";
  const auto shape = [&](std::initializer_list<std::pair<double, double>> corners) {
    std::string points;
    for (const auto& [dx, dy] : corners) points += at(x + dx, y + dy) + " ";
    return "<polygon points=\"" + points + "\" " + colour + "/>";
  };
  switch (style % 4) {
    case 0:
      return "<circle cx=\"" + printed("%.1f", x) + "\" cy=\"" + printed("%.1f", y) + "\" r=\"4\" " + colour +
             "/>";
    case 1:
      return shape({{-3.8, -3.8}, {3.8, -3.8}, {3.8, 3.8}, {-3.8, 3.8}});
    case 2:
      return shape({{0, -5}, {4.8, 3.6}, {-4.8, 3.6}});
    default:
      return shape({{0, -5}, {5, 0}, {0, 5}, {-5, 0}});
  }
}

/// Values along one axis to places in the picture.
class Scale {
 public:
  Scale(const std::vector<double>& values, bool log, double from, double to)
      : log_(log), from_(from), to_(to) {
    const auto [low, high] = std::ranges::minmax(values);
    const double a = place(low), b = place(high),
                 span = std::max(b - a, log ? 0.3 : 1e-12 + 0.1 * std::abs(a));
    low_ = a - 0.07 * span - (b > a ? 0 : span / 2);
    high_ = b + 0.07 * span + (b > a ? 0 : span / 2);
  }
  double operator()(double value) const {
    return from_ + (place(value) - low_) / (high_ - low_) * (to_ - from_);
  }
  double low() const { return log_ ? std::pow(10, low_) : low_; }
  double high() const { return log_ ? std::pow(10, high_) : high_; }

 private:
  double place(double value) const { return log_ ? std::log10(value) : value; }
  bool log_;
  double from_, to_, low_ = 0, high_ = 1;
};

class Drawing {
 public:
  explicit Drawing(const Plot& plot)
      : plot_(plot),
        x_(values(&PlotPoint::x, plot.x.log, {}), plot.x.log, left, width - right),
        y_(values(&PlotPoint::y, plot.y.log, plot.line_at), plot.y.log, height - bottom, top) {}

  std::string draw() {
    svg_ = "<svg viewBox=\"0 0 " + printed("%.0f", width) + " " + printed("%.0f", height) +
           "\" role=\"img\" aria-label=\"" + escaped(plot_.title) + "\">\n";
    svg_ += text_at(left, 16, plot_.title, "class=\"plot-title\"");
    shade();
    axes();
    if (!std::isnan(plot_.line_at)) level();
    front();
    for (const PlotSeries& series : plot_.series) line(series);
    triangle();
    for (const PlotSeries& series : plot_.series) marks(series);
    return svg_ + "</svg>\n";
  }

  static bool shows(const Plot& plot, const PlotPoint& point) {
    return std::isfinite(point.x) && std::isfinite(point.y) && (!plot.x.log || point.x > 0) &&
           (!plot.y.log || point.y > 0);
  }

 private:
  std::vector<double> values(double PlotPoint::*member, bool log, double more) const {
    std::vector<double> all;
    for (const PlotSeries& series : plot_.series)
      for (const PlotPoint& point : series.points)
        if (shows(plot_, point)) all.push_back(point.*member);
    if (!std::isnan(more) && more != 0 && (!log || more > 0)) all.push_back(more);
    return all;
  }

  void axes() {
    double last = -least_gap;
    for (const double tick : ticks(x_.low(), x_.high(), plot_.x.log)) {
      const double x = x_(tick);
      svg_ += "<path d=\"M" + at(x, top) + "V" + printed("%.1f", height - bottom) + "\" class=\"grid\"/>";
      if (x - last < least_gap) continue;
      last = x;
      svg_ +=
          text_at(x, height - bottom + 15, tick_text(plot_.x, tick), "class=\"tick\" text-anchor=\"middle\"");
    }
    for (const double tick : ticks(y_.low(), y_.high(), plot_.y.log)) {
      const double y = y_(tick);
      svg_ += "<path d=\"M" + at(left, y) + "H" + printed("%.1f", width - right) + "\" class=\"grid\"/>";
      svg_ += text_at(left - 6, y + 3.5, tick_text(plot_.y, tick), "class=\"tick\" text-anchor=\"end\"");
    }
    svg_ += "<path d=\"M" + at(left, top) + "V" + printed("%.1f", height - bottom) + "H" +
            printed("%.1f", width - right) + "\" class=\"axis\"/>\n";
    svg_ += text_at((left + width - right) / 2, height - 10, plot_.x.label,
                    "class=\"label\" text-anchor=\"middle\"");
  }

  static std::string tick_text(const Axis& axis, double value) {
    return axis.text ? axis.text(value) : printed("%.4g", value);
  }

  void shade() {
    if (!(plot_.shaded_below > y_.low())) return;
    const double y = std::max(top, y_(std::min(plot_.shaded_below, y_.high())));
    svg_ += "<rect x=\"" + printed("%.1f", left) + "\" y=\"" + printed("%.1f", y) + "\" width=\"" +
            printed("%.1f", width - right - left) + "\" height=\"" + printed("%.1f", height - bottom - y) +
            "\" class=\"doubt\"/>\n";
  }

  void level() {
    const double y = y_(plot_.line_at);
    svg_ += "<path d=\"M" + at(left, y) + "H" + printed("%.1f", width - right) + "\" class=\"level\"/>";
    svg_ += text_at(width - right - 4, y - 5, plot_.line_label, "class=\"tick\" text-anchor=\"end\"");
  }

  void front() {
    if (plot_.front.size() < 2) return;
    std::string points;
    for (const auto& [x, y] : plot_.front) points += at(x_(x), std::clamp(y_(y), top, height - bottom)) + " ";
    svg_ += "<polyline points=\"" + points + "\" class=\"front\"/>\n";
  }

  void line(const PlotSeries& series) {
    std::string points;
    for (const PlotPoint& point : series.points)
      if (shows(plot_, point)) points += at(x_(point.x), y_(point.y)) + " ";
    svg_ += "<polyline points=\"" + points + "\" class=\"line\" stroke=\"" + series_colour(series.style) +
            "\"/>\n";
  }

  void marks(const PlotSeries& series) {
    for (const PlotPoint& point : series.points) {
      if (!shows(plot_, point)) continue;
      const double x = x_(point.x), y = y_(point.y);
      svg_ += "<g>" + mark(x, y, series.style);
      if (point.ring)
        svg_ += "<circle cx=\"" + printed("%.1f", x) + "\" cy=\"" + printed("%.1f", y) +
                "\" r=\"7.5\" class=\"ring\"/>";
      svg_ += "<title>" + escaped(point.hint) + "</title></g>\n";
    }
  }

  // In the corner below the curves: to the right where they rise, to the left where they fall.
  void triangle() {
    if (std::isnan(plot_.slope) || !plot_.x.log || !plot_.y.log || plot_.series.empty()) return;
    const double begin = plot_.slope > 0 ? 0.66 : 0.15, across = x_.high() / x_.low();
    const double x0 = x_.low() * std::pow(across, begin), x1 = x_.low() * std::pow(across, begin + 0.2);
    const double fall = std::pow(x1 / x0, plot_.slope),
                 least = y_.low() * std::pow(y_.high() / y_.low(), 0.08);
    const double y0 = plot_.slope > 0 ? least : least / fall, y1 = y0 * fall;
    if (y_(y1) < top || y_(y1) > height - bottom) return;
    const bool rises = plot_.slope > 0;
    const double corner_x = rises ? x1 : x0, corner_y = rises ? y0 : y1;
    svg_ += "<polygon points=\"" + at(x_(x0), y_(y0)) + " " + at(x_(x1), y_(y1)) + " " +
            at(x_(corner_x), y_(corner_y)) + "\" class=\"slope\"/>";
    svg_ += text_at((x_(x0) + x_(x1)) / 2, y_(corner_y) + 12, "1", "class=\"tick\" text-anchor=\"middle\"");
    svg_ += text_at(x_(corner_x) + (rises ? 5 : -5), (y_(y0) + y_(y1)) / 2 + 3,
                    printed("%.2f", std::abs(plot_.slope)),
                    std::string("class=\"tick\" text-anchor=\"") + (rises ? "start" : "end") + "\"");
  }

  const Plot& plot_;
  Scale x_, y_;
  std::string svg_;
};

}  // namespace

std::string draw(const Plot& plot) {
  for (const PlotSeries& series : plot.series)
    for (const PlotPoint& point : series.points)
      if (Drawing::shows(plot, point)) return Drawing(plot).draw();
  return {};
}

std::string mark_svg(std::size_t style) {
  return "<svg class=\"key\" viewBox=\"0 0 26 12\"><path d=\"M1,6H25\" stroke=\"" + series_colour(style) +
         "\" stroke-width=\"1.6\"/>" + mark(13, 6, style) + "</svg>";
}

std::string series_colour(std::size_t style) {
  constexpr std::array colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                  "#56b4e9", "#e69f00", "#555555"};
  return colours[style % colours.size()];
}

std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  }
  return safe;
}

std::string printed(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::vector<double> ticks(double low, double high, bool log) {
  std::vector<double> all;
  if (!log) {
    const double rough = (high - low) / 5, decade = std::pow(10, std::floor(std::log10(rough)));
    const double step = decade * (rough > 5 * decade ? 10 : rough > 2 * decade ? 5 : rough > decade ? 2 : 1);
    for (double t = std::ceil(low / step) * step; t <= high; t += step)
      all.push_back(std::abs(t) < step / 2 ? 0 : t);
    return all;
  }
  const double decades = std::log10(high / low);
  const int stride = std::max(1, static_cast<int>(std::ceil(decades / 7)));
  const std::vector<double> steps = decades > 2.6   ? std::vector<double>{1}
                                    : decades > 1.2 ? std::vector<double>{1, 3}
                                    : decades > 0.6 ? std::vector<double>{1, 2, 5}
                                                    : std::vector<double>{1, 1.5, 2, 3, 4, 5, 6, 8};
  const int first = static_cast<int>(std::floor(std::log10(low)));
  for (int e = first; e <= static_cast<int>(std::ceil(std::log10(high))); ++e)
    for (const double s : steps)
      if (const double t = s * std::pow(10, e); t >= low && t <= high && (stride == 1 || e % stride == 0))
        all.push_back(t);
  return all;
}

}  // namespace ashlar::study
