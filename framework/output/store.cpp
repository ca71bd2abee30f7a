#include "output/store.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "output/files.hpp"
#include "output/hdf5.hpp"
#include "output/provenance.hpp"
#include "output/tables.hpp"

#include "output/joint_columns.hpp"

namespace ashlar::output {

using hdf5::attribute;
using hdf5::Handle;
using hdf5::link_name;
using hdf5::make_group;
using hdf5::write;
using mesh::Index;

namespace {

/// As a scene says it.
std::string plane_word(model::Plane plane) {
  return plane == model::Plane::strain ? "strain" : plane == model::Plane::stress ? "stress" : "axisymmetric";
}

// Column by column: what pandas, h5py and MATLAB read without knowing of structs.
template <class Row, class Number>
std::vector<Number> column(const std::vector<Row>& rows, Number (*value)(const Row&)) {
  std::vector<Number> numbers;
  numbers.reserve(rows.size());
  for (const Row& row : rows) numbers.push_back(value(row));
  return numbers;
}

template <class Row>
void write_column(const Handle& group, const std::string& name, const std::vector<Row>& rows,
                  double (*value)(const Row&), const std::string& unit) {
  write(group, name, std::span<const double>(column(rows, value)), 1, unit);
}

template <class Row>
void write_column(const Handle& group, const std::string& name, const std::vector<Row>& rows,
                  Index (*value)(const Row&)) {
  write(group, name, std::span<const Index>(column(rows, value)));
}

void write_lips(const Handle& parent, const mesh::JointLips& joint) {
  const Handle group = make_group(parent, link_name(joint.name));
  attribute(group, "sides", std::vector<std::string>{joint.sides[0], joint.sides[1]});
  for (int side = 0; side < 2; ++side) {
    using Lip = mesh::LipEdge;
    const std::vector<Lip>& lip = joint.lips[side];
    const Handle edges = make_group(group, side == 0 ? "lip_0" : "lip_1");
    write_column<Lip>(edges, "cell", lip, [](const Lip& e) { return e.cell; });
    write_column<Lip>(edges, "from", lip, [](const Lip& e) { return e.from; });
    write_column<Lip>(edges, "to", lip, [](const Lip& e) { return e.to; });
    write_column<Lip>(
        edges, "s_from", lip, [](const Lip& e) { return e.s_from; }, "m");
    write_column<Lip>(
        edges, "s_to", lip, [](const Lip& e) { return e.s_to; }, "m");
  }
}

void write_mesh(const Handle& file, const mesh::Mesh& mesh) {
  const Handle group = make_group(file, "mesh");
  std::vector<double> points;
  points.reserve(2 * mesh.points.size());
  for (const geometry::Point& p : mesh.points) points.insert(points.end(), {p.x, p.y});
  write(group, "points", std::span<const double>(points), 2, "m");
  write(group, "cell_offsets", mesh.cell_points.offsets());
  write(group, "cell_points", mesh.cell_points.values());
  write(group, "cell_region", std::span<const Index>(mesh.cell_region));
  write(group, "regions", mesh.regions);
  const Handle edge_groups = make_group(group, "edge_groups");
  for (const auto& [name, edges] : mesh.edge_groups) {
    std::vector<Index> ends;
    for (const Index edge : edges)
      ends.insert(ends.end(), mesh.edge_points[edge].begin(), mesh.edge_points[edge].end());
    write(edge_groups, link_name(name), std::span<const Index>(ends), 2);
  }
  const Handle point_groups = make_group(group, "point_groups");
  for (const auto& [name, members] : mesh.point_groups)
    write(point_groups, link_name(name), std::span<const Index>(members));
  const Handle joints = make_group(group, "joints");
  for (const mesh::JointLips& joint : mesh.joints) write_lips(joints, joint);
}

void write_fields(const Handle& stage, const model::StageResult& result) {
  const Handle group = make_group(stage, "fields");
  std::set<std::string> taken;
  for (const model::FieldResult& field : result.fields) {
    const std::string on = field.on == model::FieldResult::On::points ? "points" : "cells";
    std::string name = link_name(field.name);
    if (!taken.insert(name).second) taken.insert(name += "_" + on);
    write(group, name, std::span<const double>(field.values), static_cast<std::size_t>(field.width));
    attribute(group, "unit", field.unit, name);
    attribute(group, "on", on, name);
    attribute(group, "components", field.components, name);
  }
}

void write_joint(const Handle& parent, const model::JointResult& joint) {
  using Row = model::JointResult::Row;
  const Handle group = make_group(parent, link_name(joint.name));
  write_column<Row>(
      group, "s", joint.rows, [](const Row& r) { return r.s; }, "m");
  write_column<Row>(
      group, "x", joint.rows, [](const Row& r) { return r.at.x; }, "m");
  write_column<Row>(
      group, "y", joint.rows, [](const Row& r) { return r.at.y; }, "m");
  for (const JointColumn& column : joint_columns) {
    std::vector<double> values;
    for (const Row& row : joint.rows) values.push_back(row.*column.value);
    write(group, column.name, std::span<const double>(values), 1, column.unit);
  }
  write_column<Row>(group, "closed", joint.rows, [](const Row& r) { return Index{r.closed ? 1 : 0}; });
  write_column<Row>(group, "slipping", joint.rows,
                    [](const Row& r) { return Index{r.state == Row::State::slip ? 1 : 0}; });
  write_column<Row>(group, "piece", joint.rows, [](const Row& r) { return Index{r.piece}; });
  for (const JointNumber& number : joint_numbers) attribute(group, number.name, joint.*number.value);
  const double resultant[] = {joint.resultant.x, joint.resultant.y, joint.resultant.moment};
  attribute(group, "resultant", std::span<const double>(resultant));
  attribute(group, "closed_points", joint.closed);
  attribute(group, "slipping_points", joint.slipping);
}

void write_section(const Handle& parent, const model::SectionResult& section) {
  using Row = model::SectionResult::Row;
  const Handle group = make_group(parent, link_name(section.name));
  write_column<Row>(
      group, "s", section.rows, [](const Row& r) { return r.s; }, "m");
  write_column<Row>(
      group, "x", section.rows, [](const Row& r) { return r.at.x; }, "m");
  write_column<Row>(
      group, "y", section.rows, [](const Row& r) { return r.at.y; }, "m");
  write_column<Row>(group, "piece", section.rows, [](const Row& r) { return Index{r.piece}; });
  std::vector<std::string> sides, regions;
  for (const Row& row : section.rows) {
    sides.push_back(side_name(row.side));
    regions.push_back(row.region);
  }
  write(group, "side", sides);
  write(group, "region", regions);
  for (std::size_t k = 0; k < section.columns.size(); ++k) {
    std::vector<double> values;
    for (const Row& row : section.rows) values.push_back(row.values[k]);
    write(group, link_name(section.columns[k].name), std::span<const double>(values), 1,
          section.columns[k].unit);
  }
  const auto write_forces = [&](const char* name, const model::SectionForces& forces) {
    const double numbers[] = {forces.normal, forces.shear, forces.moment};
    attribute(group, name, std::span<const double>(numbers));
  };
  if (section.summed) write_forces("forces", section.forces);
  if (section.integrated) write_forces("integral", section.integral);
  if (section.integrated) attribute(group, "difference", section.difference);
  const double first[] = {section.first.x, section.first.y}, last[] = {section.last.x, section.last.y};
  attribute(group, "first", std::span<const double>(first));
  attribute(group, "last", std::span<const double>(last));
  attribute(group, "ends_inside", section.ends_inside ? 1 : 0);
}

void write_probe(const Handle& parent, const model::ProbeResult& probe) {
  const Handle group = make_group(parent, link_name(probe.name));
  std::vector<std::string> quantities;
  std::vector<double> values;
  for (const auto& [quantity, value] : probe.values) {
    quantities.push_back(quantity);
    values.push_back(value);
  }
  write(group, "quantities", quantities);
  write(group, "values", std::span<const double>(values));
  const double asked[] = {probe.asked.x, probe.asked.y}, at[] = {probe.at.x, probe.at.y};
  attribute(group, "asked", std::span<const double>(asked));
  attribute(group, "at", std::span<const double>(at));
}

void write_forces(const Handle& group, const std::string& name,
                  const std::vector<std::pair<std::string, model::Resultant>>& forces) {
  std::vector<std::string> names;
  std::vector<double> values;
  for (const auto& [each, force] : forces) {
    names.push_back(each);
    values.insert(values.end(), {force.x, force.y, force.moment});
  }
  write(group, name + "_names", names);
  write(group, name, std::span<const double>(values), 3);
}

void write_balance(const Handle& stage, const model::Balance& balance) {
  const Handle group = make_group(stage, "balance");
  write_forces(group, "loads", balance.loads);
  write_forces(group, "reactions", balance.reactions);
  const double load[] = {balance.load.x, balance.load.y, balance.load.moment};
  const double reaction[] = {balance.reaction.x, balance.reaction.y, balance.reaction.moment};
  attribute(group, "load", std::span<const double>(load));
  attribute(group, "reaction", std::span<const double>(reaction));
  attribute(group, "relative_error", balance.relative_error);
}

void write_iterations(const Handle& stage, const model::StageResult& result) {
  using Row = model::Iteration;
  const std::vector<Row>& iterations = result.iterations;
  const Handle group = make_group(stage, "iterations");
  write_column<Row>(group, "step", iterations, [](const Row& r) { return Index{r.step}; });
  write_column<Row>(group, "number", iterations, [](const Row& r) { return Index{r.number}; });
  write_column<Row>(
      group, "residual", iterations, [](const Row& r) { return r.residual; }, "");
  const Handle columns = make_group(group, "facts");
  for (const std::string& fact : fact_names({&result, 1})) {
    std::vector<double> values;
    for (const Row& row : iterations)
      values.push_back(fact_of(row, fact).value_or(std::numeric_limits<double>::quiet_NaN()));
    write(columns, link_name(fact), std::span<const double>(values));
  }
}

void write_extremes(const Handle& stage, const std::vector<model::Extreme>& extremes) {
  const Handle group = make_group(stage, "extremes");
  std::vector<std::string> quantities, units;
  std::vector<double> values;
  for (const model::Extreme& e : extremes) {
    quantities.push_back(e.quantity);
    units.push_back(e.unit);
    values.insert(values.end(),
                  {e.least, e.least_at.x, e.least_at.y, e.greatest, e.greatest_at.x, e.greatest_at.y});
  }
  write(group, "quantities", quantities);
  write(group, "units", units);
  write(group, "values", std::span<const double>(values), 6);
}

void write_stage(const Handle& stages, const std::string& name, const model::StageResult& result) {
  const Handle stage = make_group(stages, name);
  attribute(stage, "name", result.name);
  attribute(stage, "converged", result.converged ? 1 : 0);
  attribute(stage, "reason", result.reason);
  attribute(stage, "advice", result.advice);
  attribute(stage, "effects", result.effects);
  attribute(stage, "factored", result.factored ? 1 : 0);
  attribute(stage, "unknowns", static_cast<int>(result.unknowns));
  attribute(stage, "kept", static_cast<int>(result.kept));
  attribute(stage, "solver", result.solver);
  attribute(stage, "backward_error", result.backward_error);
  attribute(stage, "forward_error", result.forward_error);
  if (result.condition > 0) attribute(stage, "condition", result.condition);
  write_iterations(stage, result);
  if (!result.converged) return;
  write_fields(stage, result);
  const Handle joints = make_group(stage, "joints");
  for (const model::JointResult& joint : result.joints) write_joint(joints, joint);
  const Handle probes = make_group(stage, "probes");
  for (const model::ProbeResult& probe : result.probes) write_probe(probes, probe);
  const Handle sections = make_group(stage, "sections");
  for (const model::SectionResult& section : result.sections) write_section(sections, section);
  write_balance(stage, result.balance);
  write_extremes(stage, result.extremes);
}

}  // namespace

std::string store_bytes(const RunRecord& record, const std::string& date) {
  const Handle file = hdf5::memory_file();
  const Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose, "/");
  attribute(root, "format", std::string("ashlar results"));
  attribute(root, "format_version", store_format_version);
  attribute(root, "title", record.scene.title);
  attribute(root, "plane", plane_word(record.scene.plane));
  attribute(root, "thickness", record.scene.thickness);
  attribute(root, "converged", record.result.converged ? 1 : 0);
  write_mesh(file, record.model.mesh);
  const Handle stages = make_group(file, "stages");
  for (std::size_t i = 0; i < record.result.stages.size(); ++i) {
    const model::StageResult& stage = record.result.stages[i];
    const std::string number = std::to_string(i + 1);
    const std::string name = (number.size() < 2 ? "0" : "") + number + " " + link_name(stage.name);
    write_stage(stages, name, stage);
  }
  write_provenance(make_group(file, "provenance"), record, date);
  return hdf5::image(file);
}

}  // namespace ashlar::output
