#include "crosscheck/calculix.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace ashlar::test {

namespace {

using geometry::Point;
using mesh::Index;

constexpr double gravity = 9.80665;  // only its product with the density acts

class Writer {
 public:
  explicit Writer(const SceneRun& run)
      : scene_(run.scenario->scene), model_(run.model), mesh_(run.model.mesh) {
    text_.precision(12);
  }

  std::string write() {
    nodes();
    elements();
    materials();
    supports();
    for (const mesh::JointLips& joint : mesh_.joints) contact(joint);
    probes();
    for (const model::StageData& stage : scene_.stages) step(stage);
    return text_.str();
  }

 private:
  // Front and back copies of a mesh point; CalculiX counts from 1.
  int front(Index point) const { return point + 1; }
  int back(Index point) const { return mesh_.point_count() + point + 1; }

  void nodes() {
    text_ << "*NODE, NSET=ALL\n";
    for (Index p = 0; p < mesh_.point_count(); ++p)
      text_ << front(p) << ',' << mesh_.points[p].x << ',' << mesh_.points[p].y << ",0\n"
            << back(p) << ',' << mesh_.points[p].x << ',' << mesh_.points[p].y << ',' << model_.thickness
            << '\n';
  }

  // C3D8I would bend better but fails the patch test on distorted cells: it does not settle.
  void elements() {
    for (std::size_t region = 0; region < mesh_.regions.size(); ++region)
      for (const std::size_t corners : {4, 3}) {
        text_ << "*ELEMENT, TYPE=" << (corners == 4 ? "C3D8" : "C3D6") << ", ELSET=REGION" << region << '\n';
        for (Index cell = 0; cell < mesh_.cell_count(); ++cell) element(cell, region, corners);
      }
  }

  void element(Index cell, std::size_t region, std::size_t corners) {
    const auto points = mesh_.cell_points[cell];
    if (points.size() != 3 && points.size() != 4)
      throw std::runtime_error("CalculiX knows no cell with " + std::to_string(points.size()) + " corners");
    if (mesh_.cell_region[cell] != static_cast<Index>(region) || points.size() != corners) return;
    text_ << cell + 1;
    for (const Index p : points) text_ << ',' << front(p);
    for (const Index p : points) text_ << ',' << back(p);
    text_ << '\n';
  }

  void materials() {
    for (std::size_t r = 0; r < scene_.regions.size(); ++r) {
      const core::Settings& rock = scene_.regions[r].material;
      text_ << "*MATERIAL, NAME=ROCK" << r << "\n*ELASTIC\n"
            << rock.number("E") << ',' << rock.number("nu") << "\n*DENSITY\n"
            << rock.number("unit_weight") / gravity << "\n*SOLID SECTION, ELSET=REGION" << r
            << ", MATERIAL=ROCK" << r << '\n';
    }
  }

  void supports() {
    text_ << "*BOUNDARY\nALL,3,3\n";
    for (const model::SupportData& support : scene_.stages.front().supports)
      for (int axis = 0; axis < 2; ++axis) {
        if (!support.move[axis]) continue;
        std::set<Index> held;
        for (const Index edge : mesh_.edge_groups.at(support.edge))
          held.insert(mesh_.edge_points[edge].begin(), mesh_.edge_points[edge].end());
        for (const Index p : held)
          for (const int node : {front(p), back(p)})
            text_ << node << ',' << axis + 1 << ',' << axis + 1 << '\n';
      }
  }

  // Side face i of a solid joins its corners i and i + 1, which is face S(i + 3).
  void surface(const std::string& name, const std::vector<mesh::LipEdge>& lip) {
    text_ << "*SURFACE, NAME=" << name << '\n';
    for (const mesh::LipEdge& edge : lip) {
      const auto edges = mesh_.cell_edges[edge.cell];
      const auto side = std::find(edges.begin(), edges.end(), edge.edge) - edges.begin();
      text_ << edge.cell + 1 << ",S" << side + 3 << '\n';
    }
  }

  double penalty_stiffness(const mesh::JointLips& joint) const {
    const core::Settings& settings = scene_.joints.front().settings;
    const double length = joint.lips[0].back().s_to - joint.lips[0].front().s_from;
    const double mean_edge = length / static_cast<double>(joint.lips[0].size());
    return settings.object("enforce").number("factor") *
           model_.material(joint.lips[0].front().cell).plane_modulus() / mean_edge;
  }

  // Node to face: p = K overclosure. CalculiX rounds the kink at zero so that an open face pulls with at most
  // the second number [Pa]; joint pressures are 1e5 times that.
  void contact(const mesh::JointLips& joint) {
    if (mesh_.joints.size() > 1) throw std::runtime_error("the comparison knows one joint only");
    surface("SLAVE", joint.lips[0]);
    surface("MASTER", joint.lips[1]);
    text_ << "*SURFACE INTERACTION, NAME=JOINT\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n"
          << penalty_stiffness(joint) << ",1.\n"
          << "*CONTACT PAIR, INTERACTION=JOINT, TYPE=NODE TO SURFACE, SMALL SLIDING\nSLAVE,MASTER\n";
  }

  void probes() {
    text_ << "*NSET, NSET=PROBES\n";
    for (const model::ProbeData& probe : scene_.probes)
      text_ << front(mesh::nearest_point(mesh_, probe.at, probe.lip)) << '\n';
  }

  void step(const model::StageData& stage) {
    text_ << "*STEP, INC=1000\n*CONTROLS, PARAMETERS=FIELD\n1e-5,1e-5\n*STATIC\n1.,1.\n";
    if (const core::Value& said = stage.settings.value("gravity"); said.boolean() && *said.boolean()) {
      text_ << "*DLOAD\n";
      for (std::size_t r = 0; r < scene_.regions.size(); ++r)
        text_ << "REGION" << r << ",GRAV," << gravity << ",0.,-1.,0.\n";
    }
    if (stage.settings.has("water")) water(stage.settings.object("water"));
    text_ << "*NODE PRINT, NSET=PROBES\nU\n*END STEP\n";
  }

  // A face has one pressure in CalculiX; nodal forces of the linear pressure load both meshes alike.
  // Exact as long as the level cuts no edge.
  void water(const core::Settings& water) {
    text_ << "*CLOAD\n";
    const double weight = water.number("unit_weight", 9810);
    const auto pressure = [&](Point p) { return weight * std::max(0.0, water.number("level") - p.y); };
    for (const core::Value& name : water.value("on").table()->items)
      for (const Index edge : mesh_.edge_groups.at(*name.text())) {
        const auto [a, b] = mesh_.edge_points[edge];
        const double pa = pressure(mesh_.points[a]), pb = pressure(mesh_.points[b]);
        nodal_force(a, edge, (2 * pa + pb) / 6);
        nodal_force(b, edge, (pa + 2 * pb) / 6);
      }
  }

  void nodal_force(Index point, Index edge, double pressure) {
    const auto [a, b] = mesh_.edge_points[edge];
    const Point along = mesh_.points[b] - mesh_.points[a];
    // The body lies on the left: (along.y, −along.x) points outwards, the water pushes inwards.
    const std::array<double, 2> force = {-pressure * along.y, pressure * along.x};
    for (int axis = 0; axis < 2; ++axis)
      for (const int node : {front(point), back(point)})
        text_ << node << ',' << axis + 1 << ',' << force[axis] * model_.thickness / 2 << '\n';
  }

  const model::Scene& scene_;
  const model::Model& model_;
  const mesh::Mesh& mesh_;
  std::ostringstream text_;
};

double children_cpu() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}  // namespace

std::string calculix_input(const SceneRun& run) {
  return Writer(run).write();
}

ProbeMoves read_calculix_table(const SceneRun& run, const std::filesystem::path& dat) {
  std::ifstream in(dat);
  ProbeMoves moves;
  std::map<int, std::array<double, 2>> by_node;
  const auto close_block = [&] {
    if (by_node.empty()) return;
    auto& stage = moves.emplace_back();
    for (const model::ProbeData& probe : run.scenario->scene.probes)
      stage[probe.name] = by_node.at(mesh::nearest_point(run.model.mesh, probe.at, probe.lip) + 1);
    by_node.clear();
  };
  for (std::string line; std::getline(in, line);) {
    if (line.find("displacements") != std::string::npos) close_block();
    std::istringstream words(line);
    int node = 0;
    std::array<double, 2> u{};
    if (words >> node >> u[0] >> u[1]) by_node[node] = u;
  }
  close_block();
  if (moves.size() != run.scenario->scene.stages.size())
    throw std::runtime_error("CalculiX finished " + std::to_string(moves.size()) + " of " +
                             std::to_string(run.scenario->scene.stages.size()) + " steps, see " +
                             dat.string());
  return moves;
}

bool has_calculix() {
  return std::system("command -v ccx >/dev/null 2>&1") == 0;
}

void call_calculix(const std::filesystem::path& folder, const std::string& job) {
  const std::string call = "cd '" + folder.string() + "' && OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 ccx " +
                           job + " >" + job + ".log 2>&1";
  [[maybe_unused]] const int code = std::system(call.c_str());
}

CalculixRun run_calculix(const SceneRun& run, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "scene.inp") << calculix_input(run);
  const double before = children_cpu();
  call_calculix(folder, "scene");
  return {read_calculix_table(run, folder / "scene.dat"), children_cpu() - before};
}

ProbeMoves probe_moves(const SceneRun& run) {
  ProbeMoves moves;
  for (const model::StageResult& stage : run.result.stages) {
    auto& row = moves.emplace_back();
    for (const model::ProbeResult& probe : stage.probes)
      row[probe.name] = {probe.values.at("ux"), probe.values.at("uy")};
  }
  return moves;
}

}  // namespace ashlar::test
