#pragma once
// Settings of a region → its shape.

#include "core/registry.hpp"
#include "geometry/shape.hpp"

namespace ashlar::model {

/// The shape of a checked region (Polygon, Disk, Rectangle or an operation). Mistakes: fewer than three
/// corners, corners that coincide, a border that crosses itself, arcs that cannot be.
geometry::Shape read_shape(const core::Settings& region, const core::Registry& registry,
                           core::Mistakes& mistakes);

/// False if a ring is missing or empty: part of the shape could not be read.
bool is_whole(const geometry::Shape& shape);

/// Names of all edges of a shape, in their order, each once.
std::vector<std::string> edge_names(const geometry::Shape& shape);

/// Why `name` cannot name a region, joint, edge or stage; empty if it can. Names end up in file names and
/// paths.
std::string bad_name(const std::string& name, bool dots_allowed = false);

}  // namespace ashlar::model
