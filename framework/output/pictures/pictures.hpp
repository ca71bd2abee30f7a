#pragma once
// The pictures of a run, drawn without other programs. Which ones: `outputs.pictures` of the scene — false
// for none, a list of words, or (true, absent) the default set:
//   mesh; of a stage deformed, displacement, ux, uy, sxx, syy, sxy, s1, s3; joints and sections: one profile
//   picture each.
// Words are also crosses, szz, tmax, von_mises and the name of any field of the results, for all its
// components. Which stages: `outputs.picture_stages` — true for all, a list of names, or (absent) the last.
// Pictures of the last stage bear the quantity's name, those of others lie in a folder NN_STAGE.

#include <functional>
#include <string>
#include <vector>

#include "model/model.hpp"
#include "model/results.hpp"
#include "model/scene.hpp"

namespace ashlar::output {

class Canvas;

/// Refers to the scene, model and results that it was made from. `height` is in units of the page's width /
/// 400.
struct Picture {
  std::string name;  ///< of the file, without ending; may begin with a folder
  double height = 0;
  std::function<void(Canvas&)> draw;
};

std::string png_bytes(const Picture& picture);
std::string svg_bytes(const Picture& picture);

/// What the scene asks for, as far as the results have it.
std::vector<Picture> chosen_pictures(const model::Scene& scene, const model::Model& model,
                                     const model::RunResult& result);

/// What a picture is drawn from.
struct PictureSource {
  const model::Scene& scene;
  const model::Model& model;
  const model::StageResult& stage;
};

Picture mesh_picture(const model::Scene& scene, const model::Model& model);
/// Exaggerated by a round factor that the picture states; over the undeformed outline.
Picture deformed_picture(const PictureSource& source);
/// Filled contours of one quantity ("uy", "s1" …) on the undeformed mesh, jumps at joints and between
/// materials kept; its extreme values marked. No picture (empty name) if the stage has no such field.
Picture field_picture(const PictureSource& source, const std::string& quantity);
/// Principal stresses in the plane as crosses of arms as long as they are great: tension and compression
/// differ in colour and form. One cross a cell, or fewer on fine meshes. No picture without stresses in
/// cells.
Picture cross_picture(const PictureSource& source);
/// Normal and shear stress over the section's length, all stages together, with N, V and M below. No picture
/// if the results have no such stresses.
Picture section_picture(const model::Scene& scene, const model::RunResult& result,
                        const std::string& section);
/// Opening, slip and pressure over the joint's arc length, all stages together.
Picture joint_picture(const model::Scene& scene, const model::RunResult& result, const std::string& joint);

}  // namespace ashlar::output
