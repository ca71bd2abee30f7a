#include "output/summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "output/tables.hpp"
#include "output/text_table.hpp"

namespace ashlar::output {

namespace {

constexpr std::size_t width = 96;
constexpr std::size_t most_iterations = 12;  // a failed stage may have hundreds; its end tells most
using Rows = std::vector<std::vector<std::string>>;

std::string number(const char* format, double value) {
  char text[96];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string bytes_text(double bytes) {
  if (bytes < 1e6) return number("%.0f kB", bytes / 1e3);
  return bytes < 1e9 ? number("%.1f MB", bytes / 1e6) : number("%.2f GB", bytes / 1e9);
}

// What round-off leaves of a sum of large forces reads as the zero that it is.
std::string force(double value, double scale, const char* unit) {
  return std::abs(value) <= 1e-9 * scale ? "0" : short_quantity(value, unit);
}

std::vector<std::string> force_row(const std::string& name, const model::Resultant& r,
                                   const model::Resultant& scale) {
  const double forces = std::max(scale.x, scale.y);
  return {"  " + name, force(r.x, forces, "N"), force(r.y, forces, "N"),
          force(r.moment, scale.moment, "N*m")};
}

void widen(model::Resultant& scale, const model::Resultant& r) {
  scale.x = std::max(scale.x, std::abs(r.x));
  scale.y = std::max(scale.y, std::abs(r.y));
  scale.moment = std::max(scale.moment, std::abs(r.moment));
}

void add_balance(const model::StageResult& stage, Rows& rows) {
  const model::Balance& b = stage.balance;
  model::Resultant scale;
  for (const auto& [name, r] : b.loads) widen(scale, r);
  for (const auto& [name, r] : b.reactions) widen(scale, r);
  rows.push_back({stage.name});
  for (const auto& [name, r] : b.loads) rows.push_back(force_row(name, r, scale));
  for (const auto& [name, r] : b.reactions) rows.push_back(force_row("reaction " + name, r, scale));
  const model::Resultant sum{b.load.x + b.reaction.x, b.load.y + b.reaction.y,
                             b.load.moment + b.reaction.moment};
  auto row = force_row("sum", sum, scale);
  row.push_back(number("relative error %.1e", b.relative_error));
  rows.push_back(std::move(row));
}

}  // namespace

std::string simulated_text(const model::Plan& plan, const model::RunResult& result) {
  if (plan.stages.empty()) return {};
  std::string text = "Simulated\n";
  for (std::size_t s = 0; s < plan.stages.size(); ++s) {
    const model::StagePlan& stage = plan.stages[s];
    std::string line = "  " + stage.stage + ":";
    for (std::size_t i = 0; i < stage.calls.size(); ++i) line += (i ? ", " : " ") + stage.calls[i].effect;
    if (s >= result.good().size())
      line = "  " + stage.stage + (s < result.stages.size() ? ": did not converge" : ": not run");
    text += "  " + wrapped(line, width - 2, 6);
  }
  if (plan.left_out.empty()) return text;
  text += "Not simulated\n";
  for (const core::EffectEntry& effect : plan.left_out)
    text += "  " + wrapped(effect.name + ": " + effect.left_out, width - 2, 6);
  return text;
}

std::string mesh_text(const mesh::MeshReport& report, const model::Model& model) {
  Rows rows = {
      {"cells", std::to_string(report.cells) + ", corners " + std::to_string(report.corners_min) + " to " +
                    std::to_string(report.corners_max) + number(", mean %.2f", report.corners_mean)},
      {"points", std::to_string(report.points) + ", unknowns " + std::to_string(model.dofs.size()) +
                     " with the held ones"},
      {"size (√area)", short_quantity(report.size_min, "m") + " to " + short_quantity(report.size_max, "m") +
                           ", mean " + short_quantity(report.size_mean, "m")},
      {"shortest edge", short_quantity(report.shortest_edge, "m") +
                            number(", least ratio to its cell's diameter %.2g", report.shortest_edge_ratio)},
      {"roundness", number("mean %.2f", report.roundness_mean) +
                        number(", least %.2f", report.roundness_min) + " at " +
                        place_text(report.worst_cell.x, report.worst_cell.y)}};
  for (const auto& [name, value] : report.notes) rows.push_back({name, value});
  return "Mesh\n" + aligned(rows, 2);
}

std::string balance_text(const model::RunResult& result, model::Plane plane) {
  if (result.good().empty()) return {};
  Rows rows = {{"", "x", "y", "moment about (0, 0)"}};
  for (const model::StageResult& stage : result.good()) add_balance(stage, rows);
  const char* whole = plane == model::Plane::axisymmetric ? "of the whole body" : "on the modelled thickness";
  return "Loads and reactions (" + std::string(whole) + ")\n" + aligned(rows);
}

std::string extremes_text(const model::RunResult& result) {
  if (result.good().empty()) return {};
  const model::StageResult& stage = result.good().back();
  auto nodal = [&](const std::string& quantity) {
    return std::any_of(stage.extremes.begin(), stage.extremes.end(),
                       [&](const model::Extreme& e) { return e.quantity == quantity; });
  };
  Rows rows = {{"", "least", "at [m]", "greatest", "at [m]"}};
  for (const model::Extreme& e : stage.extremes) {
    // Nodal and cell values of one quantity say the same twice; strains and angles say little at their
    // extremes.
    const std::size_t cells = e.quantity.find(" (cells)");
    if (e.unit.empty() || e.unit == "deg" || e.unit == "rad" ||
        (cells != std::string::npos && nodal(e.quantity.substr(0, cells))))
      continue;
    rows.push_back({e.quantity, short_quantity(e.least, e.unit), place_text(e.least_at.x, e.least_at.y),
                    short_quantity(e.greatest, e.unit), place_text(e.greatest_at.x, e.greatest_at.y)});
  }
  return rows.size() == 1 ? std::string() : "Extreme values, stage " + stage.name + "\n" + aligned(rows);
}

std::string joints_text(const model::RunResult& result) {
  bool rough = false;
  for (const model::StageResult& stage : result.stages)
    for (const model::JointResult& joint : stage.joints) rough |= joint.strength_force > 0;
  Rows rows = {{"", "stage", "closed", "normal force", "opening", "slip", "pressure", "penetration/h"}};
  if (rough) rows[0].insert(rows[0].end(), {"shear force", "slipping", "safety"});
  for (const model::StageResult& stage : result.stages)
    for (const model::JointResult& joint : stage.joints) {
      rows.push_back({joint.name, stage.name,
                      std::to_string(joint.closed) + "/" + std::to_string(joint.points),
                      short_quantity(joint.normal_force, "N"), short_quantity(joint.max_opening, "m"),
                      short_quantity(joint.max_slip, "m"), short_quantity(joint.max_pressure, "Pa"),
                      number("%.1e", joint.penetration_over_h)});
      if (rough)
        rows.back().insert(rows.back().end(),
                           {short_quantity(joint.shear_force, "N"), std::to_string(joint.slipping),
                            joint.safety > 0 ? number("%.4g", joint.safety) : std::string("-")});
    }
  if (rows.size() == 1) return {};
  std::string text = "Joints (greatest values)\n" + aligned(rows, 2);
  // The mesh is the same in all stages.
  for (const model::JointResult& joint : result.stages.back().joints)
    if (joint.contact_length < (1 - 1e-4) * joint.length)
      text += "  " +
              wrapped(joint.name + ": contact points stand for " + short_quantity(joint.contact_length, "m") +
                          " of " + short_quantity(joint.length, "m") +
                          (joint.tips.empty()
                               ? "; the rest faces no part of the other lip"
                               : "; what the rest carries, at welded tips, is not in the normal force"),
                      width - 2, 4);
  return text;
}

std::string sections_text(const model::RunResult& result) {
  Rows rows = {{"", "stage", "", "N", "V", "M", "apart"}};
  for (const model::StageResult& stage : result.good())
    for (const model::SectionResult& section : stage.sections) {
      if (!section.summed) continue;
      const double length = geometry::distance(section.first, section.last);
      const auto row = [&](std::vector<std::string> first, const model::SectionForces& forces) {
        first.push_back(force(forces.normal, section.size, "N"));
        first.push_back(force(forces.shear, section.size, "N"));
        first.push_back(force(forces.moment, section.size * length, "N*m"));
        rows.push_back(std::move(first));
      };
      row({section.name, stage.name, "balance"}, section.forces);
      if (!section.integrated) continue;
      row({"", "", "integral"}, section.integral);
      rows.back().push_back(number("%.2g %%", 100 * section.difference));
    }
  if (rows.size() == 1) return {};
  return "Sections (N in tension, M where it pulls the end of the line; apart: of the tractions' sum)\n" +
         aligned(rows, 3);
}

std::string probes_text(const model::RunResult& result) {
  Rows rows = {{"", "stage", "at [m]", "ux", "uy", "s1", "s3"}};
  for (const model::StageResult& stage : result.stages)
    for (const model::ProbeResult& probe : stage.probes) {
      std::vector<std::string> row = {probe.name, stage.name, place_text(probe.at.x, probe.at.y)};
      for (const char* name : {"ux", "uy", "s1", "s3"}) {
        const auto value = probe.values.find(name);
        row.push_back(value == probe.values.end() ? ""
                                                  : short_quantity(value->second, *name == 'u' ? "m" : "Pa"));
      }
      rows.push_back(std::move(row));
    }
  if (rows.size() == 1) return {};
  // A column that no probe asked for is left out.
  for (std::size_t column = rows.front().size(); column-- > 3;)
    if (std::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) { return row[column].empty(); }))
      for (auto& row : rows) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
  return "Probes\n" + aligned(rows, 2);
}

std::string norms_text(const model::RunResult& result) {
  Rows rows = {{"", "stage", "of", "error", "relative"}};
  for (const model::StageResult& stage : result.good())
    for (const model::NormResult& norm : stage.norms)
      rows.push_back({norm.name, stage.name, norm.quantity, number("%.3e ", norm.error) + norm.unit,
                      number("%.3e", norm.relative())});
  return rows.size() == 1 ? std::string() : "Errors against exact solutions\n" + aligned(rows, 3);
}

std::string iterations_text(const model::RunResult& result) {
  Rows rows = {{"stage", "iterations", "last residual", "backward error", "unknowns", "solved with"}};
  const bool conditions =
      std::ranges::any_of(result.good(), [](const model::StageResult& stage) { return stage.condition > 0; });
  if (conditions) rows.front().push_back("condition");
  for (const model::StageResult& stage : result.good()) {
    const bool linear = stage.iterations.empty();
    rows.push_back({stage.name, linear ? "none" : std::to_string(stage.iterations.size()),
                    linear ? "" : number("%.1e", stage.iterations.back().residual),
                    number("%.1e", stage.backward_error), std::to_string(stage.unknowns),
                    stage.factored ? "new factorisation" : "factorisation kept"});
    if (conditions) rows.back().push_back(stage.condition > 0 ? number("%.1e", stage.condition) : "unknown");
  }
  return rows.size() == 1 ? std::string() : "Solution\n" + aligned(rows);
}

std::string failure_text(const model::RunResult& result) {
  if (result.good().size() == result.stages.size()) return {};
  const model::StageResult& stage = result.stages.back();
  std::string text = "Not converged: stage " + stage.name + "\n  " + wrapped(stage.reason, width - 2, 2);
  if (!stage.advice.empty()) text += "  " + wrapped("What to try: " + stage.advice, width - 2, 4);
  text += result.good().empty() ? "  No stage was completed.\n"
                                : "  All results are those of the stages before it, the last one " +
                                      result.good().back().name + ".\n";
  const std::size_t count = stage.iterations.size();
  if (count == 0) return text;
  const std::size_t first = count > most_iterations ? count - most_iterations : 0;
  Rows rows = {{"step", "iteration", "residual"}};
  const std::vector<std::string> facts = fact_names({&stage, 1});
  rows.front().insert(rows.front().end(), facts.begin(), facts.end());
  for (std::size_t i = first; i < count; ++i) {
    const model::Iteration& row = stage.iterations[i];
    rows.push_back({std::to_string(row.step), std::to_string(row.number), number("%.1e", row.residual)});
    for (const std::string& fact : facts) {
      const auto value = fact_of(row, fact);
      rows.back().push_back(value ? number("%.4g", *value) : "");
    }
  }
  return text +
         (first > 0 ? "  the last " + std::to_string(most_iterations) + " of " + std::to_string(count) +
                          " iterations:\n"
                    : "") +
         aligned(rows, 0);
}

std::string costs_text(const core::Ledger& ledger) {
  Rows rows = {{"phase", "effect", "wall", "CPU", "calls", "memory", "unknowns"}};
  double wall = 0, cpu = 0;
  for (const core::Cost& c : ledger.rows()) {
    rows.push_back({c.phase, c.effect, number("%.3f s", c.wall), number("%.3f s", c.cpu),
                    c.calls ? std::to_string(c.calls) : "",
                    c.bytes ? bytes_text(static_cast<double>(c.bytes)) : "",
                    c.unknowns ? std::to_string(c.unknowns) : ""});
    wall += c.wall;
    cpu += c.cpu;
  }
  rows.push_back({"sum", "", number("%.3f s", wall), number("%.3f s", cpu), "",
                  bytes_text(static_cast<double>(core::peak_memory())) + " at peak"});
  return "Time and memory\n" + aligned(rows, 2);
}

std::string files_text(const std::vector<std::filesystem::path>& files) {
  if (files.empty()) return {};
  std::string text = "Files in " + files.front().parent_path().string() + "\n";
  std::string line;
  for (const auto& file : files) {
    const std::string name = file.lexically_relative(files.front().parent_path()).string();
    line += (line.empty() ? "" : "  ") + name;
  }
  return text + "  " + wrapped(line, width - 2, 2);
}

std::string summary(const RunRecord& record, const std::vector<std::filesystem::path>& files) {
  std::string text = record.scene.title + "\n";
  for (const std::string& paragraph :
       {simulated_text(record.plan, record.result), mesh_text(record.mesh_report, record.model),
        balance_text(record.result, record.scene.plane), extremes_text(record.result),
        probes_text(record.result), sections_text(record.result), joints_text(record.result),
        norms_text(record.result), iterations_text(record.result), failure_text(record.result),
        costs_text(record.ledger), files_text(files)})
    if (!paragraph.empty()) text += "\n" + paragraph;
  return text;
}

}  // namespace ashlar::output
