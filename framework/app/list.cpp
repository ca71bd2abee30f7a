// ashlar list [KIND]: what scripts can say.

#include <algorithm>
#include <iomanip>
#include <iostream>

#include "app/host.hpp"
#include "app/verbs.hpp"

namespace ashlar::app {

namespace {

std::string first_sentence(const std::string& doc) {
  const auto stop = doc.find(". ");
  return stop == std::string::npos ? doc : doc.substr(0, stop + 1);
}

void list_kind(const core::Registry& registry, const std::string& kind) {
  std::cout << kind << '\n';
  for (const std::string& name : registry.names(kind)) {
    const core::Registry::Entry& entry = *registry.find(kind, name);
    const std::string& word = entry.schema.constructor;
    std::cout << "  " << std::left << std::setw(30)
              << (word.empty() ? "\"" + name + "\"" : word + " { … }")
              // the ellipsis is three bytes but one column wide
              << (word.empty() ? "" : "  ") << first_sentence(entry.schema.doc);
    if (!entry.module.empty()) std::cout << "  [" << entry.module << "]";
    std::cout << '\n';
  }
}

void list_library() {
  std::cout << "library\n";
  for (const std::string& name : library_names()) {
    const std::string doc = library_doc(name);
    std::cout << "  " << std::left << std::setw(28) << "require \"" + name + "\""
              << first_sentence(doc.substr(0, doc.find('\n'))) << '\n';
  }
}

}  // namespace

int list(const CommandLine& line) {
  const core::Registry registry = make_registry();
  std::vector<std::string> kinds = registry.kinds();
  if (!line.words.empty()) {
    const std::string& kind = line.words.front();
    if (kind == "library") return list_library(), done;
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
      fail("there is no kind '" + kind + "'", core::did_you_mean(kind, kinds));
    kinds = {kind};
  }
  for (const std::string& kind : kinds) list_kind(registry, kind);
  if (line.words.empty()) {
    list_library();
    std::cout
        << "in every script\n  param { … }, units: see `ashlar describe param` and `ashlar describe units`\n";
  }
  return done;
}

}  // namespace ashlar::app
