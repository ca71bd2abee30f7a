#include "output/pictures/pictures.hpp"

#include <algorithm>

#include "core/log.hpp"
#include "output/files.hpp"
#include "output/pictures/canvas.hpp"
#include "output/pictures/values.hpp"
#include "output/tables.hpp"

namespace ashlar::output {

namespace {

void warn_of_no_picture(const PictureSource& source, const std::string& word) {
  const core::Settings::Entry* said = source.scene.outputs.find("pictures");
  if (!said || !said->said || !said->value.table()) return;
  std::vector<std::string> valid = {"mesh", "deformed", "joints", "sections", "crosses"};
  for (const model::FieldResult& field : source.stage.fields) valid.push_back(field.name);
  core::log().warning(core::to_string(said->value.place) + ": there is nothing to draw for '" + word + "'; " +
                      core::did_you_mean(word, valid) + ", and their components such as ux or sxx");
}

const std::vector<std::string> default_words = {
    "mesh", "deformed", "displacement", "ux", "uy", "sxx", "syy", "sxy", "s1", "s3", "joints", "sections"};

const core::Value* said(const model::Scene& scene, const std::string& key) {
  const core::Settings::Entry* entry = scene.outputs.find(key);
  return entry && !entry->value.is_nothing() ? &entry->value : nullptr;
}

std::vector<std::string> texts(const core::Table& list) {
  std::vector<std::string> words;
  for (const core::Value& item : list.items)
    if (item.text()) words.push_back(*item.text());
  return words;
}

// What the scene asks for in words.
std::vector<std::string> words_of(const model::Scene& scene) {
  const core::Value* value = said(scene, "pictures");
  if (value && value->table()) return texts(*value->table());
  const bool* any = value ? value->boolean() : nullptr;
  return any && !*any ? std::vector<std::string>() : default_words;
}

// Indices of the stages that get pictures: those named by outputs.picture_stages, by default the last.
std::vector<std::size_t> stages_of(const model::Scene& scene, std::span<const model::StageResult> stages) {
  const core::Value* value = said(scene, "picture_stages");
  const bool* all = value ? value->boolean() : nullptr;
  std::vector<std::string> names;
  if (value && value->table()) names = texts(*value->table());
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const bool named = std::find(names.begin(), names.end(), stages[i].name) != names.end();
    if (named || (all && *all) || (names.empty() && i + 1 == stages.size())) chosen.push_back(i);
  }
  return chosen;
}

std::vector<Picture> stage_pictures(const PictureSource& source, const std::string& word) {
  if (word == "deformed") return {deformed_picture(source)};
  std::vector<Picture> pictures;
  if (word == "crosses") {
    pictures.push_back(cross_picture(source));
    if (pictures.back().name.empty()) warn_of_no_picture(source, word);
    return pictures;
  }
  for (const std::string& quantity : quantities_of(source.stage, word)) {
    pictures.push_back(field_picture(source, quantity));
    if (pictures.back().name.empty()) warn_of_no_picture(source, word);
  }
  return pictures;
}

}  // namespace

std::string png_bytes(const Picture& picture) {
  return png_page(picture.height, picture.draw);
}

std::string svg_bytes(const Picture& picture) {
  return svg_page(picture.height, picture.draw);
}

std::vector<Picture> chosen_pictures(const model::Scene& scene, const model::Model& model,
                                     const model::RunResult& result) {
  std::vector<Picture> pictures;
  if (model.mesh.cell_count() == 0) return pictures;
  const std::span<const model::StageResult> good = result.good();
  for (const std::string& word : words_of(scene)) {
    if (word == "mesh") {
      pictures.push_back(mesh_picture(scene, model));
    } else if (word == "joints") {
      for (const std::string& joint : joint_names(result))
        pictures.push_back(joint_picture(scene, result, joint));
    } else if (word == "sections") {
      for (const std::string& section : section_names(result))
        pictures.push_back(section_picture(scene, result, section));
    } else {
      for (const std::size_t stage : stages_of(scene, good)) {
        const bool last = stage + 1 == good.size();
        const std::string folder = stage_file_name(stage + 1, good[stage].name) + "/";
        for (Picture& picture : stage_pictures({scene, model, good[stage]}, word)) {
          if (!last && !picture.name.empty()) picture.name.insert(0, folder);
          pictures.push_back(std::move(picture));
        }
      }
    }
  }
  std::erase_if(pictures, [](const Picture& picture) { return picture.name.empty(); });
  return pictures;
}

}  // namespace ashlar::output
