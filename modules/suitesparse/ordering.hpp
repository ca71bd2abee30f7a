#pragma once
// Orders the unknowns to eliminate: fill-reducing on the graph of nodes, kept unknowns last.

#include <span>
#include <string>
#include <vector>

#include "algebra/sparse.hpp"
#include "suitesparse/common.hpp"

namespace ashlar::suitesparse {

using algebra::SymmetricPattern;
using mesh::Index;

enum class Method { automatic, metis, amd };

struct Ordering {
  std::vector<Index> unknown;  ///< by place in the elimination
  /// Last eliminated unknown of each connected piece of the graph without the kept unknowns.
  std::vector<Index> last_of_piece;
  std::string words;  ///< "METIS on 41200 nodes"
};

/// `kept` and `node` as in LinearSolver::analyse. Nodes' unknowns must be neighbours in number. Throws
/// std::bad_alloc if CHOLMOD lacks memory.
Ordering order(const SymmetricPattern& pattern, std::span<const Index> kept, std::span<const Index> node,
               Method method, Common& common);

}  // namespace ashlar::suitesparse
