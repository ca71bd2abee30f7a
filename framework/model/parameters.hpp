#pragma once
// Words for writing schemas in C++: parameter("E", …) | required() | refers("edge").

#include <functional>
#include <string>

#include "core/schema.hpp"

namespace ashlar::model {

using Change = std::function<void(core::Parameter&)>;

inline core::Parameter parameter(std::string key, unsigned forms, std::string doc) {
  core::Parameter made;
  made.key = std::move(key);
  made.forms = forms;
  made.doc = std::move(doc);
  return made;
}
inline core::Parameter parameter(std::string key, core::Form form, std::string doc) {
  return parameter(std::move(key), static_cast<unsigned>(form), std::move(doc));
}
inline core::Parameter operator|(core::Parameter made, const Change& change) {
  change(made);
  return made;
}

inline Change required() {
  return [](core::Parameter& p) { p.required = true; };
}
inline Change in_metres() {
  return [](core::Parameter& p) { p.dimension = {1, 0, 0}; };
}
inline Change of_kind(std::string kind) {
  return [kind = std::move(kind)](core::Parameter& p) { p.kind = kind; };
}
inline Change refers(std::string what) {
  return [what = std::move(what)](core::Parameter& p) { p.refers = what; };
}
inline Change one_of(std::vector<std::string> words) {
  return [words = std::move(words)](core::Parameter& p) { p.choices = words; };
}
inline Change otherwise(core::Value value) {
  return [value = std::move(value)](core::Parameter& p) { p.fallback = value; };
}
inline Change within(core::Range range) {
  return [range](core::Parameter& p) { p.range = range; };
}
inline Change each(core::Parameter item) {
  return [item = std::make_shared<const core::Parameter>(std::move(item))](core::Parameter& p) {
    p.each = item;
  };
}

}  // namespace ashlar::model
