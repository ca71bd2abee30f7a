#pragma once
// From a word in the scene ("uy", "s1", "stress") to numbers that can be drawn. Included by pictures/*.cpp
// and tests.

#include <optional>
#include <string>
#include <vector>

#include "output/pictures/pictures.hpp"

namespace ashlar::output {

struct DrawnField {
  /// A field whose values differ by no more than round-off is not drawn as if they did.
  enum class Kind { varied, uniform, zero };
  Kind kind = Kind::varied;
  std::string title;  ///< with markup
  std::string unit;
  bool stress = false;          ///< tension positive: the picture says so
  std::vector<double> corners;  ///< at every cell's corners, laid out as mesh.cell_points.values()
  double whole = 0;             ///< largest magnitude of the field that this is a component of
  double least = 0, greatest = 0;
  geometry::Point least_at, greatest_at;
  double low = 0, high = 0;  ///< holds all but the outermost 0.5 % of the area at either end
};

/// Values and differences below this share of DrawnField::whole are round-off.
constexpr double roundoff = 1e-9;

/// The quantity at the corners of all cells. Values that are known by cell are averaged at each corner over
/// the cells around it that are of the same material and on the same side of joints. Nothing if the stage
/// does not have it.
std::optional<DrawnField> drawn_field(const PictureSource& source, const std::string& quantity);

/// The quantities behind a word: "stress" gives sxx, syy, sxy and so on; others stand for themselves.
std::vector<std::string> quantities_of(const model::StageResult& stage, const std::string& word);

/// A number for each cell, equal where cells are of one material.
std::vector<int> material_groups(const model::Scene& scene, const mesh::Mesh& mesh);

}  // namespace ashlar::output
