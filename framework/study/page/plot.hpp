#pragma once
// Plots as SVG text, for pages that load nothing. Internal to study/page.

#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace ashlar::study {

struct PlotPoint {
  double x = 0, y = 0;
  bool ring = false;  ///< marked as worth a look
  std::string hint;   ///< shown where the pointer rests
};

struct PlotSeries {
  std::size_t style = 0;  ///< colour and mark
  std::vector<PlotPoint> points;
};

struct Axis {
  std::string label;  ///< of x; what y is says the title
  bool log = true;
  std::function<std::string(double)> text;  ///< of its ticks; plain numbers by default
};

struct Plot {
  std::string title;
  Axis x, y;
  std::vector<PlotSeries> series;
  std::vector<std::pair<double, double>> front;  ///< a broad line under the marks
  double shaded_below = std::numeric_limits<double>::quiet_NaN();
  double line_at = std::numeric_limits<double>::quiet_NaN();  ///< a level, named by line_label
  std::string line_label;
  double slope = std::numeric_limits<double>::quiet_NaN();  ///< draws a triangle of it under series 0
};

/// Points that a logarithmic axis cannot show are left out. "" if nothing is left.
std::string draw(const Plot& plot);

/// The mark of a style alone, for legends.
std::string mark_svg(std::size_t style);

/// Colours that the colour-blind tell apart, after Okabe and Ito (2008).
std::string series_colour(std::size_t style);

/// Text made safe for HTML and SVG.
std::string escaped(const std::string& text);

/// printf for one number.
std::string printed(const char* pattern, double value);

/// Ticks of an axis from low to high: decades, or 1-2-5 steps where there are few of them.
std::vector<double> ticks(double low, double high, bool log);

}  // namespace ashlar::study
