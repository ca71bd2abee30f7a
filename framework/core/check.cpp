// Checking a table against a schema: see schema.hpp.

#include <algorithm>
#include <cmath>
#include <map>

#include "core/check_advice.hpp"
#include "core/hints.hpp"
#include "core/log.hpp"
#include "core/registry.hpp"
#include "core/schema.hpp"

namespace ashlar::core {

namespace {

constexpr int deepest = 64;  // objects in objects; a default that contains itself ends here

std::string example(Dimension dimension) {
  if (dimension == Dimension{}) return "0.3, a pure number";
  const std::string si = to_string(dimension);
  return (si.starts_with("1/") ? "" : "2*") + unit_in_script(si, "units.");
}

std::string dimension_text(Dimension dimension) {
  return dimension == Dimension{} ? "a pure number" : "in " + to_string(dimension);
}

bool fits(const Quantity& quantity, Dimension dimension) {
  return quantity.bare || quantity.dimension == dimension;
}

void add_wrong_dimension(const Value& value, Dimension dimension, Mistakes& mistakes) {
  const Quantity& quantity = *value.quantity();
  mistakes.add(
      value.place,
      "must be " + dimension_text(dimension) + ", got " + format_quantity(quantity.value, quantity.dimension),
      "for example " + example(dimension));
}

std::string got(const Value& value) {
  if (const std::string* text = value.text()) return "the text \"" + text->substr(0, 60) + "\"";
  if (const Quantity* q = value.quantity()) return format_quantity(q->value, q->dimension);
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  return value.type_name();
}

Place below(const Place& place, const std::string& key) {
  return {place.file, place.line, place.path.empty() ? key : place.path + "." + key};
}

class Checker {
 public:
  Checker(const Registry& registry, Mistakes& mistakes) : registry_(registry), mistakes_(mistakes) {}

  Settings check_object(const Value& value, const Schema& schema);

 private:
  struct Checked {
    Value value;
    std::shared_ptr<const Settings> object;
    std::vector<std::pair<std::string, Settings>> objects;
  };

  bool any_unknown(const Table& table, const Schema& schema, const Place& place);
  void check_alternative(const Table* table, const Alternative& alternative, const Schema& schema,
                         const Place& place);
  void check_entry(const Table* table, const Parameter& parameter, Settings& settings);
  void check_items(const Table* table, const Parameter& parameter, Settings& settings);
  Checked check_value(const Value& value, const Parameter& parameter);
  Checked check_form(const Value& value, const Parameter& parameter);
  Checked check_number(const Value& value, const Parameter& parameter);
  Checked check_text(const Value& value, const Parameter& parameter);
  Checked check_table(const Value& value, const Parameter& parameter);
  Checked check_tagged(const Value& value, const Parameter& parameter);
  Checked check_all(const Value& value, const Parameter& parameter);
  Checked make_object(const Value& value, const Schema& schema);
  Checked wrong_form(const Value& value, const Parameter& parameter);
  Checked no_such_entry(const Value& value, const std::string& word, const Parameter& parameter);

  const Registry& registry_;
  Mistakes& mistakes_;
  int depth_ = 0;
};

// A bare word stands for the entry with all its defaults.
Settings Checker::check_object(const Value& value, const Schema& schema) {
  Settings settings;
  settings.kind = schema.kind;
  settings.name = schema.name;
  settings.place = value.place;
  if (++depth_ > deepest) {
    mistakes_.add(value.place, "tables are nested deeper than " + std::to_string(deepest));
    --depth_;
    return settings;
  }
  const Table* table = value.table();
  if (!table && !value.text())
    mistakes_.add(value.place, "must be a table for " + schema.kind + ", got " + got(value));
  const bool unknown = table && any_unknown(*table, schema, value.place);
  for (const Parameter& parameter : schema.parameters)
    if (parameter.key.empty())
      check_items(table, parameter, settings);
    else
      check_entry(table, parameter, settings);
  for (const Alternative& alternative : schema.alternatives)
    if (!unknown) check_alternative(table, alternative, schema, value.place);
  --depth_;
  return settings;
}

bool Checker::any_unknown(const Table& table, const Schema& schema, const Place& place) {
  const std::vector<std::string> keys = schema.keys();
  const std::size_t before = mistakes_.list().size();
  for (const auto& [key, value] : table.entries)
    if (key.empty() || !schema.find(key))
      mistakes_.add(value.place, "unknown key '" + key + "'", did_you_mean(key, keys));
  if (!table.items.empty() && !schema.find(""))
    mistakes_.add(table.items.front().place.line > 0 ? table.items.front().place : place,
                  "an item without a key: " + got(table.items.front()), did_you_mean("", keys));
  return mistakes_.list().size() > before;
}

void Checker::check_alternative(const Table* table, const Alternative& alternative, const Schema& schema,
                                const Place& place) {
  std::vector<const Value*> said;
  std::string words;
  for (const std::string& key : alternative.keys)
    if (const Value* value = table ? table->find(key) : nullptr) {
      words += (said.empty() ? "" : " and ") + key;
      said.push_back(value);
    }
  const int count = static_cast<int>(said.size());
  if (count >= alternative.least && count <= alternative.most) return;
  if (count > alternative.most) {
    const auto last =
        std::ranges::max_element(said, {}, [](const Value* value) { return value->place.line; });
    mistakes_.add((*last)->place, words + (count == 2 ? " are both said" : " are all said"),
                  "say " + to_string(alternative));
    return;
  }
  mistakes_.add(
      place,
      "needs " + to_string(alternative) + (said.empty() ? ", got none of them" : ", got " + words + " only"),
      "`ashlar describe " + (schema.constructor.empty() ? schema.kind : schema.constructor) +
          "` tells what each means");
}

void Checker::check_entry(const Table* table, const Parameter& parameter, Settings& settings) {
  Settings::Entry entry;
  entry.key = parameter.key;
  entry.dimension = parameter.dimension;
  const Value* said = table ? table->find(parameter.key) : nullptr;
  Checked checked;
  if (said) {
    entry.said = true;
    checked = check_value(*said, parameter);
  } else if (parameter.fallback) {
    Value fallback = *parameter.fallback;
    fallback.place = below(settings.place, parameter.key);
    checked = check_value(fallback, parameter);
    if (parameter.numerical) log().debug(to_string(fallback.place) + ": the default is used");
  } else if (parameter.required) {
    mistakes_.add(
        below(settings.place, parameter.key),
        "is missing: " + forms_text(parameter) + (parameter.doc.empty() ? "" : ", " + parameter.doc));
  }
  entry.value = std::move(checked.value);
  entry.object = std::move(checked.object);
  entry.objects = std::move(checked.objects);
  settings.entries.push_back(std::move(entry));
}

void Checker::check_items(const Table* table, const Parameter& parameter, Settings& settings) {
  Settings::Entry entry;
  entry.dimension = parameter.dimension;
  entry.said = table && !table->items.empty();
  if (entry.said) {
    for (std::size_t i = 0; i < table->items.size(); ++i) {
      Checked checked = check_value(table->items[i], parameter);
      if (checked.object) entry.objects.emplace_back(std::to_string(i + 1), *checked.object);
      settings.items.push_back(std::move(checked.value));
    }
    entry.value = make_value(Table{{}, settings.items, {}}, settings.place);
  } else if (parameter.required) {
    mistakes_.add(settings.place, "needs " + forms_text(parameter) + " without a key" +
                                      (parameter.doc.empty() ? "" : ", " + parameter.doc));
  }
  settings.entries.push_back(std::move(entry));
}

// A value that is wrong keeps its place: its key may be wrong too, and is looked at later.
Checker::Checked Checker::check_value(const Value& value, const Parameter& parameter) {
  Checked checked = check_form(value, parameter);
  checked.value.place = value.place;
  return checked;
}

Checker::Checked Checker::check_form(const Value& value, const Parameter& parameter) {
  if (value.quantity()) return check_number(value, parameter);
  if (value.text()) return check_text(value, parameter);
  if (value.table()) return check_table(value, parameter);
  if (value.boolean() && allows(parameter.forms, Form::boolean)) return {value, {}, {}};
  if (value.function() && allows(parameter.forms, Form::function)) return {value, {}, {}};
  return value.is_nothing() ? Checked{} : wrong_form(value, parameter);
}

Checker::Checked Checker::check_number(const Value& value, const Parameter& parameter) {
  const bool number = allows(parameter.forms, Form::number);
  if (!number && !allows(parameter.forms, Form::integer)) return wrong_form(value, parameter);
  const Quantity& quantity = *value.quantity();
  if (!fits(quantity, parameter.dimension)) {
    add_wrong_dimension(value, parameter.dimension, mistakes_);
    return {};
  }
  const double x = quantity.value;
  const std::string shown = format_quantity(x, parameter.dimension);
  if (!std::isfinite(x)) {
    mistakes_.add(value.place, "must be a finite number, got " + shown);
    return {};
  }
  if (!number && (x != std::floor(x) || std::abs(x) > 2147483647.0)) {
    mistakes_.add(value.place, "must be a whole number within ±2147483647, got " + shown);
    return {};
  }
  if (!parameter.range.contains(x)) {
    mistakes_.add(value.place,
                  "must be " + to_string(parameter.range, parameter.dimension) + ", got " + shown);
    return {};
  }
  // Nobody forgets the unit of zero.
  if (x != 0 && !parameter.usual.contains(x))
    log().warning(to_string(value.place) + ": " + shown + " is unusual (usually " +
                  to_string(parameter.usual, parameter.dimension) + "); is the unit right?");
  return {value, {}, {}};
}

Checker::Checked Checker::check_text(const Value& value, const Parameter& parameter) {
  const std::string& word = *value.text();
  if (allows(parameter.forms, Form::object))
    if (const Registry::Entry* entry = registry_.find(parameter.kind, word))
      return make_object(value, entry->schema);
  if (allows(parameter.forms, Form::text)) {
    bool chosen = parameter.choices.empty();
    for (const std::string& choice : parameter.choices) chosen = chosen || choice == word;
    if (chosen) return {value, {}, {}};
    mistakes_.add(value.place, "'" + word + "' is none of the choices",
                  did_you_mean(word, parameter.choices));
    return {};
  }
  // Kinds such as "stage" have one entry, and no words to choose from.
  const bool choice = registry_.names(parameter.kind) != std::vector{parameter.kind};
  if (allows(parameter.forms, Form::object) && choice) return no_such_entry(value, word, parameter);
  return wrong_form(value, parameter);
}

Checker::Checked Checker::check_table(const Value& value, const Parameter& parameter) {
  const Table& table = *value.table();
  if (!table.constructor.empty()) return check_tagged(value, parameter);
  bool numbers = table.items.size() == 2 && table.entries.empty();
  for (const Value& item : table.items) numbers = numbers && item.quantity();
  const bool lists = allows(parameter.forms, Form::list), maps = allows(parameter.forms, Form::map);
  if (allows(parameter.forms, Form::point) && (numbers || !(lists || maps))) {
    if (parameter.each && !lists && !maps)
      return numbers ? check_all(value, parameter) : wrong_form(value, parameter);
    const bool point = read_point(value, parameter.dimension, mistakes_).has_value();
    return point ? Checked{value, {}, {}} : Checked{};
  }
  if (lists && table.entries.empty()) return check_all(value, parameter);
  if (maps && table.items.empty()) return check_all(value, parameter);
  if (allows(parameter.forms, Form::table)) return {value, {}, {}};
  // Where a kind has one entry only, its constructor may be left out.
  const std::vector<std::string> names = registry_.names(parameter.kind);
  const bool keyed = table.items.empty() || !lists;
  if (allows(parameter.forms, Form::object) && keyed && !maps && names.size() == 1)
    return make_object(value, registry_.find(parameter.kind, names.front())->schema);
  if (lists && !maps) {
    mistakes_.add(table.entries.front().second.place,
                  "a list takes no keys, got '" + table.entries.front().first + "'",
                  item_advice(parameter, registry_));
    return {};
  }
  if (maps && !lists) {
    mistakes_.add(table.items.front().place,
                  "every entry needs a name: name = …, got " + got(table.items.front()));
    return {};
  }
  return wrong_form(value, parameter);
}

Checker::Checked Checker::check_tagged(const Value& value, const Parameter& parameter) {
  const std::string& word = value.table()->constructor;
  const Schema* schema = registry_.find_constructor(word);
  const bool objects = allows(parameter.forms, Form::object);
  if (objects && schema && schema->kind == parameter.kind) return make_object(value, *schema);
  if (allows(parameter.forms, Form::table)) return {value, {}, {}};
  if (objects && !schema) return no_such_entry(value, word, parameter);
  return wrong_form(value, parameter);
}

Checker::Checked Checker::check_all(const Value& value, const Parameter& parameter) {
  if (!parameter.each && parameter.kind.empty()) return {value, {}, {}};
  const Parameter each = item_of(parameter);
  Checked result;
  Table table = *value.table();
  auto check_one = [&](const std::string& name, Value& item) {
    Checked checked = check_value(item, each);
    if (checked.object) result.objects.emplace_back(name, *checked.object);
    item = std::move(checked.value);
  };
  for (std::size_t i = 0; i < table.items.size(); ++i) check_one(std::to_string(i + 1), table.items[i]);
  for (auto& [name, item] : table.entries) check_one(name, item);
  result.value = make_value(std::move(table), value.place);
  return result;
}

Checker::Checked Checker::make_object(const Value& value, const Schema& schema) {
  return {value, std::make_shared<const Settings>(check_object(value, schema)), {}};
}

Checker::Checked Checker::wrong_form(const Value& value, const Parameter& parameter) {
  mistakes_.add(value.place, "must be " + forms_text(parameter) + ", got " + got(value),
                form_advice(value, parameter, registry_));
  return {};
}

Checker::Checked Checker::no_such_entry(const Value& value, const std::string& word,
                                        const Parameter& parameter) {
  if (registry_.names(parameter.kind).empty())
    mistakes_.add(value.place,
                  "no module provides the kind '" + parameter.kind + "', asked for by '" + word + "'",
                  "is the module missing from the modules folder?");
  else
    mistakes_.add(value.place, "there is no " + parameter.kind + " '" + word + "'",
                  entry_advice(value, word, parameter.kind, registry_));
  return {};
}

}  // namespace

Settings check(const Value& value, const Schema& schema, const Registry& registry, Mistakes& mistakes) {
  const Table* table = value.table();
  if (table && !table->constructor.empty() && table->constructor != schema.constructor) {
    mistakes.add(value.place, "must be " + schema.constructor + " { … }, got " + value.type_name());
    Settings settings;
    settings.kind = schema.kind;
    settings.name = schema.name;
    settings.place = value.place;
    for (const Parameter& parameter : schema.parameters) {
      Settings::Entry& entry = settings.entries.emplace_back();
      entry.key = parameter.key;
      entry.dimension = parameter.dimension;
    }
    return settings;
  }
  return Checker(registry, mistakes).check_object(value, schema);
}

std::optional<double> read_number(const Value& value, Dimension dimension, Mistakes& mistakes) {
  if (value.is_nothing()) return {};  // reported where it became nothing
  const Quantity* quantity = value.quantity();
  if (!quantity) {
    mistakes.add(value.place, "must be a number, got " + got(value));
    return {};
  }
  if (!fits(*quantity, dimension)) {
    add_wrong_dimension(value, dimension, mistakes);
    return {};
  }
  if (!std::isfinite(quantity->value)) {
    mistakes.add(value.place, "must be a finite number, got " + format_quantity(quantity->value, dimension));
    return {};
  }
  return quantity->value;
}

std::optional<std::pair<double, double>> read_point(const Value& value, Dimension dimension,
                                                    Mistakes& mistakes) {
  const Table* table = value.table();
  if (!table || table->items.size() != 2 || !table->entries.empty()) {
    mistakes.add(value.place,
                 "must be a point {x, y}, got " + (table ? "a table of other shape" : got(value)));
    return {};
  }
  const auto x = read_number(table->items[0], dimension, mistakes);
  const auto y = read_number(table->items[1], dimension, mistakes);
  if (!x || !y) return {};
  return std::pair{*x, *y};
}

}  // namespace ashlar::core
