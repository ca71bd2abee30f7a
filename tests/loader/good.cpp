#include "core/registry.hpp"

ASHLAR_MODULE(registry) {
  registry.add_make("law", "spring", std::function<double(double)>([](double x) { return 3 * x; }));
}
