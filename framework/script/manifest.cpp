// Reading module.lua: see script.hpp. A manifest is checked with schemas of its own.

#include <algorithm>
#include <stdexcept>

#include "script/convert.hpp"
#include "script/sandbox.hpp"

namespace ashlar::script {

namespace {

using core::Form;
using core::Parameter;
using core::Schema;
using core::Settings;

constexpr double manifest_seconds = 5;
constexpr std::size_t manifest_memory = std::size_t{256} << 20;

const std::vector<std::pair<std::string, Form>>& form_names() {
  static const std::vector<std::pair<std::string, Form>> names = {
      {"boolean", Form::boolean}, {"number", Form::number}, {"integer", Form::integer},
      {"text", Form::text},       {"point", Form::point},   {"list", Form::list},
      {"map", Form::map},         {"object", Form::object}, {"function", Form::function},
      {"table", Form::table}};
  return names;
}

Parameter simple(std::string key, Form form, bool required = false) {
  Parameter parameter;
  parameter.key = std::move(key);
  parameter.forms = static_cast<unsigned>(form);
  parameter.required = required;
  return parameter;
}

Parameter several(std::string key, Form form, Parameter each, bool required = false) {
  Parameter parameter = simple(std::move(key), form, required);
  parameter.each = std::make_shared<const Parameter>(std::move(each));
  return parameter;
}

Parameter object(std::string key, std::string kind) {
  Parameter parameter = simple(std::move(key), Form::object);
  parameter.kind = std::move(kind);
  return parameter;
}

Schema schema(std::string kind, std::vector<Parameter> parameters) {
  return {kind, kind, {}, {}, std::move(parameters)};
}

Schema parameter_schema() {
  Parameter forms = several("forms", Form::list, simple({}, Form::text), true);
  Parameter fallback = simple("default", Form::boolean);
  fallback.forms = Form::boolean | Form::number | Form::text | Form::table;
  Parameter each_form = simple({}, Form::text);
  for (const auto& [name, form] : form_names()) each_form.choices.push_back(name);
  forms.each = std::make_shared<const Parameter>(each_form);
  return schema("parameter",
                {simple("key", Form::text), forms, simple("dimension", Form::text),
                 simple("required", Form::boolean), fallback, object("range", "range"),
                 object("usual", "range"), several("choices", Form::list, simple({}, Form::text)),
                 simple("refers", Form::text), simple("kind", Form::text), object("each", "parameter"),
                 simple("numerical", Form::boolean), simple("doc", Form::text)});
}

// What a manifest may say.
core::Registry manifest_schemas() {
  core::Registry registry;
  registry.add_schema(schema("range", {simple("above", Form::number), simple("below", Form::number),
                                       simple("from", Form::number), simple("to", Form::number)}));
  registry.add_schema(parameter_schema());
  registry.add_schema(schema("alternative", {simple("", Form::text, true), simple("least", Form::integer),
                                             simple("most", Form::integer)}));
  registry.add_schema(schema(
      "provided", {simple("kind", Form::text, true), simple("name", Form::text, true),
                   simple("constructor", Form::text), simple("doc", Form::text),
                   simple("usual", Form::boolean), several("parameters", Form::list, object({}, "parameter")),
                   several("alternatives", Form::list, object({}, "alternative"))}));
  registry.add_schema(schema(
      "effect",
      {simple("name", Form::text, true), several("called_by", Form::list, simple({}, Form::text), true),
       simple("nonlinear", Form::boolean), simple("doc", Form::text), simple("left_out", Form::text)}));
  registry.add_schema(schema(
      "manifest", {simple("name", Form::text, true), simple("doc", Form::text),
                   several("provides", Form::list, object({}, "provided")), simple("extends", Form::table),
                   several("effects", Form::list, object({}, "effect"))}));
  registry.add_schema(schema("extension", {several("parameters", Form::list, object({}, "parameter"))}));
  return registry;
}

core::Range range(const Settings& said, const std::string& key) {
  core::Range result;
  if (!said.has(key)) return result;
  const Settings& limits = said.object(key);
  result.low = limits.number("from", result.low);
  result.high = limits.number("to", result.high);
  if (limits.has("above")) {
    result.low = limits.number("above");
    result.low_open = true;
  }
  if (limits.has("below")) {
    result.high = limits.number("below");
    result.high_open = true;
  }
  return result;
}

std::vector<std::string> texts(const Settings& said, const std::string& key) {
  std::vector<std::string> list;
  if (const core::Table* table = said.value(key).table())
    for (const core::Value& item : table->items)
      if (item.text()) list.push_back(*item.text());
  return list;
}

core::Dimension dimension(const Settings& said, core::Mistakes& mistakes) {
  try {
    return core::parse_dimension(said.text("dimension"));
  } catch (const std::invalid_argument& error) {
    mistakes.add(said.place_of("dimension"), error.what(), "for example Pa, m/s^2, N/m^3");
    return {};
  }
}

Parameter parameter(const Settings& said, core::Mistakes& mistakes) {
  Parameter result;
  result.key = said.text("key");
  for (const std::string& word : texts(said, "forms"))
    for (const auto& [name, form] : form_names())
      if (name == word) result.forms = result.forms | form;
  result.dimension = dimension(said, mistakes);
  result.required = said.flag("required");
  if (said.has("default")) result.fallback = said.value("default");
  result.range = range(said, "range");
  result.usual = range(said, "usual");
  result.choices = texts(said, "choices");
  result.refers = said.text("refers");
  result.kind = said.text("kind");
  if (said.has("each"))
    result.each = std::make_shared<const Parameter>(parameter(said.object("each"), mistakes));
  result.numerical = said.flag("numerical");
  result.doc = said.text("doc");
  const bool objects = core::allows(result.forms, Form::object);
  if (objects && result.kind.empty()) mistakes.add(said.place, "a parameter of form 'object' needs a kind");
  return result;
}

std::vector<Parameter> parameters(const Settings& said, core::Mistakes& mistakes) {
  std::vector<Parameter> list;
  for (const auto& [name, one] : said.objects("parameters")) list.push_back(parameter(one, mistakes));
  return list;
}

// { "size", "cells" }: exactly one of them, unless `least` or `most` say otherwise.
std::vector<core::Alternative> alternatives(const Settings& said, const std::vector<Parameter>& known,
                                            core::Mistakes& mistakes) {
  std::vector<core::Alternative> list;
  for (const auto& [number, one] : said.objects("alternatives")) {
    core::Alternative alternative;
    for (const core::Value& key : one.items) {
      if (!key.text()) continue;
      const bool there = std::any_of(known.begin(), known.end(), [&](const Parameter& parameter) {
        return parameter.key == *key.text();
      });
      if (!there) mistakes.add(key.place, "there is no parameter '" + *key.text() + "' here");
      alternative.keys.push_back(*key.text());
    }
    alternative.least = static_cast<int>(one.number("least", 1));
    alternative.most = static_cast<int>(one.number("most", 1));
    list.push_back(std::move(alternative));
  }
  return list;
}

class ManifestReader {
 public:
  explicit ManifestReader(core::Registry& registry) : registry_(registry), schemas_(manifest_schemas()) {}

  void read(const core::Value& value, const std::filesystem::path& folder) {
    const std::size_t before = mistakes.list().size();
    const Settings said =
        core::check(value, schemas_.find("manifest", "manifest")->schema, schemas_, mistakes);
    if (mistakes.list().size() > before) return;
    const std::string name = said.text("name");
    for (const core::Registry::Module& module : registry_.modules())
      if (module.name == name) return mistakes.add(said.place, "there is a module '" + name + "' already");
    registry_.add_module({name, said.text("doc"), (folder / ("ashlar_" + name + ".so")).string(), false});
    for (const auto& [index, provided] : said.objects("provides")) add_provided(provided, name);
    if (const core::Table* extends = said.value("extends").table())
      for (const auto& [target, list] : extends->entries) add_extension(target, list, name);
    for (const auto& [index, effect] : said.objects("effects"))
      registry_.add_effect({effect.text("name"), name, texts(effect, "called_by"), effect.flag("nonlinear"),
                            effect.text("doc"), effect.text("left_out")});
  }

  core::Mistakes mistakes;

 private:
  void add_provided(const Settings& said, const std::string& module) {
    std::vector<Parameter> known = parameters(said, mistakes);
    std::vector<core::Alternative> choices = alternatives(said, known, mistakes);
    try {
      registry_.add_schema({said.text("kind"), said.text("name"), said.text("constructor"), said.text("doc"),
                            std::move(known), std::move(choices), said.flag("usual")},
                           module);
    } catch (const core::InputError& error) {
      mistakes.add(said.place, error.mistakes().front().what);
    }
  }

  // "stage", or "region.Polygon" for one entry of a kind
  void add_extension(const std::string& target, const core::Value& list, const std::string& module) {
    const core::Value wrapped = core::make_value(core::Table{{}, {}, {{"parameters", list}}}, list.place);
    const Settings said =
        core::check(wrapped, schemas_.find("extension", "extension")->schema, schemas_, mistakes);
    const auto dot = target.find('.');
    const std::string name = dot == std::string::npos ? "" : target.substr(dot + 1);
    try {
      registry_.extend(target.substr(0, dot), name, parameters(said, mistakes), module);
    } catch (const core::InputError& error) {
      mistakes.add(list.place, error.mistakes().front().what);
    }
  }

  core::Registry& registry_;
  core::Registry schemas_;
};

std::vector<std::filesystem::path> module_folders(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::filesystem::path> list;
  for (const auto& folder : folders) {
    std::error_code error;
    std::vector<std::filesystem::path> inside;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
      if (std::filesystem::is_regular_file(entry.path() / "module.lua", error))
        inside.push_back(entry.path());
    std::sort(inside.begin(), inside.end());
    list.insert(list.end(), inside.begin(), inside.end());
  }
  return list;
}

}  // namespace

void read_module_manifests(const std::vector<std::filesystem::path>& folders, core::Registry& registry) {
  ManifestReader reader(registry);
  const auto machine = std::make_shared<Machine>(manifest_seconds, manifest_memory);
  machine->mistakes = &reader.mistakes;
  if (const auto failure = machine->protect([](lua_State* L) { make_sandbox(L, {}); }))
    reader.mistakes.add(failure->place, failure->what);
  for (const auto& folder : module_folders(folders)) {
    const std::filesystem::path file = folder / "module.lua";
    const std::string name = file.string();
    core::Value value;
    auto work = [&](lua_State* L) {
      if (!machine->compile(L, file, name, read_text(file))) return;
      machine->run_chunk(L);
      value = convert(machine, L, -1, {name, 0, {}}, reader.mistakes);
    };
    const std::size_t before = reader.mistakes.list().size();
    if (const auto failure = machine->protect(work)) reader.mistakes.add(failure->place, failure->what);
    if (reader.mistakes.list().size() == before) reader.read(value, folder);
  }
  machine->mistakes = nullptr;
  reader.mistakes.throw_if_any();
}

}  // namespace ashlar::script
