// Reads a size field from a generator's settings.
#include <algorithm>

#include "mesh/size_field.hpp"

namespace ashlar::mesh {

namespace {

using core::Mistakes;
using core::Table;
using core::Value;

const core::Dimension metre{1, 0, 0};

double positive_length(const Value& value, Mistakes& mistakes) {
  const auto number = core::read_number(value, metre, mistakes);
  if (number && !(*number > 0 && std::isfinite(*number))) {
    mistakes.add(value.place, "must be above 0 m", "a length such as 0.5*units.m");
  }
  return number.value_or(1.0);
}

std::vector<double> read_map(const Domain& domain, const Value& value, Mistakes& mistakes) {
  std::vector<double> sizes(domain.regions.size(), 0.0);
  for (const auto& [name, entry] : value.table()->entries) {
    const auto found = std::find(domain.regions.begin(), domain.regions.end(), name);
    if (found == domain.regions.end()) {
      mistakes.add(entry.place, "no region is named '" + name + "'",
                   core::did_you_mean(name, domain.regions));
    } else {
      sizes[found - domain.regions.begin()] = positive_length(entry, mistakes);
    }
  }
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    if (sizes[r] > 0) continue;
    mistakes.add(value.place, "region '" + domain.regions[r] + "' has no size", "give one for every region");
    sizes[r] = 1;
  }
  return sizes;
}

const std::vector<std::string> refine_keys = {"at", "point", "joint", "size", "radius"};

void check_keys(const Value& item, Mistakes& mistakes) {
  int targets = 0;
  for (const auto& [key, value] : item.table()->entries) {
    if (std::find(refine_keys.begin(), refine_keys.end(), key) == refine_keys.end()) {
      mistakes.add(value.place, "unknown key '" + key + "'", core::did_you_mean(key, refine_keys));
    }
    targets += key == "at" || key == "point" || key == "joint";
  }
  if (targets != 1) {
    mistakes.add(item.place, "a refinement needs exactly one of at, point and joint",
                 "{ at = {x, y}, size = h, radius = r }");
  }
  if (!item.table()->find("size")) mistakes.add(item.place, "a refinement needs a size", {});
}

void refine_joint(const Domain& domain, const Value& name, SizeSource source, SizeField& field,
                  Mistakes& mistakes) {
  std::vector<std::string> names;
  for (const auto& joint : domain.joints) names.push_back(joint.name);
  const std::string word = name.text() ? *name.text() : std::string();
  const auto found = std::find(names.begin(), names.end(), word);
  if (found == names.end()) {
    mistakes.add(name.place, "no joint is named '" + word + "'", core::did_you_mean(word, names));
    return;
  }
  for (const auto& segment : domain.segments) {
    if (segment.joint != static_cast<Index>(found - names.begin())) continue;
    source.a = domain.points[segment.from];
    source.b = domain.points[segment.to];
    field.add(source);
  }
}

void refine_point(const Domain& domain, const Value& name, SizeSource source, SizeField& field,
                  Mistakes& mistakes) {
  std::vector<std::string> names;
  for (const auto& [known, point] : domain.named_points) names.push_back(known);
  const std::string word = name.text() ? *name.text() : std::string();
  const auto found = domain.named_points.find(word);
  if (found == domain.named_points.end()) {
    mistakes.add(name.place, "no point is named '" + word + "'", core::did_you_mean(word, names));
    return;
  }
  source.a = source.b = found->second;
  field.add(source);
}

void read_refinement(const Domain& domain, const Value& item, SizeField& field, Mistakes& mistakes) {
  if (!item.table()) {
    mistakes.add(item.place, "must be a table, is " + item.type_name(),
                 "{ at = {x, y}, size = h, radius = r }");
    return;
  }
  check_keys(item, mistakes);
  const Table& table = *item.table();
  SizeSource source;
  if (const Value* size = table.find("size")) source.size = positive_length(*size, mistakes);
  source.radius = source.size;
  if (const Value* radius = table.find("radius")) source.radius = positive_length(*radius, mistakes);
  if (const Value* at = table.find("at")) {
    if (const auto point = core::read_point(*at, metre, mistakes)) {
      source.a = source.b = {point->first, point->second};
      field.add(source);
    }
  }
  if (const Value* name = table.find("point")) refine_point(domain, *name, source, field, mistakes);
  if (const Value* name = table.find("joint")) refine_joint(domain, *name, source, field, mistakes);
}

}  // namespace

SizeField SizeField::read(const Domain& domain, const core::Settings& settings, double otherwise) {
  Mistakes mistakes;
  std::vector<double> sizes(domain.regions.size(), otherwise);
  const Value* size = settings.has("size") ? &settings.value("size") : nullptr;
  if (size && size->table()) sizes = read_map(domain, *size, mistakes);
  if (size && size->quantity()) std::fill(sizes.begin(), sizes.end(), positive_length(*size, mistakes));
  SizeField field(domain, sizes, settings.number("grading"));
  if (size && size->function()) field.sample(*size->function(), size->place);
  if (settings.has("refine") && settings.value("refine").table()) {
    for (const Value& item : settings.value("refine").table()->items) {
      read_refinement(domain, item, field, mistakes);
    }
  }
  mistakes.throw_if_any();
  field.prepare();
  return field;
}

}  // namespace ashlar::mesh
