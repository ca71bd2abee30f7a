// ashlar describe WORD: the schemas behind a kind, an entry or a word of the script.

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

std::vector<std::string> all_words(const core::Registry& registry) {
  std::vector<std::string> words;
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
  const auto schemas = find_schemas(registry, word);
  if (schemas.empty())
    fail("there is nothing called '" + word + "'", core::did_you_mean(word, all_words(registry)));
  for (std::size_t i = 0; i < schemas.size(); ++i)
    std::cout << (i == 0 ? "" : "\n") << core::describe(*schemas[i]);
  return done;
}

}  // namespace ashlar::app
