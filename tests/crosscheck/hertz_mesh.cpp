#include "crosscheck/hertz_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ashlar::test {

namespace {

using geometry::Point;
using Curve = std::function<Point(double)>;
using Map = std::function<Point(double, double)>;

constexpr double pi = std::numbers::pi;
constexpr double radius = 10, width = 10,
                 force = 100;  // of the disc, of the block [m]; on the half model [N]
constexpr double facet = 5 * pi / 180;
constexpr double even_to = 2, rings_to = 7;  // radii of the rings about the contact [m]
constexpr double same = 1e-8;                // coordinates nearer than this are one [m]
constexpr int angles = 24;                   // cells from the axis to the surface

std::vector<double> even(int count) {
  std::vector<double> list;
  for (int i = 0; i <= count; ++i) list.push_back(static_cast<double>(i) / count);
  return list;
}

// Even steps where the bodies touch, then growing by a quarter each.
std::vector<double> ring_radii(double spacing) {
  const int count = static_cast<int>(std::lround(even_to / spacing));
  std::vector<double> list;
  for (int i = 0; i <= count; ++i) list.push_back(i * spacing);
  for (double step = 1.25 * spacing; list.back() + 1.5 * step < rings_to; step *= 1.25)
    list.push_back(list.back() + step);
  list.push_back(rings_to);
  return list;
}

Curve straight(Point from, Point to) {
  return [=](double t) { return from + t * (to - from); };
}

// The surface between four curves (Coons 1967); `below` and `above` run to the right, the others upwards.
Map between(const Curve& below, const Curve& above, const Curve& left, const Curve& right) {
  return [=](double u, double v) {
    const Point corners =
        (1 - u) * (1 - v) * below(0) + u * (1 - v) * below(1) + (1 - u) * v * above(0) + u * v * above(1);
    return (1 - v) * below(u) + v * above(u) + (1 - u) * left(v) + u * right(v) - corners;
  };
}

// Polar about the contact: t = 0 on the axis, t = 1 on the rim, which is ρ = 2 R cos φ.
Point in_disc(double t, double ring) {
  const double angle = t * std::acos(ring / (2 * radius));
  return {ring * std::sin(angle), radius + ring * std::cos(angle)};
}
// t = 0 on the axis, t = 1 on the surface, at the x that the disc's ring has on the rim.
Point in_block(double ring, double t) {
  const double r = in_disc(1, ring).x, angle = t * pi / 2;
  return {r * std::sin(angle), radius - r * std::cos(angle)};
}

class Builder {
 public:
  Builder(Loading loading, double spacing) : loading_(loading), rings_(ring_radii(spacing)) {}

  HertzModel build() {
    disc();
    block();
    pair_up();
    load();
    for (int i = 0; i < static_cast<int>(model_.points.size()); ++i) {
      if (std::abs(model_.points[i].x) < same) model_.axis.push_back(i);
      if (std::abs(model_.points[i].y) < same) model_.bottom.push_back(i);
    }
    return std::move(model_);
  }

 private:
  static constexpr auto disc_body = HertzModel::disc, block_body = HertzModel::block;

  int node(HertzModel::Body body, Point at) {
    const std::array<long, 3> key = {body, std::lround(at.x / same), std::lround(at.y / same)};
    const auto [found, is_new] = nodes_.try_emplace(key, static_cast<int>(model_.points.size()));
    if (is_new) {
      model_.points.push_back(at);
      body_.push_back(body);
    }
    return found->second;
  }

  // Cells of a right-handed map; a side without length makes a triangle.
  void patch(HertzModel::Body body, const Map& map, const std::vector<double>& us,
             const std::vector<double>& vs) {
    for (std::size_t i = 0; i + 1 < us.size(); ++i)
      for (std::size_t j = 0; j + 1 < vs.size(); ++j) {
        const Point corners[] = {
            {us[i], vs[j]}, {us[i + 1], vs[j]}, {us[i + 1], vs[j + 1]}, {us[i], vs[j + 1]}};
        HertzModel::Cell cell{body, {}};
        std::vector<int> middles;
        for (int k = 0; k < 4; ++k) {
          const Point a = corners[k], b = corners[(k + 1) % 4];
          const int here = node(body, map(a.x, a.y));
          if (here == node(body, map(b.x, b.y))) continue;
          cell.nodes.push_back(here);
          middles.push_back(node(body, map((a.x + b.x) / 2, (a.y + b.y) / 2)));
        }
        cell.nodes.insert(cell.nodes.end(), middles.begin(), middles.end());
        model_.cells.push_back(std::move(cell));
      }
  }

  double load_height() const {
    return loading_ == Loading::flat_top ? 2 * radius : 2 * radius + radius * std::cos(facet);
  }
  double load_width() const { return loading_ == Loading::flat_top ? radius : radius * std::sin(facet); }

  void disc() {
    patch(disc_body, in_disc, even(angles), rings_);
    const double top = load_height();
    // Angles about the disc's centre, from its lowest point: from the last ring to the load.
    const double from = 2 * std::asin(rings_to / (2 * radius));
    const double to = loading_ == Loading::flat_top ? pi / 2 : pi - facet;
    const Curve rim = [=](double v) {
      const double angle = from + v * (to - from);
      return Point{radius * std::sin(angle), 2 * radius - radius * std::cos(angle)};
    };
    std::vector<double> layers = even(loading_ == Loading::flat_top ? 14 : 40);
    if (loading_ == Loading::pole)  // finer towards the facet
      for (double& v : layers) v = 1 - std::pow(1 - v, 2.2);
    patch(disc_body,
          between([](double u) { return in_disc(u, rings_to); }, straight({0, top}, {load_width(), top}),
                  straight({0, radius + rings_to}, {0, top}), rim),
          even(angles), layers);
  }

  void block() {
    patch(block_body, in_block, rings_, even(angles));
    const auto arc = [](double t) { return in_block(rings_to, t); };
    const Point middle = arc(0.5), surface = arc(1);
    patch(block_body,
          between(
              straight({0, 0}, {width, 0}), [&](double u) { return arc(u / 2); }, straight({0, 0}, arc(0)),
              straight({width, 0}, middle)),
          even(angles / 2), even(10));
    patch(block_body,
          between(
              straight(middle, {width, 0}), straight(surface, {width, radius}),
              [&](double v) { return arc((1 + v) / 2); }, straight({width, 0}, {width, radius})),
          even(10), even(angles / 2));
  }

  std::map<double, int> surface(HertzModel::Body body, const std::function<bool(Point)>& lies_on) const {
    std::map<double, int> by_x;
    for (int i = 0; i < static_cast<int>(model_.points.size()); ++i)
      if (const Point p = model_.points[i]; body_[i] == body && p.x < even_to && lies_on(p)) by_x[p.x] = i;
    return by_x;
  }

  void pair_up() {
    const auto rim = surface(disc_body, [](Point p) {
      return p.y < 1.5 * radius && std::abs(geometry::distance(p, {0, 2 * radius}) - radius) < same;
    });
    const auto top = surface(block_body, [](Point p) { return std::abs(p.y - radius) < same; });
    if (rim.size() != top.size()) throw std::logic_error("the nodes of the contact are no pairs");
    for (auto a = rim.begin(), b = top.begin(); a != rim.end(); ++a, ++b) {
      if (std::abs(a->first - b->first) > same)
        throw std::logic_error("the nodes of a pair are not opposite");
      model_.pairs.push_back({a->second, b->second});
      model_.gaps.push_back(model_.points[a->second].y - model_.points[b->second].y);
    }
  }

  // An even load on a quadratic side: 1/6, 1/6 and 4/6 of it on ends and middle.
  void load() {
    const auto loaded = [&](int i) { return std::abs(model_.points[i].y - load_height()) < same; };
    for (const HertzModel::Cell& cell : model_.cells) {
      const std::size_t count = cell.nodes.size() / 2;
      for (std::size_t k = 0; cell.body == disc_body && k < count; ++k) {
        const int a = cell.nodes[k], b = cell.nodes[(k + 1) % count];
        if (!loaded(a) || !loaded(b)) continue;
        const double share = -force / load_width() * geometry::distance(model_.points[a], model_.points[b]);
        for (const int end : {a, b}) model_.loads[end] += share / 6;
        model_.loads[cell.nodes[count + k]] += share * 4 / 6;
      }
    }
  }

  Loading loading_;
  std::vector<double> rings_;
  HertzModel model_;
  std::vector<HertzModel::Body> body_;  ///< by point
  std::map<std::array<long, 3>, int> nodes_;
};

}  // namespace

std::string name_of(Loading loading) {
  return loading == Loading::flat_top ? "flat_top" : "pole";
}

HertzModel make_hertz(Loading loading, double spacing) {
  return Builder(loading, spacing).build();
}

}  // namespace ashlar::test
