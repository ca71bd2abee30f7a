#include "output/pictures/outlines.hpp"

#include <map>

namespace ashlar::output {

using geometry::Point;
using mesh::Index;

namespace {

// Joined ends make joined lines, and far fewer of them.
std::vector<std::vector<Index>> chained(const std::vector<std::array<Index, 2>>& edges) {
  std::multimap<Index, std::size_t> starts;
  for (std::size_t i = 0; i < edges.size(); ++i) starts.emplace(edges[i][0], i);
  std::vector<char> used(edges.size());
  std::vector<std::vector<Index>> chains;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (used[i]) continue;
    std::vector<Index> chain = {edges[i][0]};
    for (std::size_t edge = i; edge < edges.size();) {
      used[edge] = 1;
      chain.push_back(edges[edge][1]);
      const auto [first, last] = starts.equal_range(edges[edge][1]);
      edge = edges.size();
      for (auto next = first; next != last && edge == edges.size(); ++next)
        if (!used[next->second]) edge = next->second;
    }
    chains.push_back(std::move(chain));
  }
  return chains;
}

}  // namespace

std::vector<std::vector<Index>> outlines(const mesh::Mesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto [first, second] = mesh.edge_cells[edge];
    if (second < 0 || mesh.cell_region[first] != mesh.cell_region[second])
      edges.push_back(mesh.edge_points[edge]);
  }
  return chained(edges);
}

std::vector<std::vector<Index>> joint_lines(const mesh::Mesh& mesh) {
  std::vector<std::vector<Index>> lines;
  for (const mesh::JointLips& joint : mesh.joints) {
    std::vector<std::array<Index, 2>> edges;
    for (const mesh::LipEdge& edge : joint.lips[0]) edges.push_back({edge.from, edge.to});
    if (joint.apart)
      for (const mesh::LipEdge& edge : joint.lips[1]) edges.push_back({edge.from, edge.to});
    for (auto& chain : chained(edges)) lines.push_back(std::move(chain));
  }
  return lines;
}

std::vector<std::array<Index, 2>> inner_edges(const mesh::Mesh& mesh) {
  std::vector<std::array<Index, 2>> edges;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const auto [first, second] = mesh.edge_cells[edge];
    if (second >= 0 && mesh.cell_region[first] == mesh.cell_region[second])
      edges.push_back(mesh.edge_points[edge]);
  }
  return edges;
}

Bounds bounds_of(std::span<const Point> points) {
  Bounds bounds;
  for (const Point& p : points) bounds.add(p);
  return bounds;
}

void draw_chains(Canvas& canvas, const Frame& frame, std::span<const Point> points,
                 const std::vector<std::vector<Index>>& chains, const LineStyle& style) {
  std::vector<Point> line;
  for (const std::vector<Index>& chain : chains) {
    line.clear();
    for (const Index p : chain) line.push_back(frame.at(points[p]));
    const bool closed = chain.size() > 2 && chain.front() == chain.back();
    if (closed) line.pop_back();
    canvas.polyline(line, style, closed);
  }
}

void draw_thin_edges(Canvas& canvas, const Frame& frame, std::span<const Point> points,
                     const std::vector<std::array<Index, 2>>& edges, const LineStyle& style) {
  for (const auto& [from, to] : edges) canvas.line(frame.at(points[from]), frame.at(points[to]), style);
}

}  // namespace ashlar::output
