#include "core/registry.hpp"

extern "C" void register_module(ashlar::core::Registry&) {}
