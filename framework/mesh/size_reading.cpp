// Reads a size field from a generator's settings.
#include <algorithm>
#include <cassert>

#include "mesh/size_field.hpp"

namespace ashlar::mesh {

namespace {

std::vector<double> read_map(const Domain& domain, const core::Table& map) {
  std::vector<double> sizes;
  for (const std::string& region : domain.regions) {
    const core::Value* size = map.find(region);
    assert(size && size->quantity());
    sizes.push_back(size->quantity()->value);
  }
  return sizes;
}

void refine_joint(const Domain& domain, const std::string& name, SizeSource source, SizeField& field) {
  const auto joint = std::find_if(domain.joints.begin(), domain.joints.end(),
                                  [&](const JointLine& line) { return line.name == name; });
  if (joint == domain.joints.end()) return;
  const auto is_face = [&](const std::string& border) {
    return std::ranges::count(joint->faces, border) > 0;
  };
  for (const auto& segment : domain.segments) {
    const bool follows = segment.joint == joint - domain.joints.begin();
    if (!follows && std::ranges::none_of(segment.borders, is_face)) continue;
    source.a = domain.points[segment.from];
    source.b = domain.points[segment.to];
    field.add(source);
  }
}

void refine(const Domain& domain, const core::Settings& said, SizeField& field) {
  SizeSource source;
  source.size = said.number("size");
  source.radius = said.number("radius", source.size);
  if (said.has("joint")) return refine_joint(domain, said.text("joint"), source, field);
  if (said.has("at")) {
    const auto [x, y] = said.point("at");
    source.a = source.b = {x, y};
  } else {
    source.a = source.b = domain.named_points.at(said.text("point"));
  }
  field.add(source);
}

}  // namespace

SizeField SizeField::read(const Domain& domain, const core::Settings& settings, double otherwise) {
  std::vector<double> sizes(domain.regions.size(), otherwise);
  const core::Value& size = settings.value("size");
  if (size.table()) sizes = read_map(domain, *size.table());
  if (size.quantity()) std::fill(sizes.begin(), sizes.end(), size.quantity()->value);
  SizeField field(domain, sizes, settings.number("grading"));
  if (size.function()) field.sample(*size.function(), size.place);
  for (const auto& [number, said] : settings.objects("refine")) refine(domain, said, field);
  field.prepare();
  return field;
}

}  // namespace ashlar::mesh
