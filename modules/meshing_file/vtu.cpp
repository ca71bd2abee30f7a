#include <cmath>

#include "meshing_file/contents.hpp"
#include "meshing_file/vtu_data.hpp"

namespace ashlar::meshing_file {

namespace {

// Raw appended data are no XML: they are cut off before the rest is parsed.
std::string cut_appended(std::string_view text, VtuEncoding& encoding) {
  const std::size_t tag = text.find("<AppendedData");
  if (tag == std::string_view::npos) return std::string(text);
  const std::size_t close = text.find('>', tag);
  const std::size_t start = close == std::string_view::npos ? close : text.find('_', close);
  if (start != std::string_view::npos) {
    encoding.appended_is_base64 = text.substr(tag, close - tag).find("base64") != std::string_view::npos;
    encoding.appended = text.substr(start + 1);
  }
  return std::string(text.substr(0, tag)) + "</VTKFile>";
}

class VtuReader {
 public:
  explicit VtuReader(Cursor& cursor) : cursor_(cursor) {}

  Contents read(std::string_view text) {
    const std::string xml = cut_appended(text, encoding_);
    pugi::xml_document document;
    const auto status = document.load_buffer(xml.data(), xml.size());
    if (!status)
      cursor_.fail_at(static_cast<std::size_t>(status.offset),
                      std::string("this is no sound XML: ") + status.description());
    cursor_.forget_lines();
    const pugi::xml_node file = document.child("VTKFile");
    if (std::string_view(file.attribute("type").value()) != "UnstructuredGrid") {
      cursor_.fail("only VTK files of type UnstructuredGrid are read");
    }
    read_encoding(file);
    for (const pugi::xml_node piece : file.child("UnstructuredGrid").children("Piece")) read_piece(piece);
    return std::move(contents_);
  }

 private:
  void read_encoding(const pugi::xml_node& file) {
    if (std::string_view(file.attribute("byte_order").as_string("LittleEndian")) != "LittleEndian") {
      cursor_.fail("only little-endian files are read");
    }
    encoding_.header_bytes = std::string_view(file.attribute("header_type").value()) == "UInt64" ? 8 : 4;
    const std::string_view compressor = file.attribute("compressor").value();
    encoding_.compressed = !compressor.empty();
    if (encoding_.compressed && compressor != "vtkZLibDataCompressor") {
      cursor_.fail("the only compression that is read is vtkZLibDataCompressor");
    }
  }

  std::vector<double> values(const pugi::xml_node& parent, const char* name) const {
    const pugi::xml_node array = parent.find_child_by_attribute("DataArray", "Name", name);
    if (!array) cursor_.fail(std::string("there is no data array '") + name + "'");
    return vtu_values(array, encoding_, cursor_);
  }

  // A whole number from 0 up to `limit`.
  std::int64_t whole(double value, double limit, const std::string& what) const {
    if (value >= 0 && value <= limit && value == std::floor(value)) return static_cast<std::int64_t>(value);
    cursor_.fail(what + " is wrong");
  }

  void read_piece(const pugi::xml_node& piece) {
    const auto first = static_cast<Index>(contents_.points.size());
    const pugi::xml_node array = piece.child("Points").child("DataArray");
    if (!array) cursor_.fail("there are no points");
    const auto x = vtu_values(array, encoding_, cursor_);
    if (x.size() % 3 != 0) cursor_.fail("points must have three coordinates each");
    for (std::size_t i = 0; i + 2 < x.size(); i += 3) contents_.points.push_back({x[i], x[i + 1], x[i + 2]});
    contents_.point_at.resize(contents_.points.size(), 0);
    const std::size_t points = x.size() / 3;
    read_cells(piece, first, static_cast<double>(points) - 1);
  }

  void read_cells(const pugi::xml_node& piece, Index first, double last_point) {
    const pugi::xml_node cells = piece.child("Cells");
    const auto connectivity = values(cells, "connectivity"), offsets = values(cells, "offsets"),
               types = values(cells, "types");
    if (types.size() != offsets.size())
      cursor_.fail("the arrays 'types' and 'offsets' have different lengths");
    const auto regions = read_regions(piece, offsets.size());
    std::size_t begin = 0;
    for (std::size_t c = 0; c < offsets.size(); ++c) {
      const auto end = static_cast<std::size_t>(
          whole(offsets[c], static_cast<double>(connectivity.size()), "a cell's offset"));
      if (end < begin) cursor_.fail("the cells' offsets are wrong");
      std::vector<Index> points;
      for (; begin < end; ++begin) {
        points.push_back(first +
                         static_cast<Index>(whole(connectivity[begin], last_point, "a cell's point")));
      }
      const auto corners = vtk_corners(whole(types[c], 255, "a cell's type"), std::move(points), cursor_);
      if (corners.empty()) continue;
      contents_.cells.append(corners);
      contents_.cell_at.push_back(0);
      contents_.cell_group.push_back(regions.empty() ? unnamed_region : regions[c]);
    }
  }

  std::vector<std::string> read_regions(const pugi::xml_node& piece, std::size_t cells) const {
    const pugi::xml_node array =
        piece.child("CellData").find_child_by_attribute("DataArray", "Name", "region");
    std::vector<std::string> names;
    if (!array) return names;
    for (const double value : vtu_values(array, encoding_, cursor_)) {
      names.push_back(std::to_string(whole(value, 2147483647, "a cell's region")));
    }
    if (names.size() != cells) cursor_.fail("the array 'region' has another length than the cells");
    return names;
  }

  Cursor& cursor_;
  VtuEncoding encoding_;
  Contents contents_;
};

}  // namespace

Contents read_vtu(Cursor& cursor, std::string_view text) {
  return VtuReader(cursor).read(text);
}

}  // namespace ashlar::meshing_file
