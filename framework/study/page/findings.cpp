// What a measure tells: its reference, its errors against everything they may be plotted over, its price.

#include <algorithm>
#include <cctype>
#include <cmath>

#include "output/text_table.hpp"
#include "study/cases.hpp"
#include "study/page/parts.hpp"
#include "study/page/plot.hpp"

namespace ashlar::study {

namespace {

std::string size_text(double h) {
  return output::short_quantity(h, "m");
}

std::string count_text(double n) {
  if (n < 1e3) return printed("%.0f", n);
  return n < 1e6 ? printed("%.3gk", n / 1e3) : printed("%.3gM", n / 1e6);
}

std::string percent_text(double error) {
  const double percent = 100 * error;
  if (percent == 0) return "0";
  return percent >= 0.999e-3 && percent < 1e4 ? printed("%.3g %%", percent) : printed("%.0e %%", percent);
}

/// One thing that errors are plotted over.
struct Across {
  std::string title;
  Axis axis;
  std::function<double(const Outcome&)> of;
};

const std::vector<Across>& all_across() {
  static const std::vector<Across> all = {
      {"Error against size of cells",
       {"h = √(area / cells)", true, size_text},
       [](const Outcome& o) { return o.h; }},
      {"Error against unknowns", {"unknowns", true, count_text}, [](const Outcome& o) { return o.unknowns; }},
      {"Error against wall time",
       {"wall time of a run", true, time_text},
       [](const Outcome& o) { return o.best().record.wall; }},
      {"Error against CPU time",
       {"CPU time of a run", true, time_text},
       [](const Outcome& o) { return o.best_cpu(); }},
      {"Error against memory", {"peak memory of a run", true, memory_text}, [](const Outcome& o) {
         return o.memory();
       }}};
  return all;
}

class Section {
 public:
  Section(const PageData& data, const Finding& finding)
      : data_(data),
        finding_(finding),
        measure_(data.study.measures[finding.measure]),
        unit_(unit_of(measure_)) {}

  std::string write() {
    std::string title = measure_.title;
    title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
    std::string html = "<section>\n<h2>" + escaped(title) +
                       (finding_.problem.empty() ? "" : " <small>" + escaped(finding_.problem) + "</small>") +
                       "</h2>\n";
    if (finding_.readings.empty()) return html + "<p>No run gave this measure.</p></section>\n";
    html += "<p>" + what() + " " + reference() + "</p>\n";
    html += legend() + "<div class=\"plots\">\n";
    if (data_.analysis.sizes_differ && compared())
      for (const Across& across : all_across()) html += error_plot(across);
    if (data_.analysis.sizes_differ) html += value_over_size();
    html += parameter_plots() + "</div>\n" + explain();
    html += "<div class=\"tables\">" + ladder() + orders() + "</div>\n";
    return html + "</section>\n";
  }

 private:
  bool compared() const { return !measure_.compared_with("none"); }

  std::string what() const {
    if (measure_.cost == "iterations")
      return "Iterations of " +
             (measure_.stage.empty() ? "all stages." : "the stage " + escaped(measure_.stage) + ".");
    if (!measure_.cost.empty())
      return (measure_.cost == "cpu" ? "CPU time of " : "Wall time of ") +
             (measure_.effect.empty() ? "the run." : escaped(measure_.effect) + ".");
    if (!measure_.at.empty()) return "<code>" + escaped(measure_.at) + "</code> of the results.";
    std::string text = "<code>" + escaped(measure_.quantity) + "</code> of ";
    text += measure_.joint.empty() ? "the probe " + escaped(measure_.probe)
                                   : "the joint " + escaped(measure_.joint);
    if (!measure_.minus.empty()) text += " less that of " + escaped(measure_.minus);
    return text + (measure_.stage.empty() ? "." : " in the stage " + escaped(measure_.stage) + ".");
  }

  std::string reference() const {
    const Reference& reference = finding_.reference;
    if (!compared()) return "It is not compared with anything.";
    if (std::isnan(reference.value))
      return "There is nothing to compare it with: " + escaped(reference.how) + ".";
    if (measure_.reference.function() && finding_.readings.size() > 1 && data_.study.refine.empty())
      return "Compared with the study's function of each case.";
    std::string text = "Compared with <b>" + value_text(reference.value, unit_) + "</b>";
    if (reference.uncertainty > 0) text += " ± " + value_text(two_digits(reference.uncertainty), unit_);
    return text + ", " + escaped(reference.how) +
           (std::isnan(reference.uncertainty) ? "; how far that is from the truth is not known." : ".");
  }

  bool in(const Series& series) const { return series.problem == finding_.problem; }

  const Reading* reading(std::size_t c) const {
    const auto found = std::ranges::find(finding_.readings, c, &Reading::one);
    return found == finding_.readings.end() ? nullptr : &*found;
  }

  std::string legend() const {
    std::string html = "<p class=\"legend\">";
    std::size_t style = 0;
    for (const Series& series : data_.analysis.series)
      if (in(series) && !series.label.empty())
        html += "<span>" + mark_svg(style++) + escaped(series.label) + "</span>";
    if (finding_.front.size() > 1)
      html +=
          "<span><svg class=\"key\" viewBox=\"0 0 26 12\"><circle cx=\"13\" cy=\"6\" r=\"5\" "
          "class=\"ring\"/></svg>"
          "best bargains (Pareto front)</span>";
    return html + "</p>\n";
  }

  std::string hint(const Reading& reading) const {
    const Outcome& outcome = data_.outcomes[reading.one];
    std::string text = label(data_.study.cases[reading.one]) + ": " + value_text(reading.value, unit_);
    if (!std::isnan(reading.relative))
      text += ", off by " + accuracy_text(reading.relative, finding_.absolute, unit_);
    return text + "; " + time_text(outcome.best().record.wall) + ", " + memory_text(outcome.memory());
  }

  std::vector<PlotSeries> marks(const std::function<double(std::size_t)>& x,
                                const std::function<double(const Reading&)>& y, bool rings) const {
    std::vector<PlotSeries> all;
    std::size_t style = 0;
    for (const Series& series : data_.analysis.series) {
      if (!in(series)) continue;
      PlotSeries drawn{style++, {}};
      for (const std::size_t c : series.cases)
        if (const Reading* found = reading(c))
          drawn.points.push_back({x(c), y(*found), rings && found->on_front, hint(*found)});
      all.push_back(std::move(drawn));
    }
    return all;
  }

  Axis error_axis(bool log) const {
    const bool absolute = finding_.absolute;
    const std::string unit = unit_;
    return {"", log, [absolute, unit](double error) {
              return absolute ? output::short_quantity(error, unit) : percent_text(error);
            }};
  }

  std::string error_plot(const Across& across) const {
    Plot plot;
    plot.title = across.title;
    plot.x = across.axis;
    plot.y = error_axis(true);
    plot.series = marks([&](std::size_t c) { return across.of(data_.outcomes[c]); },
                        [](const Reading& r) { return r.relative; }, true);
    const double scale = finding_.absolute ? 1 : std::abs(finding_.reference.value);
    if (finding_.reference.uncertainty > 0) plot.shaded_below = finding_.reference.uncertainty / scale;
    plot.slope = slope_of(plot);
    if (across.title.ends_with("wall time"))
      for (const std::size_t r : finding_.front)
        if (finding_.readings[r].sure > 0)
          plot.front.emplace_back(across.of(data_.outcomes[finding_.readings[r].one]),
                                  finding_.readings[r].sure);
    return draw(plot);
  }

  static double slope_of(const Plot& plot) {
    std::vector<std::pair<double, double>> points;
    for (const PlotPoint& point : plot.series.front().points)
      if (point.x > 0 && point.y > floor_of_errors) points.emplace_back(point.x, point.y);
    return points.size() < 3 ? unknown : slope(points);
  }

  Axis value_axis() const {
    const std::string unit = unit_;
    return {"", false, [unit](double value) { return value_text(value, unit); }};
  }

  std::string value_over_size() const {
    Plot plot;
    plot.title = "Value against size of cells";
    plot.x = all_across().front().axis;
    plot.y = value_axis();
    plot.series = marks([&](std::size_t c) { return data_.outcomes[c].h; },
                        [](const Reading& r) { return r.value; }, false);
    if (!measure_.reference.function()) plot.line_at = finding_.reference.value;
    plot.line_label = "reference";
    return draw(plot);
  }

  // Parameters that are numbers but do not refine: what they do to value and error.
  std::string parameter_plots() const {
    std::string html;
    for (const Setting& setting : data_.study.cases.front().settings) {
      if (setting.key == data_.study.refine || !setting.value.quantity() || !varies(setting.key)) continue;
      const auto x = [&](std::size_t c) {
        const core::Value* value = find(data_.study.cases[c], setting.key);
        return value && value->quantity() ? value->quantity()->value : unknown;
      };
      Plot plot;
      plot.title = "Value against " + setting.key;
      plot.x = {setting.key, false, {}};
      plot.y = value_axis();
      plot.series = marks(
          x, [](const Reading& r) { return r.value; }, false);
      if (!measure_.reference.function()) plot.line_at = finding_.reference.value;
      plot.line_label = "reference";
      html += draw(plot);
      if (!compared()) continue;
      Plot errors;
      errors.title = "Error against " + setting.key;
      errors.x = plot.x;
      errors.y = error_axis(false);
      errors.series = marks(
          x, [](const Reading& r) { return r.relative; }, false);
      html += draw(errors);
    }
    return html;
  }

  /// Within a series: what tells series apart is in their labels.
  bool varies(const std::string& key) const {
    return std::ranges::any_of(data_.analysis.series, [&](const Series& series) {
      const core::Value* first = find(data_.study.cases[series.cases.front()], key);
      return in(series) && first && std::ranges::any_of(series.cases, [&](std::size_t c) {
               const core::Value* value = find(data_.study.cases[c], key);
               return value && set_text(*value) != set_text(*first);
             });
    });
  }

  std::string explain() const {
    if (!data_.analysis.sizes_differ) return {};
    std::string text =
        "<p class=\"note\">Triangles show the slope of the first series, fitted to all its runs.";
    if (finding_.reference.uncertainty > 0)
      text += " In the grey band an error is smaller than what is known of the reference, and means little.";
    if (finding_.front.size() > 1)
      text +=
          " The broad line is the front of best bargains; a run that is nearer the reference than a finer "
          "one of "
          "its series is so by chance, and counts there with the larger error.";
    return text + "</p>\n";
  }

  std::string ladder() const {
    if (finding_.ladder.empty()) return {};
    std::vector<std::vector<std::string>> rows = {{"accuracy", "wall time", "with", "known from"}};
    for (const Rung& rung : finding_.ladder) {
      const bool known = rung.price.known != Price::Known::unknown;
      const bool most = rung.price.known == Price::Known::at_most;
      rows.push_back({accuracy_text(rung.error, finding_.absolute, unit_),
                      known ? (most ? "≤ " : "") + time_text(rung.price.cost) : "?", escaped(rung.with),
                      escaped(rung.from)});
    }
    return "<div><h3>What accuracy costs</h3>" + html_table(rows, 4) + "</div>";
  }

  std::string orders() const {
    if (data_.study.refine.empty()) return {};
    std::vector<std::vector<std::string>> rows = {{"series", "limit", "±", "order", "slope of errors", ""}};
    for (const Limit& limit : finding_.limits) {
      const Extrapolation& found = limit.found;
      rows.push_back({escaped(limit.series.empty() ? "all runs" : limit.series),
                      value_text(found.limit, unit_), value_text(two_digits(found.uncertainty), unit_),
                      std::isnan(found.order) ? "–" : printed("%.2f", found.order),
                      std::isnan(limit.observed) ? "–" : printed("%.2f", limit.observed),
                      found.sound ? "" : "wide: " + escaped(found.why)});
    }
    return rows.size() < 2 ? "" : "<div><h3>Where the runs tend to</h3>" + html_table(rows, 1) + "</div>";
  }

  const PageData& data_;
  const Finding& finding_;
  const Measure& measure_;
  std::string unit_;
};

}  // namespace

std::string finding_section(const PageData& data, const Finding& finding) {
  return Section(data, finding).write();
}

}  // namespace ashlar::study
