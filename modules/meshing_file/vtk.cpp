#include <algorithm>
#include <cctype>

#include "meshing_file/contents.hpp"

namespace ashlar::meshing_file {

std::vector<Index> vtk_corners(std::int64_t type, std::vector<Index> points, const Cursor& cursor) {
  auto require = [&](bool fits) {
    if (!fits)
      cursor.fail("a cell of type " + std::to_string(type) + " has " + std::to_string(points.size()) +
                  " points");
  };
  switch (type) {
    case 1:
    case 2:
    case 3:
    case 4:
      return {};
    case 5:
      require(points.size() == 3);
      return points;
    case 7:
      require(points.size() >= 3);
      return points;
    case 8:  // a pixel's points go row by row
      require(points.size() == 4);
      std::swap(points[2], points[3]);
      return points;
    case 9:
      require(points.size() == 4);
      return points;
    default:
      break;
  }
  cursor.fail("cell type " + std::to_string(type) +
              " is not read: only linear triangles, quadrilaterals and polygons are");
}

namespace {

std::string lower(std::string_view word) {
  std::string text(word);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

class VtkReader {
 public:
  explicit VtkReader(Cursor& cursor) : cursor_(cursor) {}

  Contents read() {
    if (!cursor_.line().starts_with("# vtk DataFile"))
      cursor_.fail("this is no VTK file: its first line must be '# vtk DataFile …'");
    cursor_.line();
    if (cursor_.at_end() || lower(cursor_.word()) != "ascii")
      cursor_.fail("only ASCII .vtk files are read: write ASCII, or .vtu");
    while (!cursor_.at_end()) section(lower(cursor_.word()));
    return assemble();
  }

 private:
  void section(const std::string& key) {
    if (key == "dataset")
      dataset(lower(cursor_.word()));
    else if (key == "points")
      points();
    else if (key == "polygons" || key == "cells")
      cells();
    else if (key == "cell_types")
      cell_types();
    else if (key == "triangle_strips")
      cursor_.fail("triangle strips are not read: write polygons");
    else if (key == "cell_data" || key == "point_data")
      in_cells_ = key == "cell_data";
    else if (key == "scalars")
      scalars();
    else if (key == "field")
      field();
  }

  void dataset(const std::string& kind) {
    if (kind != "polydata" && kind != "unstructured_grid")
      cursor_.fail("only POLYDATA and UNSTRUCTURED_GRID are read");
    typed_ = kind == "unstructured_grid";
  }

  void points() {
    const std::size_t count = cursor_.count(cursor_.integer(), 6);
    cursor_.word();
    for (std::size_t i = 0; i < count; ++i) {
      contents_.point_at.push_back(cursor_.position());
      const double x = cursor_.real(), y = cursor_.real(), z = cursor_.real();
      contents_.points.push_back({x, y, z});
    }
  }

  Index point() {
    const std::int64_t number = cursor_.integer();
    if (number < 0 || number >= static_cast<std::int64_t>(contents_.points.size())) {
      cursor_.fail("a cell has point " + std::to_string(number) + ", which is not there");
    }
    return static_cast<Index>(number);
  }

  void cells() {
    const std::size_t count = cursor_.count(cursor_.integer(), 2), size = cursor_.count(cursor_.integer(), 2);
    const Cursor start = cursor_;
    if (lower(cursor_.word()) == "offsets") return cells_by_offsets(count, size);
    cursor_ = start;
    for (std::size_t c = 0; c < count; ++c) {
      cells_at_.push_back(cursor_.position() + 1);
      std::vector<Index> cell(cursor_.count(cursor_.integer(), 2));
      for (Index& p : cell) p = point();
      cells_.push_back(std::move(cell));
    }
  }

  // File version 5: n offsets (one more than cells), then all points.
  void cells_by_offsets(std::size_t count, std::size_t size) {
    cursor_.word();
    std::vector<std::int64_t> offsets(count);
    for (auto& offset : offsets) offset = cursor_.integer();
    if (lower(cursor_.word()) != "connectivity") cursor_.fail("CONNECTIVITY is expected");
    cursor_.word();
    if (count == 0) return;
    if (offsets.front() != 0 || offsets.back() != static_cast<std::int64_t>(size))
      cursor_.fail("the cells' offsets are wrong");
    for (std::size_t c = 0; c + 1 < count; ++c) {
      cells_at_.push_back(cursor_.position() + 1);
      if (offsets[c + 1] < offsets[c]) cursor_.fail("the cells' offsets are wrong");
      std::vector<Index> cell(cursor_.count(offsets[c + 1] - offsets[c], 2));
      for (Index& p : cell) p = point();
      cells_.push_back(std::move(cell));
    }
  }

  void cell_types() {
    types_.resize(cursor_.count(cursor_.integer(), 2));
    for (auto& type : types_) type = cursor_.integer();
  }

  void scalars() {
    const std::string name(cursor_.word());
    cursor_.line();
    if (!in_cells_ || name != "region") return;
    const Cursor start = cursor_;
    if (lower(cursor_.word()) == "lookup_table")
      cursor_.word();
    else
      cursor_ = start;
    read_regions(cells_.size());
  }

  void field() {
    cursor_.word();
    const std::size_t arrays = cursor_.count(cursor_.integer(), 4);
    for (std::size_t k = 0; k < arrays; ++k) {
      const std::string name(cursor_.word());
      const std::size_t components = cursor_.count(cursor_.integer(), 1),
                        tuples = cursor_.count(cursor_.integer(), 1);
      cursor_.word();
      if (components != 0 && tuples > (std::size_t{1} << 40) / components)
        cursor_.fail("a field is too long");
      const std::size_t values = cursor_.count(static_cast<std::int64_t>(components * tuples), 2);
      if (in_cells_ && name == "region" && components == 1) {
        read_regions(values);
      } else {
        for (std::size_t i = 0; i < values; ++i) cursor_.word();
      }
    }
  }

  void read_regions(std::size_t count) {
    regions_.clear();
    for (std::size_t i = 0; i < count; ++i) regions_.push_back(std::to_string(cursor_.integer()));
  }

  // In POLYDATA files cell data also count vertices and lines; files with regions may have polygons only.
  Contents assemble() {
    if (typed_ && types_.size() != cells_.size()) cursor_.fail("CELL_TYPES has another length than CELLS");
    if (!regions_.empty() && regions_.size() != cells_.size())
      cursor_.fail("the array 'region' has another length than the cells");
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto corners = vtk_corners(typed_ ? types_[c] : 7, cells_[c], cursor_);
      if (corners.empty()) continue;
      contents_.cells.append(corners);
      contents_.cell_at.push_back(cells_at_[c]);
      contents_.cell_group.push_back(regions_.empty() ? unnamed_region : regions_[c]);
    }
    return std::move(contents_);
  }

  Cursor& cursor_;
  Contents contents_;
  bool typed_ = false, in_cells_ = false;
  std::vector<std::vector<Index>> cells_;
  std::vector<std::size_t> cells_at_;
  std::vector<std::int64_t> types_;
  std::vector<std::string> regions_;
};

}  // namespace

Contents read_vtk(Cursor& cursor) {
  return VtkReader(cursor).read();
}

}  // namespace ashlar::meshing_file
