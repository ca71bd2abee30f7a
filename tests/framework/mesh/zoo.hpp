#pragma once
// Domains that are hard for mesh generators, and settings for generators in tests.

#include <gtest/gtest.h>

#include "core/registry.hpp"
#include "core/schema.hpp"
#include "framework/mesh/mesh_shapes.hpp"
#include "model/scene.hpp"

namespace ashlar::mesh {

inline Domain zoo_domain(const std::vector<RegionShape>& regions, const std::vector<JointLine>& joints = {},
                         double chord = 0.25) {
  core::Mistakes mistakes;
  Domain domain = make_domain(regions, joints, chord, mistakes);
  EXPECT_TRUE(mistakes.empty()) << core::to_string(mistakes.list().front());
  return domain;
}

inline geometry::Shape rectangle(double width, double height) {
  return polygon({{0, 0}, {width, 0}, {width, height}, {0, height}}, {"bottom", "right", "top", "left"});
}

inline geometry::Shape without(geometry::Shape from, geometry::Shape what) {
  return operation(geometry::Shape::Kind::difference, {std::move(from), std::move(what)});
}

/// Example 4 of the paper: dam on a jointed foundation; the joint's tip is at (10, 4).
inline Domain jointed_dam() {
  return zoo_domain(
      {region("rock", polygon({{0, 0}, {25, 0}, {25, 10}, {0, 10}}, {"bottom", "right", "ground", "left"})),
       region("dam", polygon({{10, 10}, {15, 10}, {12, 15}, {10, 15}},
                             {"base", "downstream", "crest", "upstream"}))},
      {joint("fault", {{4, 10}, {10, 4}})});
}

inline Domain wedge() {
  return zoo_domain({region("wedge", polygon({{0, 0}, {8, 0}, {8, 0.7}}))});  // 5°
}

inline Domain layered() {
  return zoo_domain({region("low", rectangle(6, 2)),
                     region("seam", polygon({{0, 2}, {6, 2}, {6, 2.1}, {0, 2.1}})),
                     region("high", polygon({{0, 2.1}, {6, 2.1}, {6, 4}, {0, 4}}))});
}

struct Named {
  std::string name;
  Domain domain;
  double size;
};

inline std::vector<Named> zoo() {
  std::vector<Named> all;
  all.push_back({"jointed_dam", jointed_dam(), 0.6});
  all.push_back(
      {"l_shape", zoo_domain({region("l", polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}))}), 0.1});
  all.push_back(
      {"plate_with_hole", zoo_domain({region("plate", without(rectangle(4, 4), circle({2, 2}, 0.5)))}), 0.2});
  all.push_back(
      {"annulus", zoo_domain({region("ring", without(circle({0, 0}, 2), circle({0, 0}, 1)))}), 0.15});
  all.push_back({"crossing_joints",
                 zoo_domain({region("block", rectangle(4, 4))},
                            {joint("x", {{0.5, 0.5}, {3.5, 3.5}}), joint("y", {{0.5, 3}, {3.5, 1}}),
                             joint("t", {{2.75, 1.5}, {3.2, 0.7}}), joint("to_border", {{0, 2}, {1, 2.2}})}),
                 0.15});
  all.push_back({"wedge", wedge(), 0.2});
  all.push_back({"layered", layered(), 0.3});
  all.push_back({"steep_joint",
                 zoo_domain({region("block", rectangle(4, 2))}, {joint("flat", {{0.5, 2}, {3, 1.75}})}),
                 0.2});
  all.push_back(
      {"detail", zoo_domain({region("block", without(rectangle(4, 4), circle({2, 2}, 0.01)))}), 0.4});
  return all;
}

/// Settings of a mesh generator as `check` would fill them in.
class GeneratorSettings {
 public:
  GeneratorSettings& set(const std::string& key, core::Value value) {
    settings_.entries.push_back({key, std::move(value), true, {}, nullptr, {}});
    return *this;
  }
  GeneratorSettings& set(const std::string& key, double value) { return set(key, core::make_value(value)); }
  GeneratorSettings& set(const std::string& key, const std::string& value) {
    return set(key, core::make_value(value));
  }
  /// An entry of a list or map of objects, checked by the schema of its kind.
  GeneratorSettings& add(const std::string& key, const std::string& name, const core::Value& value,
                         const core::Schema& schema) {
    core::Mistakes mistakes;
    core::Settings object = core::check(value, schema, core::Registry(), mistakes);
    EXPECT_TRUE(mistakes.empty()) << core::to_string(mistakes.list().front());
    auto& entries = settings_.entries;
    if (entries.empty() || entries.back().key != key) entries.push_back({key, {}, true, {}, nullptr, {}});
    entries.back().objects.emplace_back(name, std::move(object));
    return *this;
  }
  /// One item of `refine`: { what = target, size = size, radius = radius }.
  GeneratorSettings& refine(const std::string& what, core::Value target, double size, double radius) {
    core::Registry registry;
    model::register_scene_kinds(registry);
    core::Table table;
    table.entries = {
        {what, std::move(target)}, {"size", core::make_value(size)}, {"radius", core::make_value(radius)}};
    return add("refine", "1", core::make_value(std::move(table)),
               registry.find("refinement", "refinement")->schema);
  }
  /// Adds the keys that the schema knows and that were not said, without a value.
  core::Settings with(const std::vector<std::pair<std::string, core::Value>>& defaults) const {
    core::Settings settings = settings_;
    for (const auto& [key, value] : defaults) {
      bool known = false;
      for (const auto& entry : settings.entries) known = known || entry.key == key;
      if (!known) settings.entries.push_back({key, value, false, {}, nullptr, {}});
    }
    return settings;
  }

 private:
  core::Settings settings_;
};

inline core::Value list_of(std::vector<core::Value> items) {
  core::Table table;
  table.items = std::move(items);
  return core::make_value(std::move(table));
}

inline core::Value point_value(Point p) {
  return list_of({core::make_value(p.x), core::make_value(p.y)});
}

}  // namespace ashlar::mesh
