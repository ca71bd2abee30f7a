#include "core/value.hpp"

namespace ashlar::core {

double Function::number(std::span<const double> arguments, Dimension) const {
  const std::vector<double> results = call(arguments);
  if (results.size() == 1) return results.front();
  throw InputError(
      Mistake{{}, "the function must return one number, but returns " + std::to_string(results.size()), {}});
}

void Function::call_tables(std::span<const NumberTable>, std::span<NumberTable>) const {
  throw InputError(Mistake{{}, "the function takes no tables", {}});
}

const Table* Value::table() const {
  const auto* held = std::get_if<std::shared_ptr<const Table>>(&data);
  return held ? held->get() : nullptr;
}

std::shared_ptr<const Function> Value::function() const {
  const auto* held = std::get_if<std::shared_ptr<const Function>>(&data);
  return held ? *held : nullptr;
}

std::string Value::type_name() const {
  if (is_nothing()) return "nothing";
  if (boolean()) return "a boolean";
  if (quantity()) return "a number";
  if (text()) return "a text";
  if (function()) return "a function";
  return table()->constructor.empty() ? "a table" : table()->constructor + " { … }";
}

const Value* Table::find(const std::string& key) const {
  for (const auto& [name, value] : entries)
    if (name == key) return &value;
  return nullptr;
}

Value make_value(double number, Place place) {
  return {std::move(place), Quantity{number, {}, true}};
}
Value make_value(std::string text, Place place) {
  return {std::move(place), std::move(text)};
}
Value make_value(bool flag, Place place) {
  return {std::move(place), flag};
}
Value make_value(Table table, Place place) {
  return {std::move(place), std::make_shared<const Table>(std::move(table))};
}

}  // namespace ashlar::core
