#include "core/registry.hpp"
#include "suitesparse/cholesky.hpp"
#include "suitesparse/umfpack.hpp"

namespace ashlar::suitesparse {

namespace {

Method method(const std::string& word) {
  if (word == "metis") return Method::metis;
  return word == "amd" ? Method::amd : Method::automatic;
}

}  // namespace

ASHLAR_MODULE(registry) {
  registry.add_make("solver", "suitesparse",
                    std::function<algebra::MakeSolver>([](const core::Settings& settings) {
                      return std::make_unique<Cholesky>(method(settings.text("ordering")));
                    }));
  registry.add_make(
      "unsymmetric_solver", "umfpack",
      std::function<algebra::MakeSolver>([](const core::Settings&) { return std::make_unique<Umfpack>(); }));
}

}  // namespace ashlar::suitesparse
