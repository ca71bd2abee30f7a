#pragma once
// kind → name → {doc, schema, make}. The registry holds kinds that it has never heard of.
// Schemas come from a module's `module.lua` (read by script/) without opening the module's library;
// `make` arrives when the library is opened, on the first call for it.

#include <any>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/schema.hpp"

namespace ashlar::core {

/// Bumped whenever a public header changes in a way that breaks modules.
constexpr int module_interface_version = 1;

/// What makes the plan call for an effect without opening its module.
struct EffectEntry {
  std::string name;
  std::string module;
  std::vector<std::string> called_by;  ///< paths such as "stage.gravity", "scene.joints", "scene.geometry"
  bool nonlinear = false;
  std::string doc;
  std::string left_out;  ///< what is missing without it, and when that starts to matter
};

class Registry {
 public:
  struct Entry {
    Schema schema;
    std::string module;  ///< "" for the framework's own
    std::any make;       ///< a std::function; empty until the module's library is opened
  };
  struct Module {
    std::string name;
    std::string doc;
    std::string library;  ///< full path of the shared object; "" for none
    bool open = false;
  };
  /// Opens a module's library and calls its register_module. Set by the host.
  using Opener = std::function<void(Registry&, const Module&)>;

  void add_schema(Schema schema, const std::string& module = {});
  /// Adds parameters to a kind of the framework, such as "stage" or "joint"; name "" means every entry of
  /// the kind. Works before and after add_schema. Throws InputError if a schema has the key already.
  void extend(const std::string& kind, const std::string& name, std::vector<Parameter> parameters,
              const std::string& module);
  /// Also makes the entry of kind "effect" that its maker goes to.
  void add_effect(EffectEntry effect);
  void add_module(Module module);
  void set_opener(Opener opener) { opener_ = std::move(opener); }

  /// Called by modules from register_module. The schema must be there already.
  template <class Make>
  void add_make(const std::string& kind, const std::string& name, Make make) {
    set_make(kind, name, std::any(std::move(make)));
  }
  /// The maker of an entry as `std::function<Signature>`; opens the entry's module if needed.
  template <class Signature>
  std::function<Signature> make(const std::string& kind, const std::string& name) {
    return std::any_cast<std::function<Signature>>(find_make(kind, name));
  }

  const Entry* find(const std::string& kind, const std::string& name) const;
  const Schema* find_constructor(const std::string& word) const;
  std::vector<std::string> kinds() const;
  std::vector<std::string> names(const std::string& kind) const;
  const std::vector<EffectEntry>& effects() const { return effects_; }
  const std::vector<Module>& modules() const { return modules_; }
  std::vector<std::string> open_modules() const;

 private:
  void set_make(const std::string& kind, const std::string& name, std::any make);
  const std::any& find_make(const std::string& kind, const std::string& name);
  void open(const std::string& module);

  struct Extension {
    std::string kind, name;
    std::vector<Parameter> parameters;
    std::string module;
  };

  std::map<std::string, std::map<std::string, Entry>> entries_;
  std::vector<Extension> extensions_;  ///< kept for schemas that come later
  std::vector<EffectEntry> effects_;
  std::vector<Module> modules_;
  Opener opener_;
};

/// The two functions that every module library exports (extern "C").
using RegisterModule = void (*)(Registry&);
using ModuleVersion = int (*)();
/// Put this once into a module: it defines both.
#define ASHLAR_MODULE(registry)                      \
  extern "C" int ashlar_module_version() {           \
    return ::ashlar::core::module_interface_version; \
  }                                                  \
  extern "C" void register_module(::ashlar::core::Registry& registry)

/// Opens shared objects with dlopen: version first, then register_module. Throws InputError with the
/// loader's own words.
Registry::Opener shared_object_opener();

}  // namespace ashlar::core
