#include "output/write_all.hpp"

#include <algorithm>
#include <array>
#include <ctime>

#include "output/files.hpp"
#include "output/pictures/pictures.hpp"
#include "output/store.hpp"
#include "output/tables.hpp"
#include "output/transaction.hpp"
#include "output/vtk.hpp"

namespace ashlar::output {

namespace {

std::string date_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

void write_vtk(const RunRecord& record, Transaction& transaction) {
  std::vector<CollectionFile> parts;
  const auto stages = record.result.good();
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const model::StageResult& stage = stages[i];
    const std::string name = "vtu/" + stage_file_name(i + 1, stage.name);
    write_file(transaction.file(name + ".vtu"), cells_vtu(record.model.mesh, stage));
    parts.push_back({i + 1, 0, name + ".vtu"});
    if (stage.joints.empty()) continue;
    write_file(transaction.file(name + "_joints.vtu"), joints_vtu(stage));
    parts.push_back({i + 1, 1, name + "_joints.vtu"});
  }
  write_file(transaction.file("results.pvd"), collection_pvd(parts));
}

void write_tables(const RunRecord& record, Transaction& transaction) {
  const model::RunResult& result = record.result;
  auto any = [&](auto holds) { return std::any_of(result.stages.begin(), result.stages.end(), holds); };
  if (any([](const model::StageResult& s) { return !s.probes.empty(); }))
    write_file(transaction.file("probes.csv"), probes_csv(result));
  for (const std::string& joint : joint_names(result))
    write_file(transaction.file("joint_" + file_name(joint) + ".csv"), joint_csv(result, joint));
  for (const std::string& section : section_names(result))
    write_file(transaction.file("section_" + file_name(section) + ".csv"), section_csv(result, section));
  if (!section_names(result).empty()) write_file(transaction.file("sections.csv"), sections_csv(result));
  if (any([](const model::StageResult& s) { return !s.iterations.empty(); }))
    write_file(transaction.file("iterations.csv"), iterations_csv(result));
}

}  // namespace

bool has_format(const model::Scene& scene, const std::string& format) {
  const core::Settings::Entry* formats = scene.outputs.find("formats");
  const core::Table* words = formats ? formats->value.table() : nullptr;
  if (!words) return format != "svg";
  return std::any_of(words->items.begin(), words->items.end(),
                     [&](const core::Value& word) { return word.text() && *word.text() == format; });
}

std::vector<std::filesystem::path> write_results(const RunRecord& record, const std::filesystem::path& out) {
  const std::filesystem::path unconverged = out / "unconverged";
  Transaction transaction(record.result.converged ? out : unconverged);
  const model::Scene& scene = record.scene;
  if (has_format(scene, "hdf5")) write_file(transaction.file("results.h5"), store_bytes(record, date_now()));
  if (has_format(scene, "vtu")) write_vtk(record, transaction);
  if (has_format(scene, "csv")) write_tables(record, transaction);
  const std::vector<Picture> pictures = chosen_pictures(scene, record.model, record.result);
  if (has_format(scene, "png"))
    for (const Picture& picture : pictures)
      write_file(transaction.file(picture.name + ".png"), png_bytes(picture));
  if (has_format(scene, "svg"))
    for (const Picture& picture : pictures)
      write_file(transaction.file(picture.name + ".svg"), svg_bytes(picture));
  auto files = transaction.commit();
  if (record.result.converged) remove_results(unconverged);
  return files;
}

}  // namespace ashlar::output
