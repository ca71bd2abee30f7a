#include "model/drive.hpp"

#include <span>

#include "model/parameters.hpp"

namespace ashlar::model {

using core::Form;
using core::make_value;

namespace {

constexpr std::array strain_keys = {"xx", "yy", "xy", "zz"};
constexpr std::array stress_keys = {"sxx", "syy", "sxy", "szz"};
constexpr std::array joint_keys = {"opening", "pressure", "slip", "shear"};
constexpr core::Dimension pressure{-1, 1, -2};

core::Schema leg_schema() {
  const auto strain = [](const char* key, const char* doc) { return parameter(key, Form::number, doc); };
  const auto stress = [](const char* key, const char* doc) {
    core::Parameter made = parameter(key, Form::number, doc);
    made.dimension = pressure;
    return made;
  };
  return {
      "leg",
      "leg",
      "",
      "A straight piece of the path. Of a material: each component goes evenly to the value named, as a "
      "strain or as a stress; one that is not named keeps its strain. Of a joint: opening or pressure, and "
      "slip or shear, go evenly to the values named; a direction that is not named keeps what led it last, "
      "at first opening 0 and slip 0.",
      {strain("xx", "strain in x at the end"), strain("yy", "strain in y at the end"),
       strain("xy", "shear angle (engineering) at the end"),
       strain("zz", "strain out of the plane at the end; 0 as long as nothing is said"),
       stress("sxx", "stress in x at the end, tension positive"), stress("syy", "stress in y at the end"),
       stress("sxy", "shear stress at the end"), stress("szz", "stress out of the plane at the end"),
       parameter("opening", Form::number, "of a joint: opening at the end, closure negative") | in_metres(),
       stress("pressure", "of a joint: effective pressure at the end, positive in compression"),
       parameter("slip", Form::number, "of a joint: slip at the end") | in_metres(),
       stress("shear", "of a joint: shear at the end")},
      {{{"xx", "sxx"}, 0, 1},
       {{"yy", "syy"}, 0, 1},
       {{"xy", "sxy"}, 0, 1},
       {{"zz", "szz"}, 0, 1},
       {{"opening", "pressure"}, 0, 1},
       {{"slip", "shear"}, 0, 1}}};
}

core::Schema drive_schema() {
  return {
      "drive",
      "drive",
      "Drive",
      "A law alone, of a material or of a joint, led along a path: what a script for `ashlar drive` returns.",
      {parameter("title", Form::text, "one line that says what it is") |
           otherwise(make_value(std::string("A law along a path"))),
       parameter("material", Form::object, "the law of a material") | of_kind("material"),
       parameter("joint", Form::object, "the laws of a joint: { friction = …, normal_law = … }") |
           of_kind("driven_joint"),
       parameter("plane", Form::text, "plane strain or plane stress; of materials only, and required") |
           one_of({"strain", "stress"}),
       parameter(
           "path", Form::list | Form::function,
           "legs, or a function of t from 0 to 1 that returns the strains xx, yy, xy and perhaps zz, or "
           "the opening and the slip") |
           required() | each(parameter("", Form::object, "") | of_kind("leg")),
       parameter("steps", Form::integer, "steps of each leg, or of the function") |
           otherwise(make_value(50.0)) | within({1, 100000, false, false})},
      {{{"material", "joint"}, 1, 1}}};
}

std::optional<double> said(const core::Settings& settings, const char* key) {
  if (!settings.has(key)) return {};
  return settings.number(key);
}

/// Keys of the other kind of law are mistakes.
void refuse(const core::Settings& leg, std::span<const char* const> keys, const char* what,
            const char* advice, core::Mistakes& mistakes) {
  for (const char* key : keys)
    if (leg.said(key)) mistakes.add(leg.place_of(key), what, advice);
}

Leg read_leg(const core::Settings& settings, Plane plane, core::Mistakes& mistakes) {
  Leg leg;
  bool any = false;
  for (std::size_t i = 0; i < 4; ++i) {
    leg.strain[i] = said(settings, strain_keys[i]);
    leg.stress[i] = said(settings, stress_keys[i]);
    any = any || settings.said(strain_keys[i]) || settings.said(stress_keys[i]);
  }
  refuse(settings, joint_keys, "leads a joint, not a material",
         "name a strain or a stress, as { yy = -1e-3 }", mistakes);
  for (const char* key : joint_keys) any = any || settings.said(key);
  if (!any) mistakes.add(settings.place, "leads nowhere", "name a strain or a stress, as { yy = -1e-3 }");
  if (plane == Plane::stress)
    for (const char* key : {strain_keys[3], stress_keys[3]})
      if (settings.said(key))
        mistakes.add(settings.place_of(key), "plane stress leaves nothing to say out of the plane",
                     "leave it out, or set plane = \"strain\"");
  return leg;
}

JointLeg read_joint_leg(const core::Settings& settings, core::Mistakes& mistakes) {
  JointLeg leg{said(settings, "opening"), said(settings, "pressure"), said(settings, "slip"),
               said(settings, "shear")};
  const char* advice = "name opening or pressure, slip or shear, as { pressure = 1*units.MPa }";
  bool any = false;
  for (const char* key : joint_keys) any = any || settings.said(key);
  for (const auto& keys : {strain_keys, stress_keys}) {
    refuse(settings, keys, "leads a material, not a joint", advice, mistakes);
    for (const char* key : keys) any = any || settings.said(key);
  }
  if (!any) mistakes.add(settings.place, "leads nowhere", advice);
  return leg;
}

void read_material(const core::Settings& root, core::Registry& registry, core::Mistakes& mistakes,
                   Drive& drive) {
  drive.plane = root.text("plane") == "stress" ? Plane::stress : Plane::strain;
  if (!root.said("plane"))
    mistakes.add({root.place.file, root.place.line, "plane"},
                 "is missing: a text, plane strain or plane stress", "plane = \"strain\"");
  if (root.entry("material").object) {
    const core::Settings& law = root.object("material");
    drive.law = law.name;
    const core::Registry::Entry* entry = registry.find("material", law.name);
    if (root.has("plane") && entry && law.complete(entry->schema))
      drive.material = registry.make<MakeMaterial>("material", law.name)(law, drive.plane, mistakes);
  }
  for (const auto& [name, leg] : root.objects("path"))
    drive.legs.push_back(read_leg(leg, drive.plane, mistakes));
}

void read_joint(const core::Settings& root, core::Registry& registry, core::Mistakes& mistakes,
                Drive& drive) {
  if (root.said("plane"))
    mistakes.add(root.place_of("plane"), "a point of a joint knows no plane", "leave it out");
  if (root.entry("joint").object) {
    const core::Settings& joint = root.object("joint");
    drive.joint = registry.make<MakeJointDriver>(joint.kind, joint.name)(registry, joint, mistakes);
  }
  for (const auto& [name, leg] : root.objects("path"))
    drive.joint_legs.push_back(read_joint_leg(leg, mistakes));
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
  drive.steps = static_cast<int>(root.number("steps", 1));
  const core::Value& path = root.value("path");
  drive.path = path.function();
  drive.path_place = root.place_of("path");
  if (root.said("joint"))
    read_joint(root, registry, mistakes, drive);
  else
    read_material(root, registry, mistakes, drive);
  if (const core::Table* list = path.table(); list && list->items.empty())
    mistakes.add(path.place, "the path has no legs", "name at least one, as { { yy = -1e-3 } }");
  return drive;
}

}  // namespace ashlar::model
