#include "core/schema.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <sstream>

namespace ashlar::core {

bool Range::contains(double x) const {
  const bool above = low_open ? x > low : x >= low;
  const bool below = high_open ? x < high : x <= high;
  return above && below;
}

bool Range::unbounded() const {
  return std::isinf(low) && std::isinf(high);
}

const Parameter* Schema::find(const std::string& key) const {
  for (const Parameter& parameter : parameters)
    if (parameter.key == key) return &parameter;
  return nullptr;
}

std::vector<std::string> Schema::keys() const {
  std::vector<std::string> list;
  for (const Parameter& parameter : parameters)
    if (!parameter.key.empty()) list.push_back(parameter.key);
  return list;
}

Settings::Settings() = default;
Settings::~Settings() = default;
Settings::Settings(const Settings& other) = default;
Settings::Settings(Settings&& other) noexcept = default;
Settings& Settings::operator=(const Settings& other) = default;
Settings& Settings::operator=(Settings&& other) noexcept = default;

bool Settings::has(const std::string& key) const {
  return !value(key).is_nothing();
}
bool Settings::said(const std::string& key) const {
  return entry(key).said;
}

const Settings::Entry* Settings::find(const std::string& key) const {
  for (const Entry& entry : entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

const Settings::Entry& Settings::entry(const std::string& key) const {
  if (const Entry* found = find(key)) return *found;
  assert(!"the schema has no such key");
  static const Entry missing{};
  return missing;
}

const Value& Settings::value(const std::string& key) const {
  return entry(key).value;
}

double Settings::number(const std::string& key) const {
  assert(value(key).quantity());
  return value(key).quantity()->value;
}

double Settings::number(const std::string& key, double otherwise) const {
  const Quantity* quantity = value(key).quantity();
  return quantity ? quantity->value : otherwise;
}

int Settings::integer(const std::string& key) const {
  return static_cast<int>(number(key));
}

bool Settings::flag(const std::string& key) const {
  const bool* flag = value(key).boolean();
  return flag && *flag;
}

std::string Settings::text(const std::string& key) const {
  const std::string* text = value(key).text();
  return text ? *text : std::string();
}

std::pair<double, double> Settings::point(const std::string& key) const {
  const Table* table = value(key).table();
  assert(table && table->items.size() == 2);
  return {table->items[0].quantity()->value, table->items[1].quantity()->value};
}

const Settings& Settings::object(const std::string& key) const {
  assert(entry(key).object);
  return *entry(key).object;
}

const std::vector<std::pair<std::string, Settings>>& Settings::objects(const std::string& key) const {
  return entry(key).objects;
}

bool Settings::complete(const Schema& schema) const {
  return std::all_of(schema.parameters.begin(), schema.parameters.end(), [&](const Parameter& parameter) {
    return !parameter.required || parameter.key.empty() || has(parameter.key);
  });
}

Place Settings::place_of(const std::string& key) const {
  const Entry& found = entry(key);
  return found.value.is_nothing() ? place : found.value.place;
}

namespace {

std::string number_text(const Parameter& parameter, const char* word) {
  const std::string unit = to_string(parameter.dimension);
  return unit.empty() ? word : std::string(word) + " (" + unit + ")";
}

std::string object_text(const Parameter& parameter) {
  const bool vowel = parameter.kind.find_first_of("aeiou") == 0;
  return (vowel ? "an " : "a ") + parameter.kind;
}

std::string choices_text(const Parameter& parameter) {
  std::string text;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i)
    text += (i == 0                              ? "\""
             : i + 1 == parameter.choices.size() ? " or \""
                                                 : ", \"") +
            parameter.choices[i] + "\"";
  return text;
}

std::string items_text(const Parameter& parameter, const char* word) {
  return parameter.each ? std::string(word) + " of: " + forms_text(*parameter.each) : word;
}

}  // namespace

std::string forms_text(const Parameter& parameter) {
  std::vector<std::string> words;
  auto add = [&](Form form, std::string word) {
    if (allows(parameter.forms, form)) words.push_back(std::move(word));
  };
  add(Form::boolean, "true or false");
  add(Form::number, number_text(parameter, "a number"));
  add(Form::integer, "a whole number");
  add(Form::text, parameter.choices.empty() ? "a text" : choices_text(parameter));
  const bool pair =
      parameter.each && !allows(parameter.forms, Form::list) && !allows(parameter.forms, Form::map);
  add(Form::point,
      pair ? "two of: " + forms_text(*parameter.each) : number_text(parameter, "a point {x, y}"));
  add(Form::object, object_text(parameter));
  add(Form::function, number_text(parameter, "a function"));
  add(Form::table, "a table");
  add(Form::list, items_text(parameter, "a list"));
  add(Form::map, items_text(parameter, "a table of names"));
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) text += (i == 0 ? "" : " or ") + words[i];
  return text;
}

std::string to_string(const Alternative& alternative) {
  const auto& [keys, least, most] = alternative;
  const bool all = most >= static_cast<int>(keys.size());
  std::string text = least == most ? "exactly " : all ? "at least " : "at most ";
  const int count = all ? least : most;
  text += (count == 1 ? "one" : std::to_string(count)) + " of ";
  for (std::size_t i = 0; i < keys.size(); ++i)
    text += (i == 0 ? "" : i + 1 == keys.size() ? " and " : ", ") + keys[i];
  return text;
}

std::string to_string(const Range& range, Dimension dimension) {
  std::string text;
  if (!std::isinf(range.low))
    text = (range.low_open ? "above " : "at least ") + format_quantity(range.low, dimension);
  if (std::isinf(range.high)) return text;
  if (!text.empty()) text += " and ";
  return text + (range.high_open ? "below " : "at most ") + format_quantity(range.high, dimension);
}

namespace {

std::string value_text(const Value& value, Dimension dimension) {
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  if (const Quantity* quantity = value.quantity()) return format_quantity(quantity->value, dimension);
  if (const std::string* text = value.text()) return '"' + *text + '"';
  const Table* table = value.table();
  if (!table) return value.type_name();
  std::string text = table->constructor + "{";
  for (const Value& item : table->items)
    text += (text.back() == '{' ? " " : ", ") + value_text(item, dimension);
  for (const auto& [key, item] : table->entries)
    text += (text.back() == '{' ? " " : ", ") + key + " = " + value_text(item, dimension);
  return text + (text.back() == '{' ? "}" : " }");
}

void describe_parameter(const Parameter& parameter, std::ostream& out) {
  out << "  " << (parameter.key.empty() ? "(items)" : parameter.key) << ": " << forms_text(parameter);
  if (parameter.required) out << ", required";
  if (parameter.fallback) out << ", default " << value_text(*parameter.fallback, parameter.dimension);
  if (parameter.numerical) out << ", numerical";
  out << '\n';
  if (!parameter.doc.empty()) out << "      " << parameter.doc << '\n';
  if (!parameter.range.unbounded())
    out << "      must be " << to_string(parameter.range, parameter.dimension) << '\n';
  if (!parameter.usual.unbounded())
    out << "      usually " << to_string(parameter.usual, parameter.dimension) << '\n';
}

}  // namespace

std::string describe(const Schema& schema) {
  std::ostringstream out;
  const bool plain = schema.name.empty() || schema.name == schema.kind;
  out << (plain ? schema.kind : schema.kind + "." + schema.name);
  if (!schema.constructor.empty()) out << "    in scripts: " << schema.constructor << " { … }";
  out << '\n';
  if (!schema.doc.empty()) out << schema.doc << '\n';
  if (schema.usual) out << "  taken where no " << schema.kind << " is named\n";
  for (const Parameter& parameter : schema.parameters) describe_parameter(parameter, out);
  for (const Alternative& alternative : schema.alternatives)
    out << "  say " << to_string(alternative) << '\n';
  return out.str();
}

}  // namespace ashlar::core
