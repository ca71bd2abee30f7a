// Stiffness and scatter of every element into a ready pattern, on one core: the least time per cell of some
// runs, cells per second, growth from 10⁴ cells to more, and the share of this machine's memory bandwidth
// that the traffic which cannot be saved takes up.
//   build/tests/benchmarks/bench_elements

#include <benchmark/benchmark.h>

#include <ctime>

#include "benchmarks/squares.hpp"
#include "core/parallel.hpp"
#include "elasticity/fem.hpp"
#include "elasticity/vem_high.hpp"
#include "mesh/edge_table.hpp"

namespace ashlar::benchmarks {
namespace {

using Make = std::shared_ptr<const model::Element>();

template <int order>
std::shared_ptr<const model::Element> vem() {
  const auto stabilisation = std::make_shared<elasticity::BendingStabilisation>();
  if constexpr (order == 1) return std::make_shared<elasticity::VemElement>(stabilisation);
  return std::make_shared<elasticity::VemHigh>(order, stabilisation);
}

template <int order, bool incompatible = false>
std::shared_ptr<const model::Element> fem() {
  return std::make_shared<elasticity::FiniteElement>(order, incompatible);
}

/// The squares of `quads`, each cut in two.
model::Model triangles(Index n) {
  model::Model model = quads(n);
  algebra::Adjacency halves;
  for (Index cell = 0; cell < model.mesh.cell_count(); ++cell) {
    const auto p = model.mesh.cell_points[cell];
    halves.append(std::array{p[0], p[1], p[2]});
    halves.append(std::array{p[0], p[2], p[3]});
  }
  model.mesh.cell_points = std::move(halves);
  complete(model);
  return model;
}

/// n × n hexagons, numbered row by row: bricks whose horizontal sides are bent.
model::Model hexagons(Index n) {
  model::Model model;
  const Index width = 2 * n + 2;
  for (Index y = 0; y <= n; ++y)
    for (Index x = 0; x < width; ++x)
      model.mesh.points.push_back({0.5 * x / n, (y + ((x + y) % 2 == 0 ? 0.1 : -0.1)) / n});
  for (Index y = 0; y < n; ++y)
    for (Index x = 0; x < n; ++x) {
      const Index a = y * width + 2 * x + y % 2, b = a + width;
      model.mesh.cell_points.append(std::array{a, a + 1, a + 2, b + 2, b + 1, b});
    }
  complete(model);
  return model;
}

model::Model with_element(model::Model model, std::shared_ptr<const model::Element> element) {
  model.element = std::move(element);
  const model::NodeCounts nodes = model.element->nodes();
  mesh::Mesh& mesh = model.mesh;
  if (nodes.per_edge > 0) {
    mesh::EdgeTable edges(mesh.cell_points, mesh.points);
    const auto offsets = mesh.cell_points.offsets();
    mesh.cell_edges = {{offsets.begin(), offsets.end()}, std::move(edges.cell_edges)};
    mesh.edge_points = std::move(edges.points);
    mesh.edge_cells = std::move(edges.cells);
  }
  model.dofs =
      fields::DofMap(mesh, {"displacement", "m", 2, nodes.per_point, nodes.per_edge, nodes.per_cell});
  return model;
}

/// Processor seconds: the machine may be busy with other work.
double now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Bytes per second of a = b + s c far outside the caches, the best of some.
double triad() {
  constexpr std::size_t size = 1 << 24;
  std::vector<double> a(size, 0.0), b(size, 1.0), c(size, 2.0);
  double least = 1e9;
  for (int times = 0; times < 10; ++times) {
    const double begin = now();
    for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 3 * c[i];
    benchmark::ClobberMemory();
    least = std::min(least, now() - begin);
  }
  return 3.0 * size * sizeof(double) / least;
}

double bandwidth() {
  static const double measured = triad();
  return measured;
}

/// What must be moved at least: the map, the corners and their points read, the values read and written.
double traffic(const mesh::Mesh& mesh, const algebra::ScatterMap& map, std::size_t values) {
  return static_cast<double>(map.bytes() + mesh.cell_points.values().size() * sizeof(Index) +
                             mesh.points.size() * sizeof(geometry::Point) + 2 * values * sizeof(double));
}

/// The benchmark's argument n: n × n squares, halves of them or hexagons.
template <model::Model (*cells)(Index), Make* make>
void stiffness(benchmark::State& state) {
  core::set_thread_count(1);
  const auto n = static_cast<Index>(state.range(0));
  const System system(with_element(cells(n), make()), n + 1);
  const algebra::Adjacency* lists[] = {&system.groups};
  const algebra::SymmetricPattern pattern = algebra::make_pattern(system.unknowns, lists);
  const algebra::ScatterMap map(pattern, system.groups);
  std::vector<double> value(pattern.entries());
  double seconds = 1e9;
  for (auto _ : state) {
    const double begin = now();
    system.bulk.add_tangent(map, value);
    benchmark::ClobberMemory();
    seconds = std::min(seconds, now() - begin);
  }
  const double count = system.model.mesh.cell_count();
  static double first = seconds / count;  // for the fewest of these cells with this element
  const double bytes = traffic(system.model.mesh, map, value.size());
  state.counters["cells"] = count;
  state.counters["ns/cell"] = 1e9 * seconds / count;
  state.counters["cells/s"] = count / seconds;
  state.counters["growth"] = seconds / count / first;
  state.counters["bytes/cell"] = bytes / count;
  state.counters["of_triad"] = bytes / seconds / bandwidth();
}

/// 10⁴ cells, and 10⁶ or, where these would fill the memory, 10⁵.
template <int side, int much>
void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(side)->Arg(much)->Unit(benchmark::kMillisecond)->Iterations(5);
}

BENCHMARK(stiffness<quads, vem<1>>)->Name("vem_1_quads")->Apply(sizes<100, 1000>);
BENCHMARK(stiffness<hexagons, vem<1>>)->Name("vem_1_hexagons")->Apply(sizes<100, 1000>);
BENCHMARK(stiffness<quads, vem<2>>)->Name("vem_2_quads")->Apply(sizes<100, 1000>);
BENCHMARK(stiffness<hexagons, vem<2>>)->Name("vem_2_hexagons")->Apply(sizes<100, 316>);
BENCHMARK(stiffness<quads, vem<3>>)->Name("vem_3_quads")->Apply(sizes<100, 316>);
BENCHMARK(stiffness<hexagons, vem<3>>)->Name("vem_3_hexagons")->Apply(sizes<100, 316>);
BENCHMARK(stiffness<triangles, fem<1>>)->Name("fem_t3")->Apply(sizes<71, 707>);
BENCHMARK(stiffness<triangles, fem<2>>)->Name("fem_t6")->Apply(sizes<71, 707>);
BENCHMARK(stiffness<quads, fem<1>>)->Name("fem_q4")->Apply(sizes<100, 1000>);
BENCHMARK(stiffness<quads, fem<1, true>>)->Name("fem_q4_incompatible")->Apply(sizes<100, 1000>);
BENCHMARK(stiffness<quads, fem<2>>)->Name("fem_q8")->Apply(sizes<100, 1000>);

}  // namespace
}  // namespace ashlar::benchmarks
