#include "solve/sections.hpp"

#include <algorithm>
#include <cmath>

#include "core/log.hpp"

namespace ashlar::solve {

using geometry::Point;

namespace {

// Points of borders stand on them to round-off; lines from scripts are off by theirs.
constexpr double on_line = 1e-9;
// Tractions that are less of the stresses beside them are round-off.
constexpr double negligible = 1e-9;

}  // namespace

std::vector<mesh::SectionLine> section_lines(const model::Scene& scene, const model::Model& model,
                                             core::Mistakes& mistakes) {
  std::vector<mesh::SectionLine> lines;
  const double tolerance = on_line * model.length;
  for (const model::SectionData& section : scene.sections) {
    std::vector<Point> path = section.path;
    if (path.empty()) path = mesh::path_along(model.mesh, section.edge, tolerance);
    if (path.empty()) {
      mistakes.add(section.place, "edge '" + section.edge + "' is no single line with two ends in the mesh",
                   "give the section by points");
      continue;
    }
    mesh::SectionLine line = mesh::trace(model.mesh, std::move(path), tolerance);
    line.name = section.name;
    if (line.pieces.empty()) {
      mistakes.add(section.place, "the section '" + section.name + "' lies outside the body");
      continue;
    }
    if (line.ends_inside)
      core::log().warning(core::to_string(section.place) + ": the section '" + section.name +
                          "' ends inside the body: N, V and M leave out what passes round its end, and go to "
                          "the border of the cell there");
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<model::SectionResult> begin_sections(const model::Model& model) {
  std::vector<model::SectionResult> sections;
  for (const mesh::SectionLine& line : model.sections) {
    model::SectionResult& section = sections.emplace_back();
    section.name = line.name;
    section.first = line.first();
    section.last = line.last();
    section.ends_inside = line.ends_inside;
  }
  return sections;
}

void finish_sections(const SectionForcesInput& stage, std::vector<model::SectionResult>& sections) {
  // Around an axis radial forces cancel, and hoop stresses carry some of them: there is no free body.
  for (std::size_t i = 0; i < sections.size() && !stage.model.axisymmetric(); ++i) {
    model::SectionResult& section = sections[i];
    const model::SectionForces& integral = section.integral;
    const model::SectionForces forces = section.forces = section_forces(stage, stage.model.sections[i]);
    section.summed = true;
    const double length = geometry::distance(section.first, section.last);
    const double off = std::max(std::hypot(forces.normal - integral.normal, forces.shear - integral.shear),
                                std::abs(forces.moment - integral.moment) / length);
    section.difference = section.absolute > negligible * section.size ? off / section.absolute : 0;
  }
}

}  // namespace ashlar::solve
