#include "crosscheck/hertz_picture.hpp"

#include "crosscheck/hertz_profile.hpp"
#include "output/pictures/chart.hpp"
#include "output/pictures/frame.hpp"

namespace ashlar::test {

namespace {

using output::Chart;
using output::ChartCurve;
using Look = ChartCurve::Look;

constexpr double shown_to = 1.7;            // of x [m]
constexpr double title = 32, heading = 14;  // heights in units of the page

struct Curve {
  std::string name;
  Profile profile;
  Look look;
  output::Color color;
};

Profile theory(const Profile& places) {
  Profile result{places.x, {}};
  for (const double x : places.x) result.p.push_back(hertz_pressure(x));
  return result;
}

std::vector<Curve> curves_of(Loading loading, const Profile& reference) {
  std::vector<Curve> curves = {
      {"Hertz's theory", theory(reference), Look::dashes, output::oklch(0.55, 0, 0)},
      {"CalculiX, quadratic, 25 mm", reference, Look::line, output::oklch(0.2, 0, 0)}};
  const auto add = [&](int cells, int order, Look look, output::Color color) {
    const HertzRun run = run_hertz(loading, cells, order);
    curves.push_back(
        {std::to_string(cells) + " cells, order " + std::to_string(order), run.profile, look, color});
  };
  add(389, 1, Look::discs, output::oklch(0.72, 0.15, 70));
  add(600, 1, Look::discs, output::oklch(0.58, 0.2, 30));
  add(1155, 1, Look::discs, output::oklch(0.45, 0.2, 290));
  add(600, 2, Look::rings, output::oklch(0.55, 0.15, 160));
  return curves;
}

Chart chart_of_pressure(const std::vector<Curve>& curves) {
  Chart chart{"", "pressure *p*", {1, "m"}, {1, "Pa"}, {}, 120, {{0, shown_to}}, {{0, 90}}};
  for (const Curve& curve : curves) {
    ChartCurve& drawn = chart.curves.emplace_back(ChartCurve{curve.name, {}, curve.look, curve.color});
    for (std::size_t i = 0; i < curve.profile.x.size(); ++i)
      drawn.points.push_back({curve.profile.x[i], curve.profile.p[i]});
  }
  return chart;
}

// In percent of the reference's peak.
Chart chart_of_difference(const std::vector<Curve>& curves, const Profile& reference) {
  Chart chart{"*x*", "difference", {1, "m"}, {1, "% of peak"}, {}, 100, {{0, shown_to}}, {{-5, 5}}};
  for (const Curve& curve : curves) {
    ChartCurve& drawn = chart.curves.emplace_back(ChartCurve{"", {}, curve.look, curve.color});
    for (std::size_t i = 0; i < curve.profile.x.size(); ++i) {
      const double x = curve.profile.x[i];
      drawn.points.push_back({x, 100 * (curve.profile.p[i] - reference.at(x)) / reference.peak()});
    }
  }
  return chart;
}

struct Part {
  std::string heading;
  Chart chart;
};

double height_of(const Part& part) {
  return (part.heading.empty() ? 0 : heading) + output::page_height(part.chart);
}

void draw(output::Canvas& canvas, const std::vector<Part>& parts) {
  output::draw_title(
      canvas, "Hertz: pressure along the contact",
      "above *p*(*x*), below its difference to the reference by CalculiX; *x* from the axis of symmetry");
  output::TextStyle bold;
  bold.bold = true;
  double top = title;
  for (const Part& part : parts) {
    canvas.text(52, top + 10, part.heading, bold);
    output::draw_chart(canvas, part.chart, top + (part.heading.empty() ? 0 : heading));
    top += height_of(part);
  }
}

}  // namespace

std::string hertz_picture() {
  const Profiles stored = stored_reference();
  std::vector<Part> parts;
  for (const auto& [loading, reference] : stored) {
    const std::vector<Curve> curves = curves_of(loading, reference);
    parts.push_back({loading == Loading::flat_top ? "Lower half disc, even load on its flat top"
                                                  : "Full disc, load near its upper pole",
                     chart_of_pressure(curves)});
    parts.push_back({"", chart_of_difference(curves, reference)});
  }
  double height = title;
  for (const Part& part : parts) height += height_of(part);
  return output::png_page(height, [&](output::Canvas& canvas) { draw(canvas, parts); });
}

}  // namespace ashlar::test
