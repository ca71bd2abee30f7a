#pragma once
// Small mesh files: two unit quadrilaterals side by side, the right one cut into two triangles.
//   3---4---5
//   |   | / |      regions rock (left) and dam, border floor along the bottom, point probe at the origin
//   0---1---2

#include <array>
#include <string>
#include <vector>

namespace samples {

inline const std::string msh2 =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n4\n0 9 \"probe\"\n1 7 \"floor\"\n2 1 \"rock\"\n2 2 \"big dam\"\n$EndPhysicalNames\n"
    "$Nodes\n6\n10 0 0 0\n11 1 0 0\n12 2 0 0\n13 0 1 0\n14 1 1 0\n15 2 1 0\n$EndNodes\n"
    "$Elements\n6\n1 15 2 9 1 10\n2 1 2 7 1 10 11\n3 1 2 7 1 11 12\n"
    "4 3 2 1 1 10 11 14 13\n5 2 2 2 2 11 12 15\n6 2 2 2 2 11 14 15\n$EndElements\n";

inline const std::string msh4 =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n4\n0 9 \"probe\"\n1 7 \"floor\"\n2 1 \"rock\"\n2 2 \"big dam\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 2 0\n1 0 0 0 1 9\n1 0 0 0 2 0 0 1 7 0\n1 0 0 0 1 1 0 1 1 1 1\n2 1 0 0 2 1 0 1 2 1 "
    "-1\n$EndEntities\n"
    "$Nodes\n2 6 10 15\n1 1 1 3\n10\n11\n12\n0 0 0 0\n1 0 0 0.5\n2 0 0 1\n2 1 0 3\n13\n14\n15\n0 1 0\n1 1 "
    "0\n2 1 0\n$EndNodes\n"
    "$Periodic\n0\n$EndPeriodic\n"
    "$Elements\n4 6 1 6\n0 1 15 1\n1 10\n1 1 1 2\n2 10 11\n3 11 12\n2 1 3 1\n4 10 11 14 13\n2 2 2 2\n5 11 12 "
    "15\n6 11 14 15\n$EndElements\n";

/// Appends values as they lie in memory.
class Bytes {
 public:
  explicit Bytes(std::string text) : text_(std::move(text)) {}
  template <class T, class... Values>
  Bytes& put(Values... values) {
    for (const T value : {static_cast<T>(values)...})
      text_.append(reinterpret_cast<const char*>(&value), sizeof(T));
    return *this;
  }
  Bytes& text(const std::string& more) {
    text_ += more;
    return *this;
  }
  std::string take() const { return text_; }

 private:
  std::string text_;
};

inline const std::string names_section =
    "$PhysicalNames\n4\n0 9 \"probe\"\n1 7 \"floor\"\n2 1 \"rock\"\n2 2 \"big dam\"\n$EndPhysicalNames\n";

inline std::string msh2_binary() {
  Bytes b("$MeshFormat\n2.2 1 8\n");
  b.put<int>(1).text("\n$EndMeshFormat\n" + names_section + "$Nodes\n6\n");
  for (int i = 0; i < 6; ++i) b.put<int>(10 + i).put<double>(i % 3, i / 3, 0);
  b.text("\n$EndNodes\n$Elements\n6\n");
  b.put<int>(15, 1, 2, 1, 9, 1, 10);
  b.put<int>(1, 2, 2, 2, 7, 1, 10, 11, 3, 7, 1, 11, 12);
  b.put<int>(3, 1, 2, 4, 1, 1, 10, 11, 14, 13);
  b.put<int>(2, 2, 2, 5, 2, 2, 11, 12, 15, 6, 2, 2, 11, 14, 15);
  return b.text("\n$EndElements\n").take();
}

inline std::string msh4_binary() {
  using Size = unsigned long long;
  Bytes b("$MeshFormat\n4.1 1 8\n");
  b.put<int>(1).text("\n$EndMeshFormat\n" + names_section + "$Entities\n").put<Size>(1, 1, 2, 0);
  b.put<int>(1).put<double>(0, 0, 0).put<Size>(1).put<int>(9);
  b.put<int>(1).put<double>(0, 0, 0, 2, 0, 0).put<Size>(1).put<int>(7).put<Size>(0);
  b.put<int>(1).put<double>(0, 0, 0, 1, 1, 0).put<Size>(1).put<int>(1).put<Size>(1).put<int>(1);
  b.put<int>(2).put<double>(1, 0, 0, 2, 1, 0).put<Size>(1).put<int>(2).put<Size>(1).put<int>(-1);
  b.text("\n$EndEntities\n$Nodes\n")
      .put<Size>(1, 6, 10, 15)
      .put<int>(2, 1, 0)
      .put<Size>(6, 10, 11, 12, 13, 14, 15);
  for (int i = 0; i < 6; ++i) b.put<double>(i % 3, i / 3, 0);
  b.text("\n$EndNodes\n$Elements\n").put<Size>(4, 6, 1, 6);
  b.put<int>(0, 1, 15).put<Size>(1, 1, 10);
  b.put<int>(1, 1, 1).put<Size>(2, 2, 10, 11, 3, 11, 12);
  b.put<int>(2, 1, 3).put<Size>(1, 4, 10, 11, 14, 13);
  b.put<int>(2, 2, 2).put<Size>(2, 5, 11, 12, 15, 6, 11, 14, 15);
  return b.text("\n$EndElements\n").take();
}

inline const std::string vtk =
    "# vtk DataFile Version 3.0\ntwo squares\nASCII\nDATASET UNSTRUCTURED_GRID\n"
    "POINTS 6 double\n0 0 0 1 0 0 2 0 0\n0 1 0 1 1 0 2 1 0\n"
    "CELLS 4 16\n4 0 1 3 4\n3 1 2 5\n3 1 4 5\n2 0 1\nCELL_TYPES 4\n8 5 7 3\n"
    "POINT_DATA 6\nVECTORS u float\n0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0\n"
    "CELL_DATA 4\nFIELD f 2\nother 2 4 float\n0 0 0 0 0 0 0 0\nregion 1 4 int\n1 2 2 0\n";

inline const std::string vtk_polydata =
    "# vtk DataFile Version 5.1\ntwo squares\nASCII\nDATASET POLYDATA\n"
    "POINTS 6 float\n0 0 0 1 0 0 2 0 0\n0 1 0 1 1 0 2 1 0\n"
    "POLYGONS 4 10\nOFFSETS vtktypeint64\n0 4 7 10\nCONNECTIVITY vtktypeint64\n0 1 4 3 1 2 5 1 4 5\n"
    "CELL_DATA 3\nSCALARS region int 1\nLOOKUP_TABLE default\n1 2 2\n";

inline std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[bits >> (18 - 6 * k) & 63U];
  }
  return text;
}

inline const std::vector<double> vtu_points{0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
inline const std::vector<int> vtu_connectivity{0, 1, 4, 3, 1, 2, 5, 1, 4, 5}, vtu_offsets{4, 7, 10},
    vtu_regions{1, 2, 2};
inline const std::vector<unsigned char> vtu_types{9, 5, 7};

template <class T>
std::string memory(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

/// `pack` turns bytes of an array into the text of its DataArray, or (appended) registers them and returns
/// "".
template <class Pack>
std::string vtu(const std::string& attributes, const std::string& format, Pack pack,
                const std::string& tail = "") {
  auto array = [&](const std::string& name, const std::string& type, const std::string& bytes) {
    const auto [extra, text] = pack(bytes);
    return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
           (name == "Points" ? "3" : "1") + "\" format=\"" + format + "\"" + extra + ">" + text +
           "</DataArray>";
  };
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
         "byte_order=\"LittleEndian\"" +
         attributes + "><UnstructuredGrid><Piece NumberOfPoints=\"6\" NumberOfCells=\"3\"><Points>" +
         array("Points", "Float64", memory(vtu_points)) + "</Points><Cells>" +
         array("connectivity", "Int32", memory(vtu_connectivity)) +
         array("offsets", "Int32", memory(vtu_offsets)) + array("types", "UInt8", memory(vtu_types)) +
         "</Cells><CellData>" + array("region", "Int32", memory(vtu_regions)) +
         "</CellData></Piece></UnstructuredGrid>" + tail + "</VTKFile>";
}

}  // namespace samples
