#include "core/check_advice.hpp"

#include <algorithm>

#include "core/hints.hpp"

namespace ashlar::core {

namespace {

std::vector<std::string> constructors(const std::string& kind, const Registry& registry) {
  std::vector<std::string> list;
  for (const std::string& name : registry.names(kind)) {
    const std::string& word = registry.find(kind, name)->schema.constructor;
    if (!word.empty()) list.push_back(word);
  }
  return list;
}

// How a script may say an entry of the kind: `valid: material.elastic { … }` or `valid: "none"`.
std::string ways_to_say(const std::string& kind, const Registry& registry) {
  std::string text;
  for (const std::string& name : registry.names(kind)) {
    const std::string& word = registry.find(kind, name)->schema.constructor;
    text += (text.empty() ? "valid: " : ", ") + (word.empty() ? '"' + name + '"' : word + " { … }");
  }
  return text;
}

bool contains(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// One item where a list of such items is asked for.
std::string brace_advice(const Value& value, const Parameter& item, const Registry& registry) {
  const std::string* text = value.text();
  if (text && allows(item.forms, Form::text) && (item.choices.empty() || contains(item.choices, *text)))
    return "put it into braces: { \"" + *text + "\" }";
  if (text && !item.choices.empty()) return did_you_mean(*text, item.choices);
  const Schema* schema = value.table() ? registry.find_constructor(value.table()->constructor) : nullptr;
  if (schema && allows(item.forms, Form::object) && schema->kind == item.kind)
    return "put it into braces: { " + schema->constructor + " { … } }";
  return {};
}

}  // namespace

Parameter item_of(const Parameter& parameter) {
  Parameter item;
  if (parameter.each)
    item = *parameter.each;
  else
    item.forms = static_cast<unsigned>(Form::object);
  if (item.kind.empty()) item.kind = parameter.kind;
  return item;
}

std::string form_advice(const Value& value, const Parameter& parameter, const Registry& registry) {
  const std::string product = value.text() ? product_in_script(*value.text(), "units.") : "";
  const bool numbers = allows(parameter.forms, Form::number) || allows(parameter.forms, Form::point);
  if (numbers && !product.empty()) return "units are multiplied: " + product;
  if (allows(parameter.forms, Form::list)) {
    std::string advice = brace_advice(value, item_of(parameter), registry);
    if (!advice.empty()) return advice;
  }
  if (allows(parameter.forms, Form::object)) return ways_to_say(parameter.kind, registry);
  return item_advice(parameter, registry);
}

std::string item_advice(const Parameter& parameter, const Registry& registry) {
  const Parameter item = item_of(parameter);
  if (!allows(item.forms, Form::object) || registry.names(item.kind) != std::vector{item.kind}) return {};
  const std::string& word = registry.find(item.kind, item.kind)->schema.constructor;
  const std::string one = word.empty() ? "{ … }" : word + " { … }";
  return "each item is " + one + ": { " + one + ", " + one + " }";
}

std::string entry_advice(const Value& value, const std::string& word, const std::string& kind,
                         const Registry& registry) {
  if (value.table()) return did_you_mean(word, constructors(kind, registry));
  const std::vector<std::string> names = registry.names(kind);
  std::string advice = did_you_mean(word, names);
  // "rock" in quotes was meant as the script's own rock.
  const bool own = nearest(word, names).empty() && !constructors(kind, registry).empty();
  return own ? advice + "; names that the script made itself stand without quotes" : advice;
}

}  // namespace ashlar::core
