#include "meshing_file/file.hpp"

#include <filesystem>
#include <fstream>

#include "core/registry.hpp"
#include "meshing_file/contents.hpp"

namespace ashlar::meshing_file {

namespace {

constexpr std::uintmax_t largest_file = std::uintmax_t{1} << 30;  // offsets and memory stay in hand

[[noreturn]] void fail(const core::Place& place, const std::string& what, const std::string& advice = {}) {
  core::Mistake mistake;
  mistake.place = place;
  mistake.what = what;
  mistake.advice = advice;
  throw core::InputError(std::move(mistake));
}

std::string contents_of(const std::filesystem::path& path, const core::Place& place) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) fail(place, "there is no file '" + path.string() + "'");
  if (!std::filesystem::is_regular_file(path, error))
    fail(place, "'" + path.string() + "' is no regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > largest_file)
    fail(place, "'" + path.string() + "' is larger than 1 GB or cannot be measured");
  std::ifstream stream(path, std::ios::binary);
  std::string text(size, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(size));
  if (!stream || stream.gcount() != static_cast<std::streamsize>(size))
    fail(place, "'" + path.string() + "' cannot be read");
  return text;
}

bool is_known(const std::string& ending) {
  return ending == ".msh" || ending == ".vtk" || ending == ".vtu";
}

}  // namespace

mesh::RawMesh read(const std::string& name, const std::string& text) {
  Cursor cursor(name, text);
  const std::string ending = std::filesystem::path(name).extension().string();
  Contents contents = ending == ".msh"   ? read_msh(cursor)
                      : ending == ".vtk" ? read_vtk(cursor)
                                         : read_vtu(cursor, text);
  return finish(std::move(contents), cursor);
}

mesh::RawMesh generate(const mesh::Domain& domain, const core::Settings& settings) {
  const core::Place place = settings.place_of("path");
  if (!domain.faces.empty()) {
    fail(place, "mesh.file brings its own regions: the scene's geometry must name groups of the file",
         "geometry = { rock = MeshGroup { \"name in the file\", material = … } }");
  }
  std::filesystem::path path = settings.text("path");
  if (path.is_relative()) path = std::filesystem::path(place.file).parent_path() / path;
  if (!is_known(path.extension().string())) {
    fail(place, "'" + path.string() + "' has an ending that is not known", "valid: .msh, .vtk, .vtu");
  }
  return read(path.string(), contents_of(path, place));
}

}  // namespace ashlar::meshing_file

ASHLAR_MODULE(registry) {
  registry.add_make("mesh", "file",
                    std::function<ashlar::mesh::GenerateMesh>(ashlar::meshing_file::generate));
}
