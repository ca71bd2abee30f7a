#include "output/vtk.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>

#include "output/joint_columns.hpp"

namespace ashlar::output {

using mesh::Index;

namespace {

static_assert(std::endian::native == std::endian::little, "the files are written as little-endian");

constexpr std::uint8_t vtk_line = 3, vtk_polygon = 7;  // VTK's numbers of cell kinds

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

template <class T>
const char* type_name();
template <>
const char* type_name<double>() {
  return "Float64";
}
template <>
const char* type_name<std::int32_t>() {
  return "Int32";
}
template <>
const char* type_name<std::int64_t>() {
  return "Int64";
}
template <>
const char* type_name<std::uint8_t>() {
  return "UInt8";
}

// The XML and the raw bytes that its arrays point into grow together.
class Grid {
 public:
  Grid(std::size_t points, std::size_t cells) : points_(points), cells_(cells) {}

  template <class T>
  void array(const std::string& name, std::span<const T> values, int width = 1,
             const std::vector<std::string>& components = {}) {
    xml_ += std::string("        <DataArray type=\"") + type_name<T>() + "\" Name=\"" + escaped(name) + "\"";
    if (width > 1) xml_ += " NumberOfComponents=\"" + std::to_string(width) + "\"";
    for (std::size_t i = 0; i < components.size(); ++i)
      xml_ += " ComponentName" + std::to_string(i) + "=\"" + escaped(components[i]) + "\"";
    xml_ += " format=\"appended\" offset=\"" + std::to_string(data_.size()) + "\"/>\n";
    const std::uint64_t bytes = values.size_bytes();
    data_.append(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    data_.append(reinterpret_cast<const char*>(values.data()), bytes);
  }
  void line(const std::string& text) { xml_ += text + "\n"; }
  void field_data(const std::string& text) { field_data_ += text + "\n"; }

  std::string file() const {
    std::string text =
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\""
        " header_type=\"UInt64\">\n  <UnstructuredGrid>\n";
    if (!field_data_.empty()) text += "    <FieldData>\n" + field_data_ + "    </FieldData>\n";
    text += "    <Piece NumberOfPoints=\"" + std::to_string(points_) + "\" NumberOfCells=\"" +
            std::to_string(cells_) + "\">\n" + xml_ + "    </Piece>\n  </UnstructuredGrid>\n" +
            "  <AppendedData encoding=\"raw\">\n_";
    text.reserve(text.size() + data_.size() + 64);
    text += data_;
    return text + "\n  </AppendedData>\n</VTKFile>\n";
  }

 private:
  std::size_t points_, cells_;
  std::string xml_, field_data_, data_;
};

void write_points(Grid& grid, std::span<const geometry::Point> points) {
  std::vector<double> places;
  places.reserve(3 * points.size());
  for (const geometry::Point& p : points) places.insert(places.end(), {p.x, p.y, 0.0});
  grid.line("      <Points>");
  grid.array("points", std::span<const double>(places), 3);
  grid.line("      </Points>");
}

void write_cells(Grid& grid, std::span<const Index> connectivity, std::span<const Index> offsets,
                 std::uint8_t kind) {
  const std::vector<std::int64_t> values(connectivity.begin(), connectivity.end());
  const std::vector<std::int64_t> ends(offsets.begin() + 1, offsets.end());
  const std::vector<std::uint8_t> kinds(ends.size(), kind);
  grid.line("      <Cells>");
  grid.array("connectivity", std::span<const std::int64_t>(values));
  grid.array("offsets", std::span<const std::int64_t>(ends));
  grid.array("types", std::span<const std::uint8_t>(kinds));
  grid.line("      </Cells>");
}

// ParaView warps by vectors of three components.
void write_field(Grid& grid, const model::FieldResult& field) {
  if (field.width != 2) {
    grid.array(field.name, std::span<const double>(field.values), field.width,
               field.width > 1 ? field.components : std::vector<std::string>());
    return;
  }
  std::vector<double> values;
  values.reserve(field.values.size() / 2 * 3);
  for (std::size_t i = 0; i + 1 < field.values.size(); i += 2)
    values.insert(values.end(), {field.values[i], field.values[i + 1], 0.0});
  std::vector<std::string> components = field.components;
  if (components.size() == 2) components.push_back("z");
  grid.array(field.name, std::span<const double>(values), 3, components);
}

void write_fields(Grid& grid, const model::StageResult& stage, model::FieldResult::On on) {
  for (const model::FieldResult& field : stage.fields)
    if (field.on == on) write_field(grid, field);
}

void write_names(Grid& grid, const std::string& name, const std::vector<std::string>& texts) {
  // VTK keeps texts in files as numbers, one a byte, each text ended by 0.
  std::string bytes;
  for (const std::string& text : texts) {
    for (const char c : text) bytes += std::to_string(static_cast<int>(static_cast<unsigned char>(c))) + " ";
    bytes += "0 ";
  }
  grid.field_data("      <Array type=\"String\" Name=\"" + name + "\" NumberOfTuples=\"" +
                  std::to_string(texts.size()) + "\" format=\"ascii\">" + bytes + "</Array>");
}

}  // namespace

std::string cells_vtu(const mesh::Mesh& mesh, const model::StageResult& stage) {
  Grid grid(mesh.points.size(), static_cast<std::size_t>(mesh.cell_count()));
  if (!mesh.regions.empty()) write_names(grid, "region_names", mesh.regions);
  grid.line("      <PointData>");
  write_fields(grid, stage, model::FieldResult::On::points);
  grid.line("      </PointData>\n      <CellData>");
  grid.array("region", std::span<const Index>(mesh.cell_region));
  write_fields(grid, stage, model::FieldResult::On::cells);
  grid.line("      </CellData>");
  write_points(grid, mesh.points);
  write_cells(grid, mesh.cell_points.values(), mesh.cell_points.offsets(), vtk_polygon);
  return grid.file();
}

std::string joints_vtu(const model::StageResult& stage) {
  std::vector<geometry::Point> points;
  std::vector<double> s;
  std::array<std::vector<double>, joint_columns.size()> values;
  std::vector<Index> closed, joint_of_cell, connectivity, offsets = {0};
  std::vector<std::string> names;
  for (const model::JointResult& joint : stage.joints) {
    for (std::size_t i = 0; i < joint.rows.size(); ++i) {
      const model::JointResult::Row& row = joint.rows[i];
      if (i > 0 && joint.rows[i - 1].piece == row.piece) {
        const auto here = static_cast<Index>(points.size());
        connectivity.insert(connectivity.end(), {here - 1, here});
        offsets.push_back(static_cast<Index>(connectivity.size()));
        joint_of_cell.push_back(static_cast<Index>(names.size()));
      }
      points.push_back(row.at);
      s.push_back(row.s);
      for (std::size_t c = 0; c < values.size(); ++c) values[c].push_back(row.*joint_columns[c].value);
      closed.push_back(row.closed ? 1 : 0);
    }
    names.push_back(joint.name);
  }
  Grid grid(points.size(), joint_of_cell.size());
  if (!names.empty()) write_names(grid, "joint_names", names);
  grid.line("      <PointData>");
  grid.array("s", std::span<const double>(s));
  for (std::size_t c = 0; c < values.size(); ++c)
    grid.array(joint_columns[c].name, std::span<const double>(values[c]));
  grid.array("closed", std::span<const Index>(closed));
  grid.line("      </PointData>\n      <CellData>");
  grid.array("joint", std::span<const Index>(joint_of_cell));
  grid.line("      </CellData>");
  write_points(grid, points);
  write_cells(grid, connectivity, offsets, vtk_line);
  return grid.file();
}

std::string collection_pvd(const std::vector<CollectionFile>& files) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (const CollectionFile& each : files)
    text += "    <DataSet timestep=\"" + std::to_string(each.stage) + "\" part=\"" +
            std::to_string(each.part) + "\" file=\"" + escaped(each.file) + "\"/>\n";
  return text + "  </Collection>\n</VTKFile>\n";
}

}  // namespace ashlar::output
