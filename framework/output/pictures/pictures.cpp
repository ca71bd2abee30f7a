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
  for (const core::Settings::Entry& entry : scene.outputs.entries) {
    if (entry.key != "pictures" || entry.value.is_nothing()) continue;
    if (const bool* any = entry.value.boolean(); any && !*any) return {};
    const core::Table* list = entry.value.table();
    if (!list) continue;
    std::vector<std::string> words;
    for (const core::Value& item : list->items)
      if (item.text()) words.push_back(*item.text());
    return words;
  }
  return {"mesh", "deformed", "displacement", "ux", "uy", "syy", "s1", "s3", "joints"};
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
    } else if (!result.stages.empty()) {
      const PictureSource source{scene, model, result.stages.back()};
      if (word == "deformed") {
        pictures.push_back(deformed_picture(source));
        continue;
      }
      for (const std::string& quantity : quantities_of(source.stage, word))
        pictures.push_back(field_picture(source, quantity));
    }
  }
  std::erase_if(pictures, [](const Picture& picture) { return picture.name.empty(); });
  return pictures;
}

}  // namespace ashlar::output
