#include "output/pictures/pictures.hpp"

#include <algorithm>

#include "core/log.hpp"
#include "output/pictures/canvas.hpp"
#include "output/pictures/values.hpp"
#include "output/tables.hpp"

namespace ashlar::output {

namespace {

// What the scene asks for in words.
std::vector<std::string> words_of(const model::Scene& scene) {
  const core::Settings::Entry* pictures = scene.outputs.find("pictures");
  if (const bool* any = pictures ? pictures->value.boolean() : nullptr; any && !*any) return {};
  const core::Table* list = pictures ? pictures->value.table() : nullptr;
  if (!list) return {"mesh", "deformed", "displacement", "ux", "uy", "syy", "s1", "s3", "joints"};
  std::vector<std::string> words;
  for (const core::Value& item : list->items)
    if (item.text()) words.push_back(*item.text());
  return words;
}

void warn_of_no_picture(const PictureSource& source, const std::string& word) {
  const core::Settings::Entry* said = source.scene.outputs.find("pictures");
  if (!said || !said->said) return;
  std::vector<std::string> valid = {"mesh", "deformed", "joints"};
  for (const model::FieldResult& field : source.stage.fields) valid.push_back(field.name);
  core::log().warning(core::to_string(said->value.place) + ": there is nothing to draw for '" + word + "'; " +
                      core::did_you_mean(word, valid) + ", and their components such as ux or sxx");
}

void add_joints(const model::Scene& scene, const model::RunResult& result, std::vector<Picture>& pictures) {
  for (const std::string& joint : joint_names(result))
    pictures.push_back(joint_picture(scene, result, joint));
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
  for (const std::string& word : words_of(scene)) {
    if (word == "mesh") {
      pictures.push_back(mesh_picture(scene, model));
    } else if (word == "joints") {
      add_joints(scene, result, pictures);
    } else if (!result.good().empty()) {
      const PictureSource source{scene, model, result.good().back()};
      if (word == "deformed") {
        pictures.push_back(deformed_picture(source));
        continue;
      }
      for (const std::string& quantity : quantities_of(source.stage, word)) {
        pictures.push_back(field_picture(source, quantity));
        if (pictures.back().name.empty()) warn_of_no_picture(source, word);
      }
    }
  }
  std::erase_if(pictures, [](const Picture& picture) { return picture.name.empty(); });
  return pictures;
}

}  // namespace ashlar::output
