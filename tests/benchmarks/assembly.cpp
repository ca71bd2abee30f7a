// Cost of the order-1 stiffness: pattern, scatter map, and values into a ready pattern, cells per second on
// one thread, beside the rate at which this machine copies the matrix.
//   build/tests/benchmarks/bench_assembly

#include <benchmark/benchmark.h>

#include <cstring>
#include <ctime>

#include "benchmarks/squares.hpp"

namespace ashlar::benchmarks {
namespace {

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(100)->Arg(316)->Arg(1000)->Unit(benchmark::kMillisecond)->MinTime(0.5);
}

void count_cells(benchmark::State& state) {
  const auto side = static_cast<double>(state.range(0));
  state.counters["cells/s"] = benchmark::Counter(side * side, benchmark::Counter::kIsIterationInvariantRate);
}

void pattern(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  const System system(quads(n), n + 1);
  const algebra::Adjacency* lists[] = {&system.groups};
  for (auto _ : state) benchmark::DoNotOptimize(algebra::make_pattern(system.unknowns, lists));
  count_cells(state);
}
BENCHMARK(pattern)->Apply(sizes);

void scatter_map(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  const System system(quads(n), n + 1);
  const algebra::Adjacency* lists[] = {&system.groups};
  const algebra::SymmetricPattern pattern = algebra::make_pattern(system.unknowns, lists);
  for (auto _ : state) benchmark::DoNotOptimize(algebra::ScatterMap(pattern, system.groups));
  count_cells(state);
}
BENCHMARK(scatter_map)->Apply(sizes);

/// Processor seconds: the machine may be busy with other work.
double now() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Seconds to copy `bytes` once, the mean of some.
double copy_seconds(std::size_t bytes) {
  const std::vector<char> from(bytes, 1);
  std::vector<char> to(bytes);
  constexpr int times = 10;
  const double begin = now();
  for (int i = 0; i < times; ++i) {
    std::memcpy(to.data(), from.data(), bytes);
    benchmark::ClobberMemory();
  }
  return (now() - begin) / times;
}

void stiffness(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  const System system(quads(n), n + 1);
  const algebra::Adjacency* lists[] = {&system.groups};
  const algebra::SymmetricPattern pattern = algebra::make_pattern(system.unknowns, lists);
  const algebra::ScatterMap map(pattern, system.groups);
  std::vector<double> value(pattern.entries());
  const double begin = now();
  for (auto _ : state) {
    system.bulk.add_tangent(map, value);
    benchmark::ClobberMemory();
  }
  const double seconds = (now() - begin) / static_cast<double>(state.iterations());
  count_cells(state);
  // A copy reads and writes its bytes; the assembly must read the map and read and write the values.
  state.counters["of_copy"] = copy_seconds((map.bytes() + 2 * value.size() * sizeof(double)) / 2) / seconds;
}
BENCHMARK(stiffness)->Apply(sizes);

void internal_force(benchmark::State& state) {
  const auto n = static_cast<Index>(state.range(0));
  const System system(quads(n), n + 1);
  std::vector<double> u(static_cast<std::size_t>(system.model.dofs.size()), 1e-3), force(u.size());
  for (auto _ : state) {
    system.bulk.add_internal_force(u, force);
    benchmark::ClobberMemory();
  }
  count_cells(state);
}
BENCHMARK(internal_force)->Apply(sizes);

}  // namespace
}  // namespace ashlar::benchmarks
