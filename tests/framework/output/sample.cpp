#include "sample.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace ashlar::output {

using geometry::Point;
using mesh::Index;
using mesh::Mesh;
using model::FieldResult;

namespace {

constexpr Point mouth{4, 10}, tip{10, 4};

/// Squares in rows, the dam's columns leaning; every second pair of neighbours becomes one six-cornered
/// brick.
class Builder {
 public:
  explicit Builder(int fineness) : h_(1.0 / fineness) {
    fill(0, 25 * fineness, 0, 10 * fineness, 0);
    fill(10 * fineness, 15 * fineness, 10 * fineness, 15 * fineness, 1);
    add_edges();
    add_groups();
  }
  Mesh mesh;

 private:
  // Points are numbered by their grid place and, on the joint, by their side.
  Index point(int i, int j, bool upper) {
    const bool on_joint =
        std::abs((i + j) * h_ - 14) < 1e-9 && i * h_ < tip.x - 1e-9 && i * h_ > mouth.x - 1e-9;
    const auto key = std::array<int, 3>{i, j, on_joint && upper};
    const auto [found, is_new] = numbers_.emplace(key, static_cast<Index>(mesh.points.size()));
    const double y = j * h_, x = i * h_;
    if (is_new) mesh.points.push_back({y > 10 ? 10 + (x - 10) * (1 - 0.6 * (y - 10) / 5) : x, y});
    return found->second;
  }
  void cell(const std::vector<std::array<int, 2>>& corners, Index region) {
    double sum = 0;
    for (const auto& [i, j] : corners) sum += (i + j) * h_;
    const bool upper = sum / static_cast<double>(corners.size()) > 14;
    std::vector<Index> ring;
    for (const auto& [i, j] : corners) ring.push_back(point(i, j, upper));
    mesh.cell_points.append(ring);
    mesh.cell_region.push_back(region);
  }
  void fill(int i0, int i1, int j0, int j1, Index region) {
    auto crossed = [&](int i, int j) {
      return std::abs((i + j + 1) * h_ - 14) < 1e-9 && region == 0 && i * h_ < tip.x &&
             i * h_ > mouth.x - 1e-9;
    };
    for (int j = j0; j < j1; ++j)
      for (int i = i0; i < i1; ++i) {
        if (crossed(i, j)) {
          cell({{i, j}, {i + 1, j}, {i, j + 1}}, region);
          cell({{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}, region);
        } else if ((i + j) % 2 == 0 && i + 1 < i1 && !crossed(i + 1, j)) {
          cell({{i, j}, {i + 1, j}, {i + 2, j}, {i + 2, j + 1}, {i + 1, j + 1}, {i, j + 1}}, region);
          ++i;
        } else {
          cell({{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}, region);
        }
      }
  }
  void add_edges() {
    std::map<std::array<Index, 2>, Index> seen;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
      const auto ring = mesh.cell_points[c];
      std::vector<Index> edges;
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Index a = ring[k], b = ring[(k + 1) % ring.size()];
        const auto [found, is_new] =
            seen.emplace(std::array{std::min(a, b), std::max(a, b)}, mesh.edge_count());
        if (is_new) {
          mesh.edge_points.push_back({a, b});
          mesh.edge_cells.push_back({c, -1});
        } else {
          mesh.edge_cells[found->second][1] = c;
        }
        edges.push_back(found->second);
      }
      mesh.cell_edges.append(edges);
    }
  }
  void add_groups() {
    mesh.regions = {"rock", "dam"};
    mesh::JointLips joint{"fault", {"upper", "lower"}, {}};
    for (Index e = 0; e < mesh.edge_count(); ++e) {
      if (mesh.edge_cells[e][1] >= 0) continue;
      auto [a, b] = mesh.edge_points[e];
      const Point p = mesh.points[a], q = mesh.points[b];
      auto both = [&](auto holds) { return holds(p) && holds(q); };
      if (both([](Point r) { return r.y < 1e-9; })) mesh.edge_groups["rock.bottom"].push_back(e);
      if (both([](Point r) { return std::abs(r.x - 10) < 1e-9 && r.y > 10 - 1e-9; }))
        mesh.edge_groups["dam.upstream"].push_back(e);
      if (!both([](Point r) { return std::abs(r.x + r.y - 14) < 1e-9 && r.x > 4 - 1e-9 && r.x < 10 + 1e-9; }))
        continue;
      // The upper cells have the joint's direction against them: the body is on the left of (4,10)→(10,4).
      const int side = q.x > p.x ? 0 : 1;
      if (side == 1) std::swap(a, b);
      auto s = [](Point r) { return geometry::distance(mouth, r); };
      joint.lips[side].push_back({e, mesh.edge_cells[e][0], a, b, s(mesh.points[a]), s(mesh.points[b])});
      mesh.edge_groups[side == 0 ? "fault.upper" : "fault.lower"].push_back(e);
    }
    for (auto& lip : joint.lips)
      std::sort(lip.begin(), lip.end(), [](const auto& x, const auto& y) { return x.s_from < y.s_from; });
    mesh.joints = {joint};
  }

  double h_;
  std::map<std::array<int, 3>, Index> numbers_;
};

Point middle(const Mesh& mesh, Index cell) {
  Point sum;
  for (const Index p : mesh.cell_points[cell]) sum = sum + mesh.points[p];
  return (1.0 / mesh.cell_points.count(cell)) * sum;
}

Point displacement(Point p, bool upper, double load) {
  const double depth = p.y / 10;
  Point u{2e-5 * load * depth * (1 + 0.3 * p.y),
          -8e-5 * depth * (1 + 0.02 * p.y) - 1e-5 * load * depth * (p.x - 10)};
  // Opens and slips along the joint, most at its mouth.
  const double s = geometry::distance(mouth, p);
  if (upper && p.x + p.y > 14 - 1e-9) {
    const double fade = std::sqrt(std::max(0.0, 1 - s / 8.4853)) * std::exp(-(p.x + p.y - 14) / 8);
    u = u + fade * Point{3e-5 + 4e-5 * load, -3e-5 + 1e-5 * load};
  }
  return u;
}

FieldResult displacement_field(const Mesh& mesh, double load) {
  FieldResult field{"displacement", "m", FieldResult::On::points, 2, {"x", "y"}, {}};
  std::vector<char> upper(mesh.points.size());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const Index p : mesh.cell_points[c]) upper[p] |= middle(mesh, c).x + middle(mesh, c).y > 14;
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    const Point u = displacement(mesh.points[i], upper[i], load);
    field.values.insert(field.values.end(), {u.x, u.y});
  }
  return field;
}

FieldResult stress_field(const Mesh& mesh, double load) {
  FieldResult field{"stress", "Pa", FieldResult::On::cells, 4, {"xx", "yy", "xy", "zz"}, {}};
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const Point m = middle(mesh, c);
    const double top = m.x > 10 && m.x < 15 ? 15 : 10;
    const double peak = 3e4 * (0.3 + load) / std::sqrt(0.02 + geometry::distance(m, tip));
    const double yy = -24e3 * (top - m.y) + peak, xx = 0.43 * yy + 0.7 * peak;
    field.values.insert(field.values.end(), {xx, yy, 2e4 * load * std::sin(m.x / 4), 0.3 * (xx + yy)});
  }
  return field;
}

model::JointResult joint_result(const Mesh& mesh, double load) {
  model::JointResult joint;
  joint.name = "fault";
  auto add = [&](double s, Point at) {
    const double t = s / 8.4853;
    model::JointResult::Row row{.s = s, .at = at};
    row.slip = 4e-5 * (0.4 + load) * std::sqrt(std::max(0.0, 1 - t));
    row.piece = t > 0.55 ? 1 : 0;
    row.pressure = std::max(0.0, 1.8e5 * t * (1.1 - t) - 2e4 * load);
    row.closed = row.pressure > 0;
    row.state = row.closed ? model::JointResult::Row::State::slip : model::JointResult::Row::State::open;
    row.opening = row.closed ? -1e-9 * row.pressure / 1e5 : 6e-6 * load * (1 - t);
    joint.rows.push_back(row);
    joint.max_pressure = std::max(joint.max_pressure, row.pressure);
    joint.max_slip = std::max(joint.max_slip, row.slip);
    joint.max_opening = std::max(joint.max_opening, row.opening);
    joint.closed += row.closed;
  };
  for (const auto& edge : mesh.joints[0].lips[0]) add(edge.s_from, mesh.points[edge.from]);
  add(mesh.joints[0].lips[0].back().s_to, tip);
  joint.points = static_cast<int>(joint.rows.size());
  joint.normal_force = 4.5e5;
  joint.resultant = {3.2e5, 3.2e5, 1e6};
  joint.max_penetration = 1.2e-9;
  joint.penetration_over_h = 4e-9;
  return joint;
}

/// Across two materials, then along a joint with values of both sides.
model::SectionResult section_result(double load) {
  using Side = model::SectionResult::Side;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  model::SectionResult section;
  section.name = "base";
  section.first = {10, 10};
  section.last = {15, 10};
  section.forces = {-6.42e6, 1.226e5 * load, 3.3e5};
  section.summed = section.integrated = true;
  section.integral = {-6.4e6, 1.2e5 * load, 3.2e5};
  section.absolute = section.size = 6.5e6;
  section.difference = 0.0312;
  section.columns = {{"ux", "m"}, {"sn", "Pa"}, {"tau", "Pa"}};
  for (int i = 0; i <= 6; ++i) {
    const double s = i < 3 ? i : i - 1;
    section.rows.push_back({s,
                            {10 + s, 10},
                            i < 3 ? Side::both : Side::left,
                            i < 3 ? 0 : 1,
                            "dam",
                            {i == 1 ? unknown : 1e-4, -1e6 - 1e5 * s - (i < 3 ? 0 : 4e5), 3e4 * load * s}});
  }
  for (int i = 2; i <= 5; ++i)
    section.rows.push_back({1.0 * i, {10.0 + i, 10}, Side::right, 2, "rock", {2e-4, -9e5, 2e4 * load}});
  return section;
}

model::StageResult stage(const Mesh& mesh, const std::string& name, double load) {
  model::StageResult result;
  result.name = name;
  result.effects = {"elasticity", "gravity", "contact"};
  result.fields = {displacement_field(mesh, load), stress_field(mesh, load)};
  result.joints = {joint_result(mesh, load)};
  result.sections = {section_result(load)};
  result.probes = {{"crest", {10, 15}, {10, 15}, {{"ux", 1.0 / 3e5 * load}, {"uy", -1e-4}}},
                   {"heel, left", {10, 10}, {10, 10}, {{"ux", 0.1}, {"uy", -8e-5}, {"sxx", 1.25e5}}}};
  result.balance.loads = {{"gravity", {0, -6.42e6, -8.1e7}}};
  if (load > 0) result.balance.loads.push_back({"water", {1.226e5 * load, 0, -1.4e6}});
  result.balance.load = {1.226e5 * load, -6.42e6, -8.24e7};
  result.balance.reactions = {{"rock.bottom", {-1.226e5 * load, 6.42e6, 8.24e7}}};
  result.balance.reaction = {-1.226e5 * load, 6.42e6, 8.24e7};
  result.balance.relative_error = 3e-15;
  result.iterations = {{1, 1, 0.03, {{"closed", 20}, {"opened", 3}}}, {1, 2, 1e-14, {{"closed", 18}}}};
  result.extremes = {{"ux", "m", -1e-5, 3.2e-4, {0, 5}, {10, 15}},
                     {"sxx (cells)", "Pa", -2e5, 1e5, {3, 0}, tip}};
  result.unknowns = 2 * mesh.point_count();
  result.backward_error = 1e-16;
  result.solver = "CHOLMOD";
  return result;
}

core::Settings::Entry entry(const std::string& key, core::Value value, bool said,
                            core::Dimension dimension = {}) {
  core::Settings::Entry made;
  made.key = key;
  made.value = std::move(value);
  made.said = said;
  made.dimension = dimension;
  return made;
}

}  // namespace

RunRecord Sample::record() const {
  return {scene,
          plan,
          model,
          result,
          report,
          ledger,
          log,
          {{"scene.lua", "return Scene { title = \"δ\" }\n"}},
          {{"cells", "500", true}, {"level", "15 m", false}},
          {{"ashlar", "0.1.0"}},
          {"gravity"},
          "ashlar run examples/jointed_dam",
          2};
}

Sample make_sample(int fineness) {
  Sample sample;
  sample.scene.title = "Dam on a jointed foundation";
  sample.scene.root.kind = "scene";
  sample.scene.root.entries = {
      entry("title", core::make_value(std::string("Dam"), {"scene.lua", 3, "title"}), true),
      entry("thickness", core::make_value(1.0), false, core::parse_dimension("m"))};
  sample.plan.stages = {
      {"self-weight", {{"gravity", "gravity", {"scene.lua", 20, "stages[1].gravity"}, false}}}};
  sample.plan.left_out = {{"water", "water", {"stage.water"}, false, "Water.", "water: it matters when …"}};
  sample.model.mesh = Builder(fineness).mesh;
  sample.result.stages = {stage(sample.model.mesh, "self-weight", 0),
                          stage(sample.model.mesh, "reservoir", 1)};
  sample.report.cells = sample.model.mesh.cell_count();
  sample.report.points = sample.model.mesh.point_count();
  sample.report.notes = {{"seed", "7"}};
  { const auto scope = sample.ledger.time("mesh"); }
  sample.log.info("made up");
  return sample;
}

namespace {

/// Removed when the program ends.
struct Folders {
  std::vector<std::filesystem::path> made;
  ~Folders() {
    std::error_code ignored;
    for (const auto& folder : made) std::filesystem::remove_all(folder, ignored);
  }
};

}  // namespace

std::filesystem::path fresh_folder(const std::string& name) {
  static Folders folders;
  const auto folder =
      std::filesystem::temp_directory_path() / ("ashlar-" + name + "-" + std::to_string(::getpid()));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  folders.made.push_back(folder);
  return folder;
}

std::string slurp(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace ashlar::output
