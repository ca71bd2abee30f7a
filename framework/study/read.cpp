// The script's table → Study, with every mistake that shows without the scene.

#include <algorithm>
#include <cmath>

#include "output/files.hpp"
#include "study/cases.hpp"
#include "study/study.hpp"

namespace ashlar::study {

namespace {

using core::Mistakes;
using core::Settings;
using core::Value;

constexpr std::size_t most_cases = 10'000;

bool is_setting(const Value& value, Mistakes& mistakes) {
  if (value.is_nothing()) return false;
  if (value.boolean() || value.text()) return true;
  if (const core::Quantity* q = value.quantity()) {
    if (std::isfinite(q->value)) return true;
    mistakes.add(value.place, "must be a finite number");
    return false;
  }
  mistakes.add(value.place, "must be a number, a text or a boolean, got " + value.type_name(),
               "settings that are none are reached through a `param` of the scene");
  return false;
}

std::vector<Value> read_list(const Value& list, Mistakes& mistakes) {
  const core::Table* table = list.table();
  std::vector<Value> values;
  if (!table) return values;
  if (!table->entries.empty() || !table->constructor.empty())
    mistakes.add(list.place, "must be a list of values", "for example { 500, 1000, 2000 }");
  else if (table->items.empty())
    mistakes.add(list.place, "is empty: there is nothing to run",
                 "give it values, for example { 500, 1000, 2000 }, or leave it out");
  for (const Value& item : table->items) {
    if (!is_setting(item, mistakes)) continue;
    const bool twice =
        std::ranges::any_of(values, [&](const Value& other) { return set_text(other) == set_text(item); });
    if (twice) mistakes.add(item.place, shown(item) + " is said twice");
    values.push_back(item);
  }
  return values;
}

std::vector<Case> read_vary(const Settings& root, Mistakes& mistakes) {
  const core::Table* vary = root.value("vary").table();
  if (!vary) return {};
  std::vector<std::pair<std::string, std::vector<Value>>> lists;
  double count = 1;
  for (const auto& [key, list] : vary->entries) {
    lists.emplace_back(key, read_list(list, mistakes));
    count *= static_cast<double>(lists.back().second.size());
  }
  if (lists.empty() && root.value("cases").is_nothing())
    mistakes.add(root.place_of("vary"), "is empty: there is nothing to vary",
                 "name parameters of the scene, for example vary = { cells = { 500, 1000, 2000 } }");
  if (count > static_cast<double>(most_cases)) {
    mistakes.add(root.place_of("vary"), "makes " + output::shortest(count) + " cases; " +
                                            std::to_string(most_cases) + " is the most");
    return {};
  }
  return lists.empty() ? std::vector<Case>() : combinations(lists);
}

Case read_case(const Value& said, Mistakes& mistakes) {
  Case one;
  one.place = said.place;
  const core::Table* table = said.table();
  if (!table) return one;
  if (!table->items.empty())
    mistakes.add(said.place, "a case names its parameters", "for example { mesh = \"quads\", cells = 500 }");
  for (const auto& [key, value] : table->entries)
    if (is_setting(value, mistakes)) one.settings.push_back({key, value});
  std::ranges::sort(one.settings, {}, &Setting::key);
  return one;
}

std::string exact(const Case& one) {
  std::vector<std::string> words;
  for (const Setting& setting : one.settings) words.push_back(setting.key + "=" + set_text(setting.value));
  std::ranges::sort(words);
  std::string text;
  for (const std::string& word : words) text += word + ";";
  return text;
}

void read_cases(const Settings& root, std::vector<Case>& cases, Mistakes& mistakes) {
  const core::Table* list = root.value("cases").table();
  if (!list) return;
  if (list->items.empty())
    mistakes.add(root.place_of("cases"), "is empty: there is nothing to run",
                 "for example cases = { { mesh = \"quads\", cells = 500 } }");
  for (const Value& item : list->items) {
    Case one = read_case(item, mistakes);
    const auto same =
        std::ranges::find_if(cases, [&](const Case& other) { return exact(other) == exact(one); });
    if (same != cases.end())
      mistakes.add(one.place, "the case " + label(one) + " is there already, from line " +
                                  std::to_string(same->place.line));
    else
      cases.push_back(std::move(one));
  }
}

/// The last case once more without each effect.
void add_without(const Settings& root, std::vector<Case>& cases, Mistakes& mistakes) {
  const core::Table* map = root.value("without").table();
  if (!map || cases.empty()) return;
  const Case whole = cases.back();
  for (const auto& [name, said] : map->entries) {
    Case one = read_case(said, mistakes);
    if (one.settings.empty())
      mistakes.add(said.place, "names no parameter that leaves '" + name + "' out",
                   "for example { jointed = false }");
    for (const Setting& setting : whole.settings)
      if (!find(one, setting.key)) one.settings.push_back(setting);
    std::ranges::sort(one.settings, {}, &Setting::key);
    one.without = name;
    cases.push_back(std::move(one));
  }
}

void mark_constants(std::vector<Case>& cases) {
  if (cases.size() < 2) return;
  for (Setting& first : cases.front().settings) {
    const auto same = [&](const Case& one) {
      const Value* value = find(one, first.key);
      return value && set_text(*value) == set_text(first.value);
    };
    if (!std::ranges::all_of(cases, same)) continue;
    const std::string key = first.key;
    for (Case& one : cases)
      for (Setting& setting : one.settings) setting.differs = setting.differs && setting.key != key;
  }
}

/// A reference's unit is checked here: its dimension follows from the quantity, not from the schema.
Value without_units(const Value& study, Mistakes& mistakes) {
  const core::Table* root = study.table();
  const Value* measures = root ? root->find("measure") : nullptr;
  if (!measures || !measures->table()) return study;
  core::Table changed = *root, list = *measures->table();
  for (auto& [name, measure] : list.entries) {
    if (!measure.table()) continue;
    core::Table table = *measure.table();
    const Value* quantity = table.find("quantity");
    const Value* cost = table.find("cost");
    Measure measured;
    if (quantity && quantity->text()) measured.quantity = *quantity->text();
    if (cost && cost->text()) measured.cost = *cost->text();
    const std::string unit = unit_of(measured);
    for (auto& [key, value] : table.entries) {
      const core::Quantity* q = value.quantity();
      if (key != "reference" || !q || q->bare) continue;
      if (!unit.empty() && !(q->dimension == core::parse_dimension(unit)))
        mistakes.add(value.place,
                     "must be in " + unit + ", got " + core::format_quantity(q->value, q->dimension));
      value = core::make_value(q->value, value.place);
    }
    measure = core::make_value(std::move(table), measure.place);
  }
  for (auto& [key, value] : changed.entries)
    if (key == "measure") value = core::make_value(list, value.place);
  return core::make_value(std::move(changed), study.place);
}

void check_cost(const Measure& measure, Mistakes& mistakes) {
  const bool time = measure.cost == "cpu" || measure.cost == "wall";
  if (!measure.effect.empty() && !time)
    mistakes.add(measure.settings.place_of("effect"), "only times are told by effect",
                 "for example cost = \"cpu\", effect = \"contact\"");
  if (!measure.stage.empty() && time)
    mistakes.add(measure.settings.place_of("stage"), "times are those of the whole run",
                 "leave the stage out");
}

std::vector<Measure> read_measures(const Settings& root, Mistakes& mistakes) {
  std::vector<Measure> measures;
  for (const auto& [name, settings] : root.objects("measure")) {
    Measure measure;
    measure.name = name;
    measure.settings = settings;
    measure.title = settings.said("title") ? settings.text("title") : name;
    const auto word = [&settings = settings](const char* key) {
      return settings.has(key) ? settings.text(key) : "";
    };
    measure.stage = word("stage");
    measure.probe = word("probe");
    measure.minus = word("minus");
    measure.joint = word("joint");
    measure.quantity = word("quantity");
    measure.at = word("at");
    measure.cost = word("cost");
    measure.effect = word("effect");
    check_cost(measure, mistakes);
    measure.reference = settings.value("reference");
    if (!measure.cost.empty() && !settings.said("reference"))
      measure.reference = core::make_value(std::string("none"));
    measures.push_back(std::move(measure));
  }
  if (measures.empty() && root.value("measure").table())
    mistakes.add(root.place_of("measure"), "is empty: a study needs at least one measure",
                 "for example crest = { probe = \"crest\", quantity = \"uy\" }");
  return measures;
}

std::vector<std::string> keys_of(const std::vector<Case>& cases) {
  std::vector<std::string> keys;
  for (const Case& one : cases)
    for (const Setting& setting : one.settings)
      if (std::ranges::find(keys, setting.key) == keys.end()) keys.push_back(setting.key);
  return keys;
}

/// The parameters whose values are different numbers.
std::vector<std::string> varied_numbers(const Study& study, const std::vector<std::string>& keys) {
  std::vector<std::string> numbers;
  for (const std::string& key : keys) {
    std::vector<double> values;
    for (const Case& one : study.cases)
      if (const Value* value = find(one, key); value && value->quantity())
        values.push_back(value->quantity()->value);
    std::ranges::sort(values);
    const bool varied = !values.empty() && values.front() != values.back();
    if (varied && std::ranges::find(study.problem, key) == study.problem.end()) numbers.push_back(key);
  }
  return numbers;
}

void read_roles(const Settings& root, Study& study, Mistakes& mistakes) {
  const std::vector<std::string> keys = keys_of(study.cases);
  const auto is_key = [&](const std::string& word, const core::Place& place) {
    if (keys.empty() || std::ranges::find(keys, word) != keys.end()) return;
    mistakes.add(place, "the study varies no '" + word + "'", core::did_you_mean(word, keys));
  };
  if (const core::Table* list = root.value("problem").table())
    for (const Value& item : list->items) {
      if (!item.text()) continue;
      is_key(*item.text(), item.place);
      study.problem.push_back(*item.text());
    }
  if (root.value("refine").boolean()) return;  // none refines
  if (root.has("refine")) {
    study.refine = root.text("refine");
    is_key(study.refine, root.place_of("refine"));
    return;
  }
  const std::vector<std::string> numbers = varied_numbers(study, keys);
  if (numbers.size() == 1) study.refine = numbers.front();
  for (const Measure& measure : study.measures) {
    if (!study.refine.empty() || !measure.compared_with("richardson") || keys.empty()) continue;
    mistakes.add(measure.settings.place,
                 "its reference is the limit of refined runs, but " +
                     std::string(numbers.empty() ? "no number is varied" : "more than one number is varied"),
                 numbers.empty() ? "give the measure a reference"
                                 : "say which one refines, for example refine = \"" + numbers.front() +
                                       "\", and problem = { … } for those that change what is asked");
  }
}

}  // namespace

Study read_study(const Value& value, const core::Registry& registry, Mistakes& mistakes) {
  Study study;
  Mistakes found;
  study.root =
      core::check(without_units(value, found), registry.find("study", "study")->schema, registry, found);
  const Settings& root = study.root;
  if (root.has("title")) study.title = root.text("title");
  if (root.has("scene"))
    study.scene = std::filesystem::path(root.place.file).parent_path() / root.text("scene");
  std::error_code error;
  if (root.has("scene") && !std::filesystem::exists(study.scene, error))
    found.add(root.place_of("scene"), "there is no file '" + root.text("scene") + "' in the study's folder");
  study.cases = read_vary(root, found);
  read_cases(root, study.cases, found);
  mark_constants(study.cases);
  add_without(root, study.cases, found);
  study.measures = read_measures(root, found);
  if (found.empty()) read_roles(root, study, found);
  if (root.has("repeats")) study.repeats = root.integer("repeats");
  if (root.has("threads")) study.threads = root.integer("threads");
  if (root.has("files")) study.files = root.flag("files");
  for (const core::Mistake& mistake : found.list()) mistakes.add(mistake.place, mistake.what, mistake.advice);
  return study;
}

}  // namespace ashlar::study
