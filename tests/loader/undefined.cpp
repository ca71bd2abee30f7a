// Needs a function that nobody provides.

#include "core/registry.hpp"

void nobody_provides_this();

ASHLAR_MODULE(registry) {
  nobody_provides_this();
  registry.names("law");
}
