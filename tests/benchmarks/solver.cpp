// Cost of the direct solver by size and ordering: order, factor, one solve; then with 200 kept unknowns.
//   build/tests/benchmarks/bench_solver

#include <benchmark/benchmark.h>

#include <ctime>

#include "benchmarks/squares.hpp"
#include "suitesparse/cholesky.hpp"

namespace ashlar::benchmarks {
namespace {

using suitesparse::Cholesky;
using suitesparse::Method;

/// Processor seconds: the machine may be busy with other work.
double now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Assembled {
  explicit Assembled(const System& system) {
    const algebra::Adjacency* lists[] = {&system.groups};
    matrix.pattern = algebra::make_pattern(system.unknowns, lists);
    matrix.value.resize(matrix.pattern.entries());
    system.bulk.add_tangent(algebra::ScatterMap(matrix.pattern, system.groups), matrix.value);
    for (Index i = 0; i < system.unknowns; ++i) node.push_back(i / 2);
  }
  algebra::SymmetricMatrix matrix;
  std::vector<Index> node;
};

/// Side lengths in cells, each with both orderings: AMD (2) and METIS (1).
template <int... sides>
void cases(benchmark::internal::Benchmark* benchmark) {
  for (const int side : {sides...})
    for (const Method method : {Method::amd, Method::metis})
      benchmark->Args({side, static_cast<int>(method)});
  benchmark->Unit(benchmark::kMillisecond)->Iterations(1);
}

void run(benchmark::State& state, const Assembled& a, std::span<const Index> kept) {
  const auto method = static_cast<Method>(state.range(1));
  Cholesky solver(method);
  std::vector<double> b(a.node.size(), 1.0), x(b.size());
  double ordered = 0, factored = 0, solved = 0;
  algebra::FactorReport report;
  for (auto _ : state) {
    const double begin = now();
    solver.analyse(a.matrix.pattern, kept, a.node);
    ordered = now();
    report = solver.factor(a.matrix);
    factored = now();
    if (kept.empty()) solver.solve(b, x);
    solved = now() - factored;
    factored -= ordered;
    ordered -= begin;
  }
  if (!report.done) state.SkipWithError(report.reason.c_str());
  state.counters["unknowns"] = static_cast<double>(a.matrix.pattern.size);
  state.counters["order_s"] = ordered;
  state.counters["factor_s"] = factored;
  state.counters["solve_s"] = solved;
  state.counters["entries"] = report.entries;
  state.counters["Gflop"] = report.flops * 1e-9;
  state.SetLabel(report.ordering);
}

void on_quads(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  run(state, Assembled(System(quads(n), n + 1)), {});
}
BENCHMARK(on_quads)->Apply(cases<70, 158, 223, 387, 707>);

void on_bricks(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  run(state, Assembled(System(bricks(n), 5)), {});
}
BENCHMARK(on_bricks)->Apply(cases<50, 158, 316, 500>);

/// As a joint of 100 points down the middle.
void with_kept(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  std::vector<Index> kept;
  for (Index k = 0; k < 100; ++k) {
    const Index point = k * (n + 1) + n / 2;
    kept.push_back(2 * point);
    kept.push_back(2 * point + 1);
  }
  run(state, Assembled(System(quads(n), n + 1)), kept);
}
BENCHMARK(with_kept)->Apply(cases<158, 223>);

}  // namespace
}  // namespace ashlar::benchmarks
