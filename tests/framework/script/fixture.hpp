#pragma once
// Scenarios written to a folder of their own, read with a few made-up kinds.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/log.hpp"
#include "script/script.hpp"

namespace ashlar::script {

class Scripts : public ::testing::Test {
 protected:
  Scripts() {
    folder = std::filesystem::temp_directory_path() / ("ashlar_scripts_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    core::log().clear();
    add("scene", "scene", "Scene");
    add("polygon", "polygon", "Polygon");
    add("mesh", "voronoi", "mesh.voronoi");
    add("mesh", "structured", "mesh.structured");
    add("material", "elastic", "material.elastic");
    registry.add_module({"meshing", "", "", false});
  }
  ~Scripts() override { std::filesystem::remove_all(folder); }

  void add(const std::string& kind, const std::string& name, const std::string& word) {
    core::Schema schema;
    schema.kind = kind;
    schema.name = name;
    schema.constructor = word;
    registry.add_schema(schema);
  }

  std::filesystem::path write(const std::string& name, const std::string& text) {
    std::filesystem::create_directories((folder / name).parent_path());
    std::ofstream(folder / name, std::ios::binary) << text;
    return folder / name;
  }

  // Reads the text as scene.lua, from its folder, so that messages say "scene.lua".
  ScriptResult read(const std::string& text) {
    write("scene.lua", text);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    mistakes = {};
    ScriptResult result = read_scene("scene.lua", registry, options, mistakes);
    std::filesystem::current_path(before);
    return result;
  }

  const core::Value& at(const core::Value& value, const std::string& path) {
    const core::Value* here = &value;
    for (std::size_t begin = 0; begin < path.size();) {
      const std::size_t end = std::min(path.find('.', begin), path.size());
      const std::string key = path.substr(begin, end - begin);
      const core::Table* table = here->table();
      const bool item = !key.empty() && key.find_first_not_of("0123456789") == std::string::npos;
      if (table && item && std::stoul(key) <= table->items.size())
        here = &table->items[std::stoul(key) - 1];
      else if (table && table->find(key))
        here = table->find(key);
      else
        throw std::out_of_range(path);
      begin = end + 1;
    }
    return *here;
  }

  double number(const core::Value& value, const std::string& path) {
    return at(value, path).quantity()->value;
  }

  /// All mistakes, a line each, without advice.
  std::string said() const {
    std::string text;
    for (const core::Mistake& mistake : mistakes.list())
      text += core::to_string(core::Mistake{mistake.place, mistake.what, {}}) + "\n";
    return text;
  }
  std::string advice(std::size_t i = 0) const { return mistakes.list().at(i).advice; }

  std::filesystem::path folder;
  core::Registry registry;
  Options options;
  core::Mistakes mistakes;
};

}  // namespace ashlar::script
