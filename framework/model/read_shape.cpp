#include "model/read_shape.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/polygon.hpp"

namespace ashlar::model {

namespace {

using core::Mistakes;
using core::Settings;
using core::Value;
using geometry::Point;
using geometry::Shape;
using geometry::ShapeEdge;

constexpr core::Dimension metre{1, 0, 0};

std::string text_of(Point p) {
  const auto coordinate = [](double x) { return core::format_quantity(x, {}); };
  return "(" + coordinate(p.x) + ", " + coordinate(p.y) + ")";
}

struct Corner {
  Point at;
  std::string name;
  const Value* arc = nullptr;
  core::Place place;
};

bool is_corner(const core::Table* table) {
  return table && table->constructor.empty() && (table->items.size() == 2 || table->items.size() == 3);
}

// {x, y, "edge", arc = …}; nothing if it is not one.
std::optional<Corner> read_corner(const Value& value, Mistakes& mistakes) {
  const core::Table* table = value.table();
  if (!is_corner(table)) {
    mistakes.add(value.place, "must be a corner {x, y, \"edge\"}, got " + value.type_name());
    return {};
  }
  Corner corner;
  corner.place = value.place;
  const auto x = core::read_number(table->items[0], metre, mistakes);
  const auto y = core::read_number(table->items[1], metre, mistakes);
  if (table->items.size() == 3) {
    const std::string* name = table->items[2].text();
    const std::string why = name ? bad_name(*name) : "an edge's name must be a text";
    if (!why.empty()) mistakes.add(value.place, why);
    if (name) corner.name = *name;
  }
  for (const auto& [key, entry] : table->entries) {
    if (key == "arc")
      corner.arc = &entry;
    else
      mistakes.add(entry.place, "unknown key '" + key + "' in a corner", core::did_you_mean(key, {"arc"}));
  }
  if (!x || !y) return {};
  corner.at = {*x, *y};
  return corner;
}

geometry::Arc arc_about(Point center, Point start, Point end) {
  return {center, geometry::cross(start - center, end - center) >= 0};
}

std::optional<geometry::Arc> read_arc(const Corner& corner, Point end, const core::Registry& registry,
                                      Mistakes& mistakes) {
  const std::size_t before = mistakes.list().size();
  const Settings arc = core::check(*corner.arc, registry.find("arc", "arc")->schema, registry, mistakes);
  if (mistakes.list().size() > before) return {};
  if (arc.has("through")) {
    const auto [x, y] = arc.point("through");
    const auto found = geometry::arc_through(corner.at, {x, y}, end);
    if (!found) mistakes.add(corner.arc->place, "an arc through three points on one line: leave the arc out");
    return found;
  }
  const auto [x, y] = arc.point("center");
  const double r = geometry::distance(corner.at, {x, y}), r_end = geometry::distance(end, {x, y});
  // A thousandth is far above rounding in a script and far below what an eye would accept.
  if (std::abs(r - r_end) > 1e-3 * std::max(r, r_end) || r == 0) {
    mistakes.add(corner.arc->place,
                 "the arc's ends are not equally far from its center: " + core::format_quantity(r, metre) +
                     " and " + core::format_quantity(r_end, metre));
    return {};
  }
  const geometry::Arc found = arc_about({x, y}, corner.at, end);
  // Round about half a turn, which way is meant hangs on the last digit.
  const Point a = corner.at - found.center, b = end - found.center;
  if (!(corner.at == end) && geometry::dot(a, b) < 0 && std::abs(geometry::cross(a, b)) < 1e-6 * r * r_end) {
    mistakes.add(corner.arc->place, "a half circle about its center can go either way round",
                 "say a point that it goes through: Arc { through = {x, y} }");
    return {};
  }
  return found;
}

// Crossings are looked for on the ring's chords; arcs by chords of 7.5°.
void check_ring(const std::vector<ShapeEdge>& ring, const core::Place& place, Mistakes& mistakes) {
  geometry::Ring chords;
  std::vector<std::size_t> edge_of;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point end = ring[(i + 1) % ring.size()].start;
    std::vector<Point> points = {ring[i].start, end};
    if (ring[i].arc) points = geometry::points_on_arc(ring[i].start, end, *ring[i].arc, 1e300, 0.1309);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
      chords.push_back(points[k]);
      edge_of.push_back(i);
    }
  }
  const auto [a, b] = geometry::first_crossing(chords);
  if (a >= 0) {
    const ShapeEdge& first = ring[edge_of[static_cast<std::size_t>(a)]];
    const ShapeEdge& second = ring[edge_of[static_cast<std::size_t>(b)]];
    mistakes.add(second.place, "the border crosses or touches itself: the edge from " +
                                   text_of(second.start) + " meets the edge from " + text_of(first.start));
  } else if (geometry::signed_area(chords) == 0) {
    mistakes.add(place, "the corners enclose no area");
  }
}

std::vector<ShapeEdge> read_ring(const std::vector<Value>& items, const core::Place& place,
                                 const core::Registry& registry, Mistakes& mistakes) {
  const std::size_t before = mistakes.list().size();
  std::vector<Corner> corners;
  for (const Value& item : items)
    if (item.is_nothing())
      return {};  // reported where it became nothing
    else if (const auto corner = read_corner(item, mistakes))
      corners.push_back(*corner);
  if (corners.size() < items.size() || mistakes.list().size() > before) return {};
  const auto ends_at = [&](std::size_t i) { return corners[(i + 1) % corners.size()].at; };
  for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i)
    if (corners[i].at == ends_at(i)) {
      const Corner& second = corners[(i + 1) % corners.size()];
      mistakes.add(second.place, "two neighbouring corners coincide at " + text_of(second.at),
                   i + 1 == corners.size() ? "the border closes by itself: leave the last corner out" : "");
    }
  const bool arcs = std::any_of(corners.begin(), corners.end(), [](const Corner& c) { return c.arc; });
  if (corners.size() < (arcs ? 2U : 3U))
    mistakes.add(place, "needs at least 3 corners, got " + std::to_string(corners.size()));
  if (mistakes.list().size() > before) return {};

  std::vector<ShapeEdge> ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ring.push_back({corners[i].at, corners[i].name, {}, corners[i].place});
    if (corners[i].arc) ring.back().arc = read_arc(corners[i], ends_at(i), registry, mistakes);
  }
  if (mistakes.list().size() == before) check_ring(ring, place, mistakes);
  return ring;
}

Shape read_polygon(const Settings& region, const core::Registry& registry, Mistakes& mistakes) {
  Shape shape;
  shape.place = region.place;
  shape.rings.push_back(read_ring(region.items, region.place, registry, mistakes));
  const core::Table* holes = region.value("holes").table();
  if (!holes) return shape;
  for (const Value& hole : holes->items)
    if (hole.table()) shape.rings.push_back(read_ring(hole.table()->items, hole.place, registry, mistakes));
  return shape;
}

Shape read_disk(const Settings& disk) {
  Shape shape;
  shape.place = disk.place;
  if (!disk.has("center") || !disk.has("radius")) return shape;
  const auto [x, y] = disk.point("center");
  const double r = disk.number("radius");
  const geometry::Arc arc{{x, y}, true};
  std::vector<ShapeEdge> ring;
  for (const Point start : {Point{x + r, y}, Point{x, y + r}, Point{x - r, y}, Point{x, y - r}})
    ring.push_back({start, disk.text("name"), arc, disk.place});
  shape.rings.push_back(std::move(ring));
  return shape;
}

Shape read_rectangle(const Settings& rectangle, Mistakes& mistakes) {
  Shape shape;
  shape.place = rectangle.place;
  if (!rectangle.has("from") || !rectangle.has("to")) return shape;
  const auto [x0, y0] = rectangle.point("from");
  const auto [x1, y1] = rectangle.point("to");
  if (!(x0 < x1 && y0 < y1))
    mistakes.add(rectangle.place_of("to"), "must lie to the upper right of `from`, got " + text_of({x1, y1}) +
                                               " against " + text_of({x0, y0}));
  const core::Table* names = rectangle.value("names").table();
  if (names && names->items.size() != 4)
    mistakes.add(rectangle.place_of("names"),
                 "needs four names (bottom, right, top, left), got " + std::to_string(names->items.size()));
  std::vector<ShapeEdge> ring;
  const std::array<Point, 4> corners = {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const bool named = names && i < names->items.size() && names->items[i].text();
    ring.push_back({corners[i], named ? *names->items[i].text() : "", {}, rectangle.place});
  }
  shape.rings.push_back(std::move(ring));
  return shape;
}

Shape read_operation(const Settings& region, Shape::Kind kind, const core::Registry& registry,
                     Mistakes& mistakes) {
  Shape shape;
  shape.kind = kind;
  shape.place = region.place;
  for (const auto& [number, operand] : region.objects("")) {
    if (operand.name == "mesh_group")
      mistakes.add(operand.place, "a group of a mesh file cannot be cut or joined");
    else
      shape.operands.push_back(read_shape(operand, registry, mistakes));
  }
  if (shape.operands.size() < 2) mistakes.add(region.place, region.name + " needs two shapes or more");
  return shape;
}

}  // namespace

Shape read_shape(const Settings& region, const core::Registry& registry, Mistakes& mistakes) {
  if (region.name == "polygon") return read_polygon(region, registry, mistakes);
  if (region.name == "disk") return read_disk(region);
  if (region.name == "rectangle") return read_rectangle(region, mistakes);
  if (region.name == "difference") return read_operation(region, Shape::Kind::difference, registry, mistakes);
  if (region.name == "union") return read_operation(region, Shape::Kind::unite, registry, mistakes);
  if (region.name == "intersection")
    return read_operation(region, Shape::Kind::intersection, registry, mistakes);
  return {};
}

bool is_whole(const Shape& shape) {
  if (shape.rings.empty() && shape.operands.empty()) return false;
  return std::none_of(shape.rings.begin(), shape.rings.end(),
                      [](const auto& ring) { return ring.empty(); }) &&
         std::all_of(shape.operands.begin(), shape.operands.end(), is_whole);
}

std::vector<std::string> edge_names(const Shape& shape) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const auto& ring : shape.rings)
    for (const ShapeEdge& edge : ring) add(edge.name);
  for (const Shape& operand : shape.operands)
    for (const std::string& name : edge_names(operand)) add(name);
  return names;
}

std::string bad_name(const std::string& name, bool dots_allowed) {
  if (name.empty()) return "a name must not be empty";
  if (name.size() > 60)
    return "a name of " + std::to_string(name.size()) + " characters; at most 60 are allowed";
  if (name == "." || name == "..") return "'" + name + "' cannot be a name";
  for (const char c : name)
    if (c == '/' || c == '\\' || (c == '.' && !dots_allowed) || static_cast<unsigned char>(c) < ' ')
      return "the name '" + name + "' must not contain " +
             (static_cast<unsigned char>(c) < ' ' ? std::string("control characters")
                                                  : std::string("'") + c + "'");
  return {};
}

}  // namespace ashlar::model
