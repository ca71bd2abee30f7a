// The framework's own kinds as schemas: what `ashlar describe` prints of them stands here.

#include <limits>

#include "model/parameters.hpp"
#include "model/scene.hpp"

namespace ashlar::model {

namespace {

using core::Form;
using core::make_value;
using core::Parameter;
using core::Schema;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr core::Range positive{0, infinity, true, false};

core::Value words(std::initializer_list<const char*> list) {
  core::Table table;
  for (const char* word : list) table.items.push_back(make_value(std::string(word)));
  return make_value(std::move(table));
}

Parameter point(const char* key, const char* doc) {
  return parameter(key, Form::point, doc) | in_metres();
}

Parameter material() {
  return parameter("material", Form::object,
                   "what it is made of; every region needs one, operands of an operation do not") |
         of_kind("material");
}

Schema region(const char* name, const char* constructor, const char* doc, std::vector<Parameter> parameters) {
  parameters.push_back(material());
  return {"region", name, constructor, doc, std::move(parameters)};
}

void add_shapes(core::Registry& registry) {
  registry.add_schema(region(
      "polygon", "Polygon",
      "A region drawn by its corners, in either sense. A corner's third entry names the edge that starts "
      "there; edges without a name cannot be referred to, edges of the same name form one group.",
      {parameter("", Form::table, "corners {x, y, \"name of the edge that starts here\", arc = Arc { … }}") |
           in_metres() | required(),
       parameter("holes", Form::list, "holes, each a list of corners like the polygon's own") |
           each(parameter("", Form::table, "corners of a hole"))}));
  registry.add_schema(region(
      "disk", "Disk", "A full circle.",
      {point("center", "its centre") | required(),
       parameter("radius", Form::number, "its radius") | in_metres() | required() | within(positive),
       parameter("name", Form::text, "name of its edge") | otherwise(make_value(std::string("rim")))}));
  registry.add_schema(region(
      "rectangle", "Rectangle", "A rectangle with sides along the axes.",
      {point("from", "lower left corner") | required(), point("to", "upper right corner") | required(),
       parameter("names", Form::list, "names of its edges: bottom, right, top, left") |
           each(parameter("", Form::text, "")) | otherwise(words({"bottom", "right", "top", "left"}))}));
  const auto operands = [](const char* doc) {
    return std::vector{parameter("", Form::object, doc) | of_kind("region") | required()};
  };
  registry.add_schema(region("difference", "difference",
                             "The first shape without the others. Edges keep their names.",
                             operands("shapes: the first is cut by the others")));
  registry.add_schema(region("union", "union", "All shapes together. Edges keep their names.",
                             operands("shapes to be joined")));
  registry.add_schema(region("intersection", "intersection",
                             "What all shapes have in common. Edges keep their names.",
                             operands("shapes to be intersected")));
  registry.add_schema(region("mesh_group", "MeshGroup", "Cells of a physical group of the mesh file.",
                             {parameter("", Form::text, "the group's name; the region's own by default")}));
  registry.add_schema({"arc",
                       "arc",
                       "Arc",
                       "A circular edge, from its corner to the next.",
                       {point("center", "centre; the shorter way round is meant"),
                        point("through", "a point on the arc, between its ends")},
                       {{{"center", "through"}}}});
}

Schema joint() {
  const Parameter ends =
      parameter(
          "ends", Form::list,
          "at the first and the last end: \"free\" opens at a free surface or on another joint, \"welded\" "
          "stays closed there. An end inside a region is a tip and always welded") |
      each(parameter("", Form::text, "") | one_of({"free", "welded"})) | otherwise(words({"free", "free"}));
  return {
      "joint",
      "joint",
      "Joint",
      "A surface where the mesh is split, along a path or along the border of two regions; or two edges of "
      "bodies that are meshed apart, each for itself, and meet by contact. Borders without a joint are "
      "bonded.",
      {parameter(
           "path", Form::list,
           "points of a polyline; it may cross, meet or end on other joints and borders, but not run beside "
           "them nearer than a tenth of the mesh's edges") |
           each(parameter("", Form::point, "") | in_metres()),
       parameter("between", Form::list, "two regions that share a border") |
           each(parameter("", Form::text, "") | refers("region")),
       parameter("faces", Form::list,
                 "two edges, as region.edge, of bodies that are meshed apart: they may touch, overlap a "
                 "little or lie apart, and their points need not match. With a mesh file: two of its edge "
                 "groups, without common points") |
           each(parameter("", Form::text, "") | refers("edge")),
       parameter("sides", Form::list,
                 "names of the lips, left of the path first. Default: left and right, or the two regions") |
           each(parameter("", Form::text, "")),
       ends},
      {{{"path", "between", "faces"}}}};
}

Schema refinement() {
  const auto length = [](const char* key, const char* doc) {
    return parameter(key, Form::number, doc) | in_metres() | within(positive);
  };
  return {
      "refinement",
      "refinement",
      "",
      "Where a mesh is finer, and near what.",
      {point("at", "a place"), parameter("point", Form::text, "the place of this probe") | refers("probe"),
       parameter("joint", Form::text, "all of this joint") | refers("joint"),
       length("size", "wished size of cells there") | required(),
       length("radius", "the size holds up to this distance; by default as far as the size")},
      {{{"at", "point", "joint"}}}};
}

Schema support() {
  const auto movement = [](const char* key, const char* doc) {
    return parameter(key, Form::number | Form::function, doc) | in_metres();
  };
  return {
      "support",
      "support",
      "Support",
      "Holds or moves mesh points: those of an edge (the entry's own name if nothing else is said), the one "
      "nearest to a point, or all in a box.",
      {parameter("edge", Form::text, "the edge, as region.edge") | refers("edge"),
       point("at", "the nearest mesh point"),
       parameter("box", Form::list, "two opposite corners") |
           each(parameter("", Form::point, "") | in_metres()),
       parameter("fix", Form::text, "components held where they are when the stage begins") |
           one_of({"x", "y", "xy"}),
       movement("ux", "prescribed displacement in x: a number or a function of (x, y)"),
       movement("uy", "prescribed displacement in y: a number or a function of (x, y)")},
      {{{"edge", "at", "box"}, 0, 1}, {{"fix", "ux", "uy"}, 1, 3}}};
}

Parameter supports(const char* doc) {
  return parameter("supports", Form::map, doc) |
         each(parameter("", Form::text | Form::object, "") | one_of({"x", "y", "xy"}) | of_kind("support"));
}

Schema stage() {
  return {
      "stage",
      "stage",
      "Stage",
      "One step of the story. It inherits what it does not say from the stage before, or from its parent; "
      "`key = false` ends what it would inherit.",
      {parameter("", Form::text, "the stage's name") | required(),
       parameter("parent", Form::text, "the earlier stage it starts from; the one before it by default") |
           refers("stage"),
       parameter(
           "steps", Form::integer,
           "equal load steps that lead to the stage's end, for laws that remember their path (friction, "
           "yielding)") |
           within({1, 100000}) | otherwise(make_value(1.0)),
       supports("all supports from this stage on, in place of the inherited ones")}};
}

Schema section() {
  return {"section",
          "section",
          "Section",
          "A line through the body, by points or along an edge. Along it: stresses and displacements, with "
          "both values where they jump. Over it: the force N*n + V*t and the moment M about its middle that "
          "the body on its left exerts on the body on its right, in balance with the loads; t leads from "
          "its first to its last point, n is t turned left. N is positive in tension, M where the end of "
          "the line is pulled more than its beginning; N and V do not depend on its sense. Bodies of "
          "revolution have no such resultants.",
          {parameter("", Form::point, "points of the line, two or more") | in_metres(),
           parameter("edge", Form::text,
                     "in place of points: an edge, as region.edge, with that region on the left") |
               refers("edge")}};
}

void add_outputs(core::Registry& registry) {
  registry.add_schema({"field", "displacement", "", "Displacement of the points [m].", {}});
  registry.add_schema(
      {"joint_field", "opening", "", "Normal distance of the lips [m]; negative: penetration.", {}});
  registry.add_schema({"joint_field", "slip", "", "Movement of the first lip along the path [m].", {}});
  registry.add_schema(
      {"joint_field", "pressure", "", "Contact pressure (effective), compression positive [Pa].", {}});
  registry.add_schema({"joint_field", "shear_stress", "", "Shear that resists slip [Pa].", {}});
  registry.add_schema({"joint_field", "water_pressure", "", "Pressure of water between the lips [Pa].", {}});
  registry.add_schema(
      {"joint_field", "utilisation", "", "Shear over the shear strength at the present pressure.", {}});
  registry.add_schema(
      {"probe",
       "probe",
       "Probe",
       "Values at the mesh point nearest to a place.",
       {parameter("", Form::object, "fields to read; displacement by default") | of_kind("field"),
        point("at", "the place") | required(),
        parameter("lip", Form::text, "read on this lip of a joint, as joint.side") | refers("lip")}});
  registry.add_schema(section());
  registry.add_schema(
      {"outputs",
       "outputs",
       "",
       "What a run writes.",
       {parameter("fields", Form::list, "fields to write; all by default") |
            each(parameter("", Form::object, "") | of_kind("field")),
        parameter("probes", Form::map, "places to read, by name") |
            each(parameter("", Form::object, "") | of_kind("probe")),
        parameter("sections", Form::map, "lines to read stresses and forces along, by name") |
            each(parameter("", Form::object, "") | of_kind("section")),
        parameter("joints", Form::map, "joint profiles to write; all of all joints by default") |
            refers("joint") |
            each(parameter("", Form::list, "") |
                 each(parameter("", Form::object, "") | of_kind("joint_field"))),
        parameter("pictures", Form::boolean | Form::list,
                  "false for none, or a list: mesh, deformed, joints, sections, crosses, ux, uy, sxx, syy, "
                  "sxy, szz, s1, s3, tmax, "
                  "von_mises, and names of fields") |
            each(parameter("", Form::text, "") | refers("picture")) | otherwise(make_value(true)),
        parameter("picture_stages", Form::boolean | Form::list,
                  "stages to draw: true for all, or a list of names; the last by default. Pictures of other "
                  "stages than the last lie in a folder of their own") |
            refers("stage") | each(parameter("", Form::text, "")),
        parameter("formats", Form::list, "kinds of files") |
            each(parameter("", Form::text, "") | one_of({"hdf5", "vtu", "csv", "png", "svg"})) |
            otherwise(words({"hdf5", "vtu", "csv", "png"}))}});
}

Schema scene() {
  return {
      "scene",
      "scene",
      "Scene",
      "The whole scenario: what a script returns.",
      {parameter("title", Form::text, "one line that says what it is") | required(),
       parameter(
           "plane", Form::text,
           "plane strain, plane stress, or a body of revolution about x = 0 whose half section this is: "
           "x is its radius, y its axis, zz the direction around; forces are those of the whole body") |
           required() | one_of({"strain", "stress", "axisymmetric"}),
       parameter("thickness", Form::number, "out of plane; forces are for this thickness") | in_metres() |
           otherwise(make_value(1.0)) | within(positive),
       parameter("geometry", Form::map, "the regions, by name") | required() |
           each(parameter("", Form::object, "") | of_kind("region")),
       parameter("joints", Form::map, "the joints, by name") |
           each(parameter("", Form::object, "") | of_kind("joint")),
       parameter("mesh", Form::object, "how the regions are meshed") | required() | of_kind("mesh"),
       parameter("element", Form::object, "the cells' element; may be left out if there is only one") |
           of_kind("element"),
       parameter("order", Form::integer, "order of the element") | otherwise(make_value(1.0)) |
           within({1, 9, false, false}),
       parameter("solver", Form::object, "the linear solver; may be left out if there is only one") |
           of_kind("solver"),
       parameter("condition_estimate", Form::boolean,
                 "true: estimate the condition number of each stage's linear system; costs a few solves") |
           otherwise(make_value(false)),
       supports("what is held, by edge or by name"),
       parameter("stages", Form::list, "what happens, in order") | required() |
           each(parameter("", Form::object, "") | of_kind("stage")),
       parameter("outputs", Form::object, "what is written") | of_kind("outputs") |
           otherwise(make_value(core::Table{}))}};
}

}  // namespace

void register_scene_kinds(core::Registry& registry) {
  registry.add_schema(scene());
  registry.add_schema(joint());
  registry.add_schema(refinement());
  registry.add_schema(support());
  registry.add_schema(stage());
  add_shapes(registry);
  add_outputs(registry);
}

}  // namespace ashlar::model
