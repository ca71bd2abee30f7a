#pragma once
// What was said: the scenario as checked data. Nothing here is computed.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/registry.hpp"
#include "mesh/domain.hpp"
#include "model/material.hpp"

namespace ashlar::model {

using geometry::Point;

struct RegionData {
  std::string name;
  geometry::Shape shape;   ///< empty for a group of a mesh file
  std::string mesh_group;  ///< physical group of a mesh file; empty for a drawn region
  core::Settings material;
  core::Place place;
};

struct JointData {
  mesh::JointLine line;
  core::Settings settings;  ///< friction, enforcement … as modules extended kind "joint"
};

/// Dofs held where they are, or moved by a number or function of (x, y).
struct SupportData {
  std::string name;                                ///< for the balance: "rock.bottom"
  std::string edge;                                ///< an edge group, or
  std::optional<Point> at;                         ///< the nearest mesh point, or
  std::optional<std::array<Point, 2>> box;         ///< all mesh points inside (two opposite corners)
  std::array<std::optional<core::Value>, 2> move;  ///< by component: number or function [m], nothing: held
                                                   ///< where it is; absent: free
  core::Place place;
};

struct StageData {
  std::string name;
  int parent = -1;          ///< index of the stage it starts from; -1: the unloaded scene
  core::Settings settings;  ///< everything it says and inherits
  std::vector<SupportData> supports;
  core::Place place;
};

struct ProbeData {
  std::string name;
  Point at;
  std::string lip;  ///< "fault.upper", or empty
  std::vector<std::string> quantities;
  core::Place place;
};

/// A line along which stresses are read and forces are summed.
struct SectionData {
  std::string name;
  std::vector<Point> path;  ///< empty: along `edge`
  std::string edge;         ///< "dam.base"
  core::Place place;
};

struct Scene {
  std::string title;
  Plane plane = Plane::strain;
  double thickness = 1;
  std::vector<RegionData> regions;
  std::vector<JointData> joints;
  core::Settings mesh;
  core::Settings element;
  int order = 1;
  core::Settings solver;
  std::vector<StageData> stages;
  std::vector<ProbeData> probes;
  std::vector<SectionData> sections;
  core::Settings outputs;
  bool drawn =
      false;  ///< regions and joints hold no mistake: they can be arranged, even if other parts hold some
  core::Settings root;  ///< the whole scene as checked: provenance lists it

  const RegionData* find_region(const std::string& name) const;
};

/// The framework's own kinds: scene, stage, joint, support, probe, Polygon, Disk …
void register_scene_kinds(core::Registry& registry);

/// Checks the script's table in full and turns it into a Scene. All mistakes go to `mistakes`; the scene is
/// of use only if there are none.
Scene read_scene(const core::Value& value, core::Registry& registry, core::Mistakes& mistakes);

}  // namespace ashlar::model
