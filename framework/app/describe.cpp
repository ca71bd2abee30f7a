// ashlar describe WORD: the schemas behind a kind, an entry or a word of the script.

#include <iomanip>
#include <iostream>

#include "app/host.hpp"
#include "app/verbs.hpp"

namespace ashlar::app {

namespace {

std::vector<const core::Schema*> find_schemas(const core::Registry& registry, const std::string& word) {
  if (const core::Schema* schema = registry.find_constructor(word)) return {schema};
  std::vector<const core::Schema*> found;
  for (const std::string& name : registry.names(word)) found.push_back(&registry.find(word, name)->schema);
  if (!found.empty()) return found;
  const auto dot = word.find('.');
  if (dot == std::string::npos) return {};
  if (const auto* entry = registry.find(word.substr(0, dot), word.substr(dot + 1))) return {&entry->schema};
  return {};
}

void describe_units() {
  std::cout << "units    in scripts: units.m, units.kN/units.m^3, 15*units.m\n"
               "A quantity is a number times units; a bare number is SI. Its dimension is checked where it "
               "is used.\n";
  for (const core::Unit& unit : core::unit_table()) {
    const std::string si = core::to_string(unit.dimension);
    std::cout << "  " << std::left << std::setw(8) << unit.name << std::setw(16)
              << core::format_quantity(unit.factor, {}) + (si.empty() ? "" : " " + si) << unit.doc << '\n';
  }
}

/// The comment that a file of the library begins with; false if there is no such file.
bool describe_library(const std::string& word) {
  const std::string text = library_doc(word);
  if (!text.empty())
    std::cout << word << "    in scripts: local " << word << " = require \"" << word << "\"\n" << text;
  return !text.empty();
}

std::vector<std::string> all_words(const core::Registry& registry) {
  std::vector<std::string> words = {"param", "units"};
  for (const std::string& name : library_names()) words.push_back(name);
  for (const std::string& kind : registry.kinds()) {
    words.push_back(kind);
    for (const std::string& name : registry.names(kind)) {
      const std::string& word = registry.find(kind, name)->schema.constructor;
      words.push_back(word.empty() ? kind + "." + name : word);
    }
  }
  return words;
}

}  // namespace

int describe(const CommandLine& line) {
  const core::Registry registry = make_registry();
  const std::string& word = line.words.front();
  if (word == "units") return describe_units(), done;
  if (word == "param") return std::cout << core::describe(script::param_schema()), done;
  if (describe_library(word)) return done;
  const auto schemas = find_schemas(registry, word);
  if (schemas.empty())
    fail("there is nothing called '" + word + "'", core::did_you_mean(word, all_words(registry)));
  for (std::size_t i = 0; i < schemas.size(); ++i)
    std::cout << (i == 0 ? "" : "\n") << core::describe(*schemas[i]);
  return done;
}

}  // namespace ashlar::app
