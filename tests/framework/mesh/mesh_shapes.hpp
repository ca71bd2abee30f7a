#pragma once
// Short words for regions and joints in tests.

#include "mesh/domain.hpp"

namespace ashlar::mesh {

inline geometry::Shape polygon(const std::vector<Point>& corners,
                               const std::vector<std::string>& names = {}) {
  geometry::Shape shape;
  shape.rings.emplace_back();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    shape.rings[0].push_back({corners[i], i < names.size() ? names[i] : "", std::nullopt, {}});
  }
  return shape;
}

inline geometry::Shape circle(Point center, double radius, const std::string& name = {}) {
  geometry::Shape shape = polygon({center + Point{radius, 0}}, {name});
  shape.rings[0][0].arc = geometry::Arc{center, true};
  return shape;
}

inline geometry::Shape operation(geometry::Shape::Kind kind, std::vector<geometry::Shape> operands) {
  geometry::Shape shape;
  shape.kind = kind;
  shape.operands = std::move(operands);
  return shape;
}

inline RegionShape region(const std::string& name, const geometry::Shape& shape) {
  return {name, shape, {}};
}

inline JointLine joint(const std::string& name, const std::vector<Point>& path) {
  JointLine line;
  line.name = name;
  line.path = path;
  return line;
}

}  // namespace ashlar::mesh
