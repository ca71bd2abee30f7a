#include "mesh/verify.hpp"

#include <algorithm>

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

  void check_joint(const JointLips& joint) {
    const std::string name = "joint " + joint.name;
    require(joint.lips[0].size() == joint.lips[1].size(), name + ": lips of different lengths");
    if (joint.lips[0].size() != joint.lips[1].size()) return;
    for (std::size_t i = 0; i < joint.lips[0].size(); ++i) {
      const LipEdge &left = joint.lips[0][i], &right = joint.lips[1][i];
      require(left.s_from < left.s_to && left.s_from == right.s_from && left.s_to == right.s_to,
              name + ": lips do not face");
      require(i == 0 || left.s_from >= joint.lips[0][i - 1].s_from, name + ": not ordered");
      require(mesh_.points[left.from] == mesh_.points[right.from] &&
                  mesh_.points[left.to] == mesh_.points[right.to],
              name + ": lips lie apart");
      const std::array<Index, 2> along{left.from, left.to}, against{right.to, right.from};
      require(mesh_.edge_points[left.edge] == along, name + ": the first lip is not on the left");
      require(mesh_.edge_points[right.edge] == against, name + ": the second lip is not on the right");
      for (const LipEdge* lip : {&left, &right}) {
        const std::array<Index, 2> one{lip->cell, -1};
        require(mesh_.edge_cells[lip->edge] == one, name + ": a lip's edge has not exactly its cell");
      }
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
