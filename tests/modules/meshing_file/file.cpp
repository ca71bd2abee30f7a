#include "meshing_file/file.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>

#include "framework/mesh/zoo.hpp"
#include "mesh/verify.hpp"
#include "modules/meshing_file/samples.hpp"

using namespace ashlar::mesh;
using ashlar::meshing_file::read;
namespace core = ashlar::core;

namespace {

struct Sample {
  std::string name;
  std::string text;
};

std::string number(unsigned value) {
  return {reinterpret_cast<const char*>(&value), 4};
}

std::string number8(unsigned long long value) {
  return {reinterpret_cast<const char*>(&value), 8};
}

std::string vtu_ascii() {
  return "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece><Points><DataArray type=\"Float64\">0 "
         "0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0"
         "</DataArray></Points><Cells><DataArray Name=\"connectivity\">0 1 4 3 1 2 5 1 4 "
         "5</DataArray><DataArray Name=\"offsets\">4 7 10"
         "</DataArray><DataArray Name=\"types\">9 5 7</DataArray></Cells><CellData><DataArray "
         "Name=\"region\">1 2 2</DataArray></CellData>"
         "</Piece></UnstructuredGrid></VTKFile>";
}

std::string vtu_base64() {
  return samples::vtu("", "binary", [](const std::string& bytes) {
    return std::pair(std::string(), samples::base64(number(static_cast<unsigned>(bytes.size())) + bytes));
  });
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string packed(size, '\0');
  compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
           bytes.size());
  packed.resize(size);
  return packed;
}

std::string vtu_zlib() {
  return samples::vtu(" compressor=\"vtkZLibDataCompressor\"", "binary", [](const std::string& bytes) {
    // Two blocks: 8 bytes, then the rest.
    const std::string first = deflated(bytes.substr(0, 8)),
                      rest = deflated(bytes.substr(std::min<std::size_t>(8, bytes.size())));
    const bool one = bytes.size() <= 8;
    std::string header =
        number(one ? 1 : 2) + number(static_cast<unsigned>(std::min<std::size_t>(8, bytes.size())));
    header += number(one ? 0 : static_cast<unsigned>(bytes.size() - 8)) +
              number(static_cast<unsigned>(first.size()));
    if (!one) header += number(static_cast<unsigned>(rest.size()));
    return std::pair(std::string(), samples::base64(header) + samples::base64(one ? first : first + rest));
  });
}

std::string vtu_appended(bool as_base64) {
  std::string blob;
  const auto pack = [&](const std::string& bytes) {
    const std::string offset = " offset=\"" + std::to_string(blob.size()) + "\"";
    const std::string part = number8(bytes.size()) + bytes;
    blob += as_base64 ? samples::base64(part) : part;
    return std::pair(offset, std::string());
  };
  const std::string head = samples::vtu(" header_type=\"UInt64\"", "appended", pack);
  const std::string tag =
      std::string("<AppendedData encoding=\"") + (as_base64 ? "base64" : "raw") + "\">\n_";
  return head.substr(0, head.size() - 10) + tag + blob + "\n</AppendedData></VTKFile>";
}

std::vector<Sample> all_samples() {
  return {{"a.msh", samples::msh2},
          {"b.msh", samples::msh4},
          {"c.msh", samples::msh2_binary()},
          {"d.msh", samples::msh4_binary()},
          {"e.vtk", samples::vtk},
          {"f.vtk", samples::vtk_polydata},
          {"g.vtu", vtu_ascii()},
          {"h.vtu", vtu_base64()},
          {"i.vtu", vtu_zlib()},
          {"j.vtu", vtu_appended(false)},
          {"k.vtu", vtu_appended(true)}};
}

std::string mistake(const std::string& name, const std::string& text) {
  try {
    read(name, text);
  } catch (const core::InputError& error) {
    return error.what();
  }
  return "no mistake";
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

bool says(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(file, every_format_gives_the_same_mesh) {
  for (const auto& sample : all_samples()) {
    SCOPED_TRACE(sample.name);
    const bool msh = sample.name.ends_with(".msh");
    const RawMesh raw = read(sample.name, sample.text);
    ASSERT_EQ(raw.cell_points.size(), 3);
    EXPECT_EQ(raw.points.size(), 6u);
    EXPECT_EQ(raw.regions,
              (msh ? std::vector<std::string>{"rock", "big dam"} : std::vector<std::string>{"1", "2"}));
    EXPECT_EQ(raw.cell_region, (std::vector<Index>{0, 1, 1}));
    const Mesh mesh = build_mesh(raw, Domain{});
    EXPECT_TRUE(verify(mesh).empty());
    EXPECT_DOUBLE_EQ(report(mesh).area, 2);
    if (!msh) continue;
    EXPECT_EQ(mesh.edge_groups.at("floor").size(), 2u);
    EXPECT_EQ(mesh.point_groups.at("probe"), std::vector<Index>{0});
  }
}

TEST(file, equal_points_merge_and_near_ones_do_not) {
  const std::string doubled =
      replaced(replaced(samples::msh2, "$Nodes\n6", "$Nodes\n7"), "15 2 1 0\n", "15 2 1 0\n16 1 0 0\n");
  const std::string used = replaced(doubled, "5 2 2 2 2 11 12 15", "5 2 2 2 2 16 12 15");
  const std::string named = replaced(used, "3 1 2 7 1 11 12", "3 1 2 7 1 16 12");
  EXPECT_EQ(read("a.msh", used).points.size(), 6u);
  EXPECT_EQ(read("a.msh", replaced(named, "16 1 0 0", "16 1 1e-300 0")).points.size(), 7u);
}

TEST(file, wrong_files_say_what_and_where) {
  const std::string& good = samples::msh2;
  EXPECT_TRUE(says(mistake("a.msh", "hello"), "$MeshFormat"));
  EXPECT_TRUE(says(mistake("a.msh", ""), "a.msh"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "11 1 0 0", "11 nan 0 0")),
                   "a.msh:14: a point's coordinate is not a finite"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "11 1 0 0", "11 x 0 0")),
                   "a.msh:14: a number is expected, got 'x'"));
  EXPECT_TRUE(
      says(mistake("a.msh", replaced(good, "11 12 15", "11 12 99")), "a.msh:26: an element has node 99"));
  EXPECT_TRUE(
      says(mistake("a.msh", replaced(good, "$Nodes\n6", "$Nodes\n99999999999")), "too short for a count"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "$Nodes\n6", "$Nodes\n-4")), "negative"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "11 12 15", "11 12 11")), "no area"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "10 11 14 13\n5", "10 11 13 14\n5")), "crosses"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "5 2 2 2 2 11 12 15", "5 9 2 2 2 11 12 15 13 14 10")),
                   "only linear"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "5 2 2 2 2 11 12 15", "5 4 2 2 2 11 12 15 13")), "solid"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "11 14 15", "11 12 15")), "overlap"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "15 2 1 0", "15 2 1 0.5")), "not plane"));
  EXPECT_TRUE(
      says(mistake("a.msh", replaced(good, "3 1 2 7 1 11 12", "3 1 2 7 1 10 12")), "'floor' has an edge"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "2.2 0 8", "4.0 0 8")), "version"));
  EXPECT_TRUE(says(mistake("a.msh", replaced(good, "10 0 0 0\n11", "11 0 0 0\n11")), "twice"));
  EXPECT_TRUE(says(mistake("a.msh", good.substr(0, good.size() / 2)), "too short"));
  EXPECT_TRUE(says(mistake("a.msh", good.substr(0, good.size() - 13)), "too early"));
  EXPECT_TRUE(says(mistake("e.vtk", replaced(samples::vtk, "ASCII", "BINARY")), "only ASCII"));
  EXPECT_TRUE(
      says(mistake("e.vtk", replaced(samples::vtk, "3 1 2 5", "3 1 2 6")), "e.vtk:10: a cell has point 6"));
  EXPECT_TRUE(says(mistake("e.vtk", replaced(samples::vtk, "8 5 7 3", "8 22 7 3")), "cell type 22"));
  EXPECT_TRUE(says(mistake("g.vtu", replaced(vtu_ascii(), "4 7 10", "4 7 11")), "offset"));
  EXPECT_TRUE(says(mistake("g.vtu", replaced(vtu_ascii(), "1 2 5", "1 2 7")), "point is wrong"));
  EXPECT_TRUE(says(mistake("g.vtu", replaced(vtu_ascii(), "</Cells>", "</Cell>")), "XML"));
  EXPECT_TRUE(says(mistake("g.vtu", replaced(vtu_ascii(), "9 5 7", "9 five 7")), "'types' holds something"));
}

TEST(file, paths_and_regions_are_checked) {
  const auto folder = std::filesystem::temp_directory_path() / "ashlar_meshing_file";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "small.msh", std::ios::binary) << samples::msh2;
  auto with_path = [&](const std::string& path) {
    core::Value value = core::make_value(path);
    value.place.file = (folder / "scene.lua").string();
    return GeneratorSettings().set("path", value).with({});
  };
  auto message = [&](const Domain& domain, const std::string& path) {
    try {
      ashlar::meshing_file::generate(domain, with_path(path));
    } catch (const core::InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(ashlar::meshing_file::generate(Domain{}, with_path("small.msh")).points.size(), 6u);
  EXPECT_TRUE(says(message(Domain{}, "other.msh"), "there is no file"));
  EXPECT_TRUE(says(message(Domain{}, "small.stl"), "ending"));
  std::filesystem::create_directories(folder / "folder.msh");
  EXPECT_TRUE(says(message(Domain{}, "folder.msh"), "no regular file"));
  EXPECT_TRUE(
      says(message(zoo_domain({region("r", rectangle(1, 1))}), "small.msh"), "brings its own regions"));
  std::filesystem::remove_all(folder);
}

// Whatever happens to a file, it is read or refused: sanitizers watch for the rest.
TEST(file, spoilt_files_never_crash) {
  std::mt19937 random(17);
  int refused = 0, total = 0;
  for (const auto& sample : all_samples()) {
    for (int trial = 0; trial < 1500; ++trial, ++total) {
      std::string text = sample.text;
      if (trial % 3 == 0) text.resize(random() % text.size());
      const unsigned spoilt = trial % 3 == 0 ? random() % 2 : 1 + random() % 4;
      for (unsigned k = 0; k < spoilt && !text.empty(); ++k) {
        const std::size_t at = random() % text.size();
        const unsigned kind = random() % 4;
        if (kind == 0) text[at] = static_cast<char>(random() % 256);
        if (kind == 1) text[at] = static_cast<char>('0' + random() % 10);
        if (kind == 2) text.insert(at, random() % 2 == 0 ? "999999999" : "-");
        if (kind == 3) text.erase(at, 1 + random() % 8);
      }
      try {
        build_mesh(read(sample.name, text), Domain{});
      } catch (const core::InputError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, total / 2);
}
