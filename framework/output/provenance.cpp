#include "output/provenance.hpp"

#include <cairo.h>
#include <png.h>

#include "output/files.hpp"
#include "output/store.hpp"

namespace ashlar::output {

using hdf5::attribute;
using hdf5::Handle;
using hdf5::make_group;
using hdf5::write;

namespace {

std::string value_text(const core::Value& value, core::Dimension dimension);

std::string table_text(const core::Table& table, core::Dimension dimension) {
  std::string text = table.constructor + "{";
  auto next = [&text] { text += text.back() == '{' ? "" : ", "; };
  for (const core::Value& item : table.items) {
    next();
    text += value_text(item, dimension);
  }
  for (const auto& [key, item] : table.entries) {
    next();
    text += key + " = " + value_text(item, dimension);
  }
  return text + "}";
}

std::string value_text(const core::Value& value, core::Dimension dimension) {
  if (value.is_nothing()) return "";
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  if (const core::Quantity* quantity = value.quantity()) {
    const std::string unit = core::to_string(quantity->bare ? dimension : quantity->dimension);
    return shortest(quantity->value) + (unit.empty() ? "" : " " + unit);
  }
  if (const std::string* text = value.text()) return *text;
  if (const core::Table* table = value.table()) return table_text(*table, dimension);
  return "function";
}

void add_rows(const std::string& prefix, const core::Settings& settings, std::vector<SettingRow>& rows) {
  const std::string dot = prefix.empty() ? "" : prefix + ".";
  for (const core::Settings::Entry& entry : settings.entries) {
    const std::string path = dot + entry.key;
    if (entry.value.is_nothing() && !entry.object && entry.objects.empty()) continue;
    const std::string place = core::to_string(entry.value.place);
    if (entry.object) {
      const core::Settings& object = *entry.object;
      rows.push_back(
          {path, object.name.empty() ? object.kind : object.kind + "." + object.name, place, entry.said});
      add_rows(path, object, rows);
    } else if (!entry.objects.empty()) {
      for (const auto& [name, object] : entry.objects) add_rows(path + "." + name, object, rows);
    } else {
      rows.push_back({path, value_text(entry.value, entry.dimension), place, entry.said});
    }
  }
  for (std::size_t i = 0; i < settings.items.size(); ++i)
    rows.push_back({dot + std::to_string(i + 1), value_text(settings.items[i], {}),
                    core::to_string(settings.items[i].place), true});
}

void write_settings(const Handle& parent, const core::Settings& root) {
  const Handle group = make_group(parent, "settings");
  std::vector<std::string> paths, values, places;
  std::vector<std::int32_t> said;
  for (const SettingRow& row : setting_rows(root)) {
    paths.push_back(row.path);
    values.push_back(row.value);
    places.push_back(row.place);
    said.push_back(row.said ? 1 : 0);
  }
  write(group, "path", paths);
  write(group, "value", values);
  write(group, "place", places);
  write(group, "said", std::span<const std::int32_t>(said));
}

void write_pairs(const Handle& parent, const std::string& name,
                 const std::vector<std::pair<std::string, std::string>>& pairs) {
  const Handle group = make_group(parent, name);
  std::vector<std::string> names, values;
  for (const auto& [each, value] : pairs) {
    names.push_back(each);
    values.push_back(value);
  }
  write(group, "name", names);
  write(group, "value", values);
}

void write_timings(const Handle& parent, const core::Ledger& ledger) {
  const Handle group = make_group(parent, "timings");
  std::vector<std::string> phases, effects;
  std::vector<double> wall, cpu, calls, bytes, unknowns;
  for (const core::Cost& cost : ledger.rows()) {
    phases.push_back(cost.phase);
    effects.push_back(cost.effect);
    wall.push_back(cost.wall);
    cpu.push_back(cost.cpu);
    calls.push_back(static_cast<double>(cost.calls));
    bytes.push_back(static_cast<double>(cost.bytes));
    unknowns.push_back(static_cast<double>(cost.unknowns));
  }
  write(group, "phase", phases);
  write(group, "effect", effects);
  write(group, "wall", std::span<const double>(wall), 1, "s");
  write(group, "cpu", std::span<const double>(cpu), 1, "s");
  write(group, "calls", std::span<const double>(calls));
  write(group, "bytes", std::span<const double>(bytes));
  write(group, "unknowns", std::span<const double>(unknowns));
  attribute(parent, "peak_memory", static_cast<double>(core::peak_memory()));
}

void write_effects(const Handle& parent, const model::Plan& plan) {
  const Handle group = make_group(parent, "effects");
  std::vector<std::string> stages, effects, places, left_out, why;
  for (const model::StagePlan& stage : plan.stages)
    for (const model::Call& call : stage.calls) {
      stages.push_back(stage.stage);
      effects.push_back(call.effect);
      places.push_back(core::to_string(call.place));
    }
  for (const core::EffectEntry& effect : plan.left_out) {
    left_out.push_back(effect.name);
    why.push_back(effect.left_out);
  }
  write(group, "stage", stages);
  write(group, "effect", effects);
  write(group, "called_by", places);
  write(group, "left_out", left_out);
  write(group, "left_out_means", why);
}

}  // namespace

std::vector<SettingRow> setting_rows(const core::Settings& root) {
  std::vector<SettingRow> rows;
  add_rows("", root, rows);
  return rows;
}

std::vector<std::pair<std::string, std::string>> output_versions() {
  unsigned major = 0, minor = 0, release = 0;
  H5get_libversion(&major, &minor, &release);
  return {{"hdf5", std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(release)},
          {"cairo", cairo_version_string()},
          {"libpng", png_get_libpng_ver(nullptr)}};
}

void write_provenance(const Handle& group, const RunRecord& record, const std::string& date) {
  attribute(group, "date", date);
  attribute(group, "command_line", record.command_line);
  attribute(group, "threads", record.threads);
  std::vector<std::pair<std::string, std::string>> sources, parameters;
  for (const Source& source : record.sources) sources.emplace_back(source.name, source.text);
  for (const ParameterValue& each : record.parameters)
    parameters.emplace_back(each.name, each.value + (each.set ? "" : " (default)"));
  write_pairs(group, "sources", sources);
  write_pairs(group, "parameters", parameters);
  auto versions = record.versions;
  for (auto& version : output_versions()) versions.push_back(std::move(version));
  write_pairs(group, "versions", versions);
  std::vector<std::pair<std::string, std::string>> modules;
  for (const std::string& module : record.modules) modules.emplace_back(module, "opened");
  write_pairs(group, "modules", modules);
  write_pairs(group, "mesh_notes", record.mesh_report.notes);
  write_settings(group, record.scene.root);
  write_effects(group, record.plan);
  write_timings(group, record.ledger);
  std::vector<std::pair<std::string, std::string>> lines;
  for (const auto& [level, text] : record.log.lines())
    lines.emplace_back(level == core::Level::warning ? "warning"
                       : level == core::Level::info  ? "info"
                                                     : "debug",
                       text);
  write_pairs(group, "log", lines);
}

}  // namespace ashlar::output
