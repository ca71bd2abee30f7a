#include "suitesparse/ordering.hpp"

#include <algorithm>
#include <new>
#include <numeric>

namespace ashlar::suitesparse {

namespace {

/// Up to here AMD orders and factors in less time together; above, METIS' smaller factor pays on Voronoi
/// meshes (tests/benchmarks/solver.cpp; figures in README.md).
constexpr Index amd_is_better_up_to = 100000;

/// Nodes of the unknowns that are not kept, numbered through, and which of them couple (lower triangle by
/// columns, without diagonal).
struct NodeGraph {
  std::vector<Index> first;  ///< by node: its first unknown in `unknown`; size + 1 entries
  std::vector<Index> unknown;
  std::vector<Index> column_start, row;
  Index size() const { return static_cast<Index>(first.size()) - 1; }
};

NodeGraph make_graph(const SymmetricPattern& pattern, std::span<const Index> kept,
                     std::span<const Index> node) {
  NodeGraph graph;
  std::vector<Index> number(static_cast<std::size_t>(pattern.size), -1);
  auto next_kept = kept.begin();
  Index last_node = -1;
  for (Index i = 0; i < pattern.size; ++i) {
    if (next_kept != kept.end() && *next_kept == i) {
      ++next_kept;
      continue;
    }
    if (graph.first.empty() || node[i] != last_node)
      graph.first.push_back(static_cast<Index>(graph.unknown.size()));
    last_node = node[i];
    number[i] = static_cast<Index>(graph.first.size()) - 1;
    graph.unknown.push_back(i);
  }
  graph.first.push_back(static_cast<Index>(graph.unknown.size()));

  std::vector<Index> seen_by(static_cast<std::size_t>(graph.size()), -1);
  graph.column_start.push_back(0);
  for (Index column = 0; column < graph.size(); ++column) {
    seen_by[column] = column;
    for (Index u = graph.first[column]; u < graph.first[column + 1]; ++u) {
      const Index j = graph.unknown[u];
      for (Index p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
        const Index other = number[pattern.row[p]];
        if (other < 0 || seen_by[other] == column) continue;
        seen_by[other] = column;
        graph.row.push_back(other);
      }
    }
    graph.column_start.push_back(static_cast<Index>(graph.row.size()));
  }
  return graph;
}

cholmod_sparse view(NodeGraph& graph) {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(graph.size());
  matrix.nzmax = graph.row.size();
  matrix.p = graph.column_start.data();
  matrix.i = graph.row.data();
  matrix.stype = -1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = CHOLMOD_PATTERN;
  matrix.packed = 1;
  return matrix;
}

std::vector<Index> order_nodes(NodeGraph& graph, bool metis, Common& common) {
  std::vector<Index> order(static_cast<std::size_t>(graph.size()));
  if (order.size() < 2) return order;
  cholmod_sparse matrix = view(graph);
  const int done = metis ? cholmod_metis(&matrix, nullptr, 0, 1, order.data(), common)
                         : cholmod_amd(&matrix, nullptr, 0, order.data(), common);
  if (!done) throw std::bad_alloc();
  return order;
}

/// The last node in `order` of every connected piece of the graph.
std::vector<Index> last_nodes(const NodeGraph& graph, std::span<const Index> order) {
  std::vector<Index> parent(static_cast<std::size_t>(graph.size()));
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (Index column = 0; column < graph.size(); ++column)
    for (Index p = graph.column_start[column]; p < graph.column_start[column + 1]; ++p) {
      const Index a = root(column), b = root(graph.row[p]);
      parent[std::max(a, b)] = std::min(a, b);
    }
  std::vector<Index> last;
  std::vector<char> found(parent.size());
  for (std::size_t k = order.size(); k-- > 0;)
    if (char& known = found[root(order[k])]; !known) {
      known = 1;
      last.push_back(order[k]);
    }
  return last;
}

}  // namespace

Ordering order(const SymmetricPattern& pattern, std::span<const Index> kept, std::span<const Index> node,
               Method method, Common& common) {
  NodeGraph graph = make_graph(pattern, kept, node);
  const bool metis =
      method == Method::metis || (method == Method::automatic && graph.size() > amd_is_better_up_to);
  const std::vector<Index> nodes = order_nodes(graph, metis, common);
  Ordering result;
  result.words = std::string(metis ? "METIS" : "AMD") + " on " + std::to_string(graph.size()) + " nodes";
  result.unknown.reserve(static_cast<std::size_t>(pattern.size));
  for (const Index n : nodes)
    for (Index u = graph.first[n]; u < graph.first[n + 1]; ++u) result.unknown.push_back(graph.unknown[u]);
  result.unknown.insert(result.unknown.end(), kept.begin(), kept.end());
  for (const Index n : last_nodes(graph, nodes))
    result.last_of_piece.push_back(graph.unknown[graph.first[n + 1] - 1]);
  return result;
}

}  // namespace ashlar::suitesparse
