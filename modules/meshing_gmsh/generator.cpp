#include <fcntl.h>
#include <gmsh.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>
#include <map>

#include "core/registry.hpp"
#include "geometry/polygon.hpp"
#include "gmsh_mesh.hpp"

namespace ashlar::meshing_gmsh {

namespace {

using geometry::Point;
using mesh::Domain;
using mesh::Index;
using mesh::SizeField;

// Gmsh's own numbers. Its frontal method for quads (8) crashes in 4.8.4 and is not offered.
const std::map<std::string, int> algorithms = {{"meshadapt", 1}, {"delaunay", 5}, {"frontal", 6}};
constexpr int triangle = 2, quadrangle = 3;

/// Gmsh for the time of one mesh: quiet, on one thread, without the user's own configuration.
class Session {
 public:
  Session() {
    gmsh::initialize(0, nullptr, false);
    const std::vector<std::pair<std::string, double>> options = {
        {"General.Terminal", 0},
        {"General.NumThreads", 1},
        // Errors thrown inside Gmsh's parallel regions would end the program; we read the last one instead.
        {"General.AbortOnError", 0},
        {"Mesh.RandomSeed", 1},
        {"Mesh.MeshSizeExtendFromBoundary", 0},
        {"Mesh.MeshSizeFromPoints", 0},
        {"Mesh.MeshSizeFromCurvature", 0}};
    for (const auto& [name, value] : options) gmsh::option::setNumber(name, value);
    gmsh::model::add("ashlar");
  }
  ~Session() {
    gmsh::model::mesh::removeSizeCallback();
    gmsh::finalize();
  }
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
};

/// Keeps both outputs of the process shut: the matching inside Gmsh's recombination prints past every option.
class Muted {
 public:
  Muted() {
    std::fflush(nullptr);
    const int nowhere = open("/dev/null", O_WRONLY);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      kept_[i] = dup(outputs[i]);
      dup2(nowhere, outputs[i]);
    }
    close(nowhere);
  }
  ~Muted() {
    std::fflush(nullptr);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      dup2(kept_[i], outputs[i]);
      close(kept_[i]);
    }
  }
  Muted(const Muted&) = delete;
  Muted& operator=(const Muted&) = delete;

 private:
  static constexpr std::array<int, 2> outputs = {STDOUT_FILENO, STDERR_FILENO};
  std::array<int, 2> kept_{};
};

Index region_of(const Domain& domain, Index face) {
  return face < 0 ? -1 : domain.faces[face].region;
}

// Curves take the finer size of their two sides.
double size_of_entity(const Domain& domain, const SizeField& sizes, int dimension, int tag, Point p) {
  if (dimension == 2) return sizes.at(p, region_of(domain, tag - 1));
  if (dimension != 1) return sizes.at(p, -1);
  const auto& segment = domain.segments[tag - 1];
  const Index left = region_of(domain, segment.left), right = region_of(domain, segment.right);
  if (left < 0 || right < 0) return sizes.at(p, std::max(left, right));
  return std::min(sizes.at(p, left), sizes.at(p, right));
}

void make_mesh(const Domain& domain, const SizeField& sizes, const core::Settings& settings) {
  give_geometry(domain);
  gmsh::model::mesh::setSizeCallback([&](int dimension, int tag, double x, double y, double) {
    return size_of_entity(domain, sizes, dimension, tag, {x, y});
  });
  gmsh::option::setNumber("Mesh.Algorithm", algorithms.at(settings.text("algorithm")));
  if (settings.text("cells") == "quads") {
    gmsh::option::setNumber("Mesh.RecombineAll", 1);
    gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 1);
  }
  const Muted muted;
  gmsh::model::mesh::generate(2);
}

/// Gmsh's nodes under our numbers, given out in the order in which cells use them.
class Points {
 public:
  explicit Points(mesh::RawMesh& raw) : raw_(raw) {
    std::vector<std::size_t> tags;
    std::vector<double> coordinates, parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters, -1, -1, false, false);
    for (std::size_t k = 0; k < tags.size(); ++k) {
      if (tags[k] >= places_.size()) places_.resize(tags[k] + 1);
      places_[tags[k]] = {coordinates[3 * k], coordinates[3 * k + 1]};
    }
    numbers_.assign(places_.size(), -1);
  }
  Index number(std::size_t tag) {
    if (numbers_[tag] < 0) {
      numbers_[tag] = static_cast<Index>(raw_.points.size());
      raw_.points.push_back(places_[tag]);
    }
    return numbers_[tag];
  }

 private:
  mesh::RawMesh& raw_;
  std::vector<Point> places_;
  std::vector<Index> numbers_;
};

void take_cells(mesh::RawMesh& raw, Points& points, int surface, Index region) {
  for (const int type : {triangle, quadrangle}) {
    std::vector<std::size_t> elements, nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes, surface);
    const std::size_t corners = type == triangle ? 3 : 4;
    std::vector<Index> cell(corners);
    std::vector<Point> ring(corners);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      for (std::size_t k = 0; k < corners; ++k) {
        cell[k] = points.number(nodes[e * corners + k]);
        ring[k] = raw.points[cell[k]];
      }
      if (geometry::signed_area(ring) < 0) std::reverse(cell.begin(), cell.end());
      raw.cell_points.append(cell);
      raw.cell_region.push_back(region);
    }
  }
}

mesh::RawMesh take_mesh(const Domain& domain, const core::Settings& settings) {
  mesh::RawMesh raw;
  Points points(raw);
  for (std::size_t f = 0; f < domain.faces.size(); ++f) {
    if (domain.faces[f].region < 0) continue;
    take_cells(raw, points, static_cast<int>(f) + 1, domain.faces[f].region);
  }
  const std::string algorithm = settings.text("algorithm");
  raw.notes = {{"generator", "gmsh " + std::string(GMSH_API_VERSION)},
               {"algorithm", algorithm + " (" + std::to_string(algorithms.at(algorithm)) + ")"},
               {"cells", settings.text("cells")}};
  return raw;
}

// What is wrong with the mesh; empty if cells fill every region.
std::string fault_of(const Domain& domain, const mesh::RawMesh& raw) {
  double missing = 0, area = 0;
  const Point origin = domain.points.front();
  for (const auto& segment : domain.segments) {
    const double part =
        0.5 * geometry::cross(domain.points[segment.from] - origin, domain.points[segment.to] - origin);
    if (region_of(domain, segment.left) >= 0) missing += part;
    if (region_of(domain, segment.right) >= 0) missing -= part;
  }
  std::vector<Point> ring;
  for (Index c = 0; c < raw.cell_points.size(); ++c) {
    ring.clear();
    for (const Index corner : raw.cell_points[c]) ring.push_back(raw.points[corner]);
    area += geometry::signed_area(ring);
    if (!(geometry::signed_area(ring) > 0) || !geometry::is_simple(ring))
      return "a cell has no area or crosses itself";
  }
  if (std::abs(missing - area) <= 1e-9 * missing) return "";
  return "its cells do not fill the regions";
}

}  // namespace

mesh::RawMesh generate(const Domain& domain, const core::Settings& settings) {
  const SizeField sizes = SizeField::read(domain, settings, 1.0);
  core::Mistake mistake;
  mistake.place = settings.place;
  mistake.advice = "try another algorithm or size, or mesh.voronoi";
  try {
    Session session;
    make_mesh(domain, sizes, settings);
    mesh::RawMesh raw = take_mesh(domain, settings);
    const std::string fault = fault_of(domain, raw);
    if (fault.empty()) return raw;
    std::string said;
    gmsh::logger::getLastError(said);
    mistake.what = "Gmsh failed: " + fault + (said.empty() ? "" : "; it says: " + said);
  } catch (const core::InputError&) {
    throw;
  } catch (const std::exception& error) {
    mistake.what = std::string("Gmsh failed: ") + error.what();
  } catch (const std::string& error) {
    mistake.what = "Gmsh failed: " + error;
  } catch (int code) {
    mistake.what = "Gmsh failed with code " + std::to_string(code);
  }
  throw core::InputError(mistake);
}

}  // namespace ashlar::meshing_gmsh

ASHLAR_MODULE(registry) {
  registry.add_make("mesh", "gmsh",
                    std::function<ashlar::mesh::GenerateMesh>(ashlar::meshing_gmsh::generate));
}
