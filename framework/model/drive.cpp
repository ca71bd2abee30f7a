#include "model/drive.hpp"

#include "model/parameters.hpp"

namespace ashlar::model {

using core::Form;
using core::make_value;

namespace {

constexpr std::array strain_keys = {"xx", "yy", "xy", "zz"};
constexpr std::array stress_keys = {"sxx", "syy", "sxy", "szz"};
constexpr core::Dimension pressure{-1, 1, -2};

core::Schema leg_schema() {
  const auto strain = [](const char* key, const char* doc) { return parameter(key, Form::number, doc); };
  const auto stress = [](const char* key, const char* doc) {
    core::Parameter made = parameter(key, Form::number, doc);
    made.dimension = pressure;
    return made;
  };
  return {"leg",
          "leg",
          "",
          "A straight piece of the path: each component goes evenly to the value named, as a strain or as a "
          "stress; "
          "one that is not named keeps its strain.",
          {strain("xx", "strain in x at the end"), strain("yy", "strain in y at the end"),
           strain("xy", "shear angle (engineering) at the end"),
           strain("zz", "strain out of the plane at the end; 0 as long as nothing is said"),
           stress("sxx", "stress in x at the end, tension positive"), stress("syy", "stress in y at the end"),
           stress("sxy", "shear stress at the end"), stress("szz", "stress out of the plane at the end")},
          {{{"xx", "sxx"}, 0, 1}, {{"yy", "syy"}, 0, 1}, {{"xy", "sxy"}, 0, 1}, {{"zz", "szz"}, 0, 1}}};
}

core::Schema drive_schema() {
  return {
      "drive",
      "drive",
      "Drive",
      "A material law alone, led along a path of strains: what a script for `ashlar drive` returns.",
      {parameter("title", Form::text, "one line that says what it is") |
           otherwise(make_value(std::string("A law along a path"))),
       parameter("material", Form::object, "the law") | required() | of_kind("material"),
       parameter("plane", Form::text, "plane strain or plane stress") | required() |
           one_of({"strain", "stress"}),
       parameter("path", Form::list | Form::function,
                 "legs, or a function of t from 0 to 1 that returns the strains xx, yy, xy and perhaps zz") |
           required() | each(parameter("", Form::object, "") | of_kind("leg")),
       parameter("steps", Form::integer, "steps of each leg, or of the function") |
           otherwise(make_value(50.0)) | within({1, 100000, false, false})}};
}

std::optional<double> said(const core::Settings& settings, const char* key) {
  if (!settings.has(key)) return {};
  return settings.number(key);
}

Leg read_leg(const core::Settings& settings, Plane plane, core::Mistakes& mistakes) {
  Leg leg;
  bool any = false;
  for (std::size_t i = 0; i < 4; ++i) {
    leg.strain[i] = said(settings, strain_keys[i]);
    leg.stress[i] = said(settings, stress_keys[i]);
    any = any || settings.said(strain_keys[i]) || settings.said(stress_keys[i]);
  }
  if (!any) mistakes.add(settings.place, "leads nowhere", "name a strain or a stress, as { yy = -1e-3 }");
  if (plane == Plane::stress)
    for (const char* key : {strain_keys[3], stress_keys[3]})
      if (settings.said(key))
        mistakes.add(settings.place_of(key), "plane stress leaves nothing to say out of the plane",
                     "leave it out, or set plane = \"strain\"");
  return leg;
}

}  // namespace

void register_drive_kinds(core::Registry& registry) {
  registry.add_schema(drive_schema());
  registry.add_schema(leg_schema());
}

Drive read_drive(const core::Value& value, core::Registry& registry, core::Mistakes& mistakes) {
  const core::Settings root = core::check(value, registry.find("drive", "drive")->schema, registry, mistakes);
  Drive drive;
  drive.title = root.text("title");
  drive.plane = root.text("plane") == "stress" ? Plane::stress : Plane::strain;
  drive.steps = static_cast<int>(root.number("steps", 1));
  if (root.entry("material").object) {
    const core::Settings& law = root.object("material");
    drive.law = law.name;
    const core::Registry::Entry* entry = registry.find("material", law.name);
    if (root.has("plane") && entry && law.complete(entry->schema))
      drive.material = registry.make<MakeMaterial>("material", law.name)(law, drive.plane, mistakes);
  }
  const core::Value& path = root.value("path");
  drive.path = path.function();
  drive.path_place = root.place_of("path");
  for (const auto& [name, leg] : root.objects("path"))
    drive.legs.push_back(read_leg(leg, drive.plane, mistakes));
  if (const core::Table* list = path.table(); list && list->items.empty())
    mistakes.add(path.place, "the path has no legs", "name at least one, as { { yy = -1e-3 } }");
  return drive;
}

}  // namespace ashlar::model
