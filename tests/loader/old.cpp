// Built for another interface: its register_module must never be called.

#include <cstdlib>

#include "core/registry.hpp"

extern "C" int ashlar_module_version() {
  return ashlar::core::module_interface_version - 1;
}
extern "C" void register_module(ashlar::core::Registry&) {
  std::abort();
}
