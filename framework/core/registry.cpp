#include "core/registry.hpp"

#include <dlfcn.h>

#include <algorithm>

namespace ashlar::core {

namespace {

std::string full_name(const std::string& kind, const std::string& name) {
  return name.empty() || name == kind ? kind : kind + "." + name;
}

std::string owner(const std::string& module) {
  return module.empty() ? "the framework" : "module " + module;
}

void append(Schema& schema, const std::vector<Parameter>& parameters, const std::string& module) {
  for (const Parameter& parameter : parameters) {
    if (schema.find(parameter.key))
      throw InputError(Mistake{{},
                               owner(module) + " adds '" + parameter.key + "' to " +
                                   full_name(schema.kind, schema.name) + ", which has it already",
                               {}});
    schema.parameters.push_back(parameter);
  }
}

}  // namespace

void Registry::add_schema(Schema schema, const std::string& module) {
  const auto known = entries_[schema.kind].find(schema.name);
  if (known != entries_[schema.kind].end())
    throw InputError(Mistake{{},
                             owner(module) + " provides " + full_name(schema.kind, schema.name) + ", which " +
                                 owner(known->second.module) + " provides already",
                             {}});
  for (const Extension& extension : extensions_)
    if (extension.kind == schema.kind && (extension.name.empty() || extension.name == schema.name))
      append(schema, extension.parameters, extension.module);
  Entry entry{std::move(schema), module, {}};
  entries_[entry.schema.kind].emplace(entry.schema.name, std::move(entry));
}

void Registry::extend(const std::string& kind, const std::string& name, std::vector<Parameter> parameters,
                      const std::string& module) {
  if (const auto found = entries_.find(kind); found != entries_.end())
    for (auto& [entry_name, entry] : found->second)
      if (name.empty() || name == entry_name) append(entry.schema, parameters, module);
  extensions_.push_back({kind, name, std::move(parameters), module});
}

void Registry::add_effect(EffectEntry effect) {
  add_schema(Schema{"effect", effect.name, {}, effect.doc, {}}, effect.module);
  effects_.push_back(std::move(effect));
}

void Registry::add_module(Module module) {
  modules_.push_back(std::move(module));
}

const Registry::Entry* Registry::find(const std::string& kind, const std::string& name) const {
  const auto names = entries_.find(kind);
  if (names == entries_.end()) return nullptr;
  const auto entry = names->second.find(name);
  return entry == names->second.end() ? nullptr : &entry->second;
}

const Schema* Registry::find_constructor(const std::string& word) const {
  if (word.empty()) return nullptr;
  for (const auto& [kind, names] : entries_)
    for (const auto& [name, entry] : names)
      if (entry.schema.constructor == word) return &entry.schema;
  return nullptr;
}

std::vector<std::string> Registry::kinds() const {
  std::vector<std::string> list;
  for (const auto& [kind, names] : entries_) list.push_back(kind);
  return list;
}

std::vector<std::string> Registry::names(const std::string& kind) const {
  std::vector<std::string> list;
  if (const auto names = entries_.find(kind); names != entries_.end())
    for (const auto& [name, entry] : names->second) list.push_back(name);
  return list;
}

std::vector<std::string> Registry::open_modules() const {
  std::vector<std::string> list;
  for (const Module& module : modules_)
    if (module.open) list.push_back(module.name);
  return list;
}

void Registry::set_make(const std::string& kind, const std::string& name, std::any make) {
  if (!find(kind, name))
    throw InputError(
        Mistake{{},
                "a module registers " + full_name(kind, name) + ", but no module.lua provides it",
                did_you_mean(name, names(kind))});
  entries_[kind][name].make = std::move(make);
}

const std::any& Registry::find_make(const std::string& kind, const std::string& name) {
  const Entry* entry = find(kind, name);
  if (!entry) {
    const bool known = entries_.contains(kind);
    throw InputError(Mistake{
        {},
        known ? "there is no " + kind + " '" + name + "'" : "no module provides the kind '" + kind + "'",
        known ? did_you_mean(name, names(kind)) : did_you_mean(kind, kinds())});
  }
  if (!entry->make.has_value() && !entry->module.empty()) open(entry->module);
  if (!entry->make.has_value())
    throw InputError(Mistake{
        {},
        owner(entry->module) + " provides " + full_name(kind, name) + ", but registers no maker for it",
        {}});
  return entry->make;
}

void Registry::open(const std::string& name) {
  const auto found =
      std::find_if(modules_.begin(), modules_.end(), [&](const Module& m) { return m.name == name; });
  if (found == modules_.end() || !opener_)
    throw InputError(
        Mistake{{}, "module " + name + " cannot be opened: nothing is known of its library", {}});
  if (found->open) return;
  const std::size_t index = static_cast<std::size_t>(found - modules_.begin());
  opener_(*this, Module(*found));
  modules_[index].open = true;
}

namespace {

std::string loader_words() {
  const char* words = dlerror();
  return words ? words : "the loader gives no reason";
}

InputError cannot_open(const Registry::Module& module, const std::string& why,
                       const std::string& advice = {}) {
  return InputError(Mistake{{}, "module " + module.name + " cannot be opened: " + why, advice});
}

template <class Pointer>
Pointer symbol(void* library, const char* name, const Registry::Module& module) {
  dlerror();
  void* address = dlsym(library, name);
  if (!address)
    throw cannot_open(module, loader_words(),
                      "a module's library must contain ASHLAR_MODULE(registry) { … }");
  return reinterpret_cast<Pointer>(address);
}

void open_library(Registry& registry, const Registry::Module& module) {
  if (module.library.empty()) throw cannot_open(module, "it has no library");
  // Never closed again: makers and the objects they made live in it.
  void* library = dlopen(module.library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) throw cannot_open(module, loader_words());
  const int version = symbol<ModuleVersion>(library, "ashlar_module_version", module)();
  if (version != module_interface_version)
    throw cannot_open(module,
                      module.library + " was built for interface version " + std::to_string(version) +
                          ", this program has version " + std::to_string(module_interface_version),
                      "build the module again with this program's headers");
  symbol<RegisterModule>(library, "register_module", module)(registry);
}

}  // namespace

Registry::Opener shared_object_opener() {
  return open_library;
}

}  // namespace ashlar::core
