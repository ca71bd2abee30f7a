#include "mesh/verify.hpp"

#include <algorithm>
#include <set>

#include "geometry/polygon.hpp"

namespace ashlar::mesh {

namespace {

class Checker {
 public:
  explicit Checker(const Mesh& mesh) : mesh_(mesh) {}

  std::vector<std::string> run() {
    if (!check_sizes()) return faults_;
    check_cells();
    check_edges();
    check_groups();
    for (const auto& joint : mesh_.joints) check_joint(joint);
    return faults_;
  }

 private:
  void require(bool holds, const std::string& what) {
    if (!holds) faults_.push_back(what);
  }
  bool is_edge(Index e) const { return e >= 0 && e < mesh_.edge_count(); }

  bool check_sizes() {
    const auto cells = static_cast<std::size_t>(mesh_.cell_count());
    require(mesh_.cell_edges.size() == mesh_.cell_count(), "cell_edges has another length than cell_points");
    require(mesh_.cell_region.size() == cells, "cell_region has another length than cell_points");
    require(mesh_.edge_cells.size() == mesh_.edge_points.size(),
            "edge_cells has another length than edge_points");
    for (const Index p : mesh_.cell_points.values()) {
      if (p < 0 || p >= mesh_.point_count()) return require(false, "a cell has a point out of range"), false;
    }
    for (const Index e : mesh_.cell_edges.values()) {
      if (!is_edge(e)) return require(false, "a cell has an edge out of range"), false;
    }
    return faults_.empty();
  }

  void check_cells() {
    std::vector<bool> used(mesh_.points.size(), false);
    std::vector<Point> corners;
    for (Index c = 0; c < mesh_.cell_count(); ++c) {
      const std::string name = "cell " + std::to_string(c);
      const auto points = mesh_.cell_points[c];
      const auto edges = mesh_.cell_edges[c];
      mesh_.corners(c, corners);
      require(geometry::signed_area(corners) > 0, name + " is not counter-clockwise");
      require(geometry::is_simple(corners), name + " is not simple");
      const Index region = mesh_.cell_region[c];
      require(region >= 0 && region < static_cast<Index>(mesh_.regions.size()), name + " has no region");
      require(edges.size() == points.size(), name + " has not as many edges as points");
      for (std::size_t i = 0; i < std::min(points.size(), edges.size()); ++i) {
        const Index a = points[i], b = points[(i + 1) % points.size()];
        used[a] = true;
        const auto& cells = mesh_.edge_cells[edges[i]];
        const std::array<Index, 2> along{a, b}, against{b, a};
        const auto& ends = mesh_.edge_points[edges[i]];
        require((cells[0] == c && ends == along) || (cells[1] == c && ends == against),
                name + " and its edge " + std::to_string(edges[i]) + " do not agree");
      }
    }
    require(std::find(used.begin(), used.end(), false) == used.end(), "a point belongs to no cell");
  }

  void check_edges() {
    for (Index e = 0; e < mesh_.edge_count(); ++e) {
      const auto [first, second] = mesh_.edge_cells[e];
      require(second < 0 || first < second,
              "edge " + std::to_string(e) + ": its first cell is not the lowest");
    }
  }

  void check_groups() {
    for (const auto& [name, edges] : mesh_.edge_groups) {
      require(std::all_of(edges.begin(), edges.end(), [this](Index e) { return is_edge(e); }),
              "edge group " + name + " has an edge out of range");
    }
    for (const auto& [name, points] : mesh_.point_groups) {
      require(std::all_of(points.begin(), points.end(),
                          [this](Index p) { return p >= 0 && p < mesh_.point_count(); }),
              "point group " + name + " has a point out of range");
    }
  }

  void check_lip(const std::string& name, const std::vector<LipEdge>& lip, bool first) {
    for (std::size_t i = 0; i < lip.size(); ++i) {
      const LipEdge& edge = lip[i];
      require(edge.s_from < edge.s_to, name + ": s does not grow along a lip");
      require(i == 0 || edge.s_from >= lip[i - 1].s_from, name + ": not ordered");
      const std::array<Index, 2> along{edge.from, edge.to}, against{edge.to, edge.from}, one{edge.cell, -1};
      require(mesh_.edge_points[edge.edge] == (first ? along : against),
              name + (first ? ": the first lip is not on the left" : ": the second lip is not on the right"));
      require(mesh_.edge_cells[edge.edge] == one, name + ": a lip's edge has not exactly its cell");
    }
  }

  void check_pairs(const std::string& name, const JointLips& joint) {
    for (std::size_t side = 0; side < 2; ++side) {
      std::set<Index> on_lip, paired;
      for (const LipEdge& edge : joint.lips[side]) on_lip.insert({edge.from, edge.to});
      for (const auto& pair : joint.pairs) {
        require(on_lip.contains(pair[side]), name + ": a pair's point is not on its lip");
        require(!joint.apart || paired.insert(pair[side]).second, name + ": a point has two partners");
      }
    }
  }

  void check_joint(const JointLips& joint) {
    const std::string name = "joint " + joint.name;
    for (int side = 0; side < 2; ++side) check_lip(name, joint.lips[side], side == 0);
    check_pairs(name, joint);
    if (joint.apart) return;
    require(joint.lips[0].size() == joint.lips[1].size(), name + ": lips of different lengths");
    if (joint.lips[0].size() != joint.lips[1].size()) return;
    for (std::size_t i = 0; i < joint.lips[0].size(); ++i) {
      const LipEdge &left = joint.lips[0][i], &right = joint.lips[1][i];
      require(left.s_from == right.s_from && left.s_to == right.s_to, name + ": lips do not face");
      require(mesh_.points[left.from] == mesh_.points[right.from] &&
                  mesh_.points[left.to] == mesh_.points[right.to],
              name + ": lips lie apart");
    }
  }

  const Mesh& mesh_;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> verify(const Mesh& mesh) {
  return Checker(mesh).run();
}

}  // namespace ashlar::mesh
