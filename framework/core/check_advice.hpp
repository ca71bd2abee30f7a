#pragma once
// What check() advises where a value does not fit its parameter.

#include <string>

#include "core/registry.hpp"

namespace ashlar::core {

/// What every item of a list or map must be.
Parameter item_of(const Parameter& parameter);

/// For a value of a wrong form: the slips that are made most often, else what would be valid.
std::string form_advice(const Value& value, const Parameter& parameter, const Registry& registry);

/// "each item is Stage { … }"; empty where items are no objects, or of several kinds.
std::string item_advice(const Parameter& parameter, const Registry& registry);

/// For a word, or the constructor of a table, that names no entry of a kind.
std::string entry_advice(const Value& value, const std::string& word, const std::string& kind,
                         const Registry& registry);

}  // namespace ashlar::core
