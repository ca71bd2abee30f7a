// ashlar check: every mistake in a scene, or what it holds.

#include <iostream>

#include "app/host.hpp"
#include "app/progress.hpp"
#include "app/verbs.hpp"

namespace ashlar::app {

namespace {

std::string counted(std::size_t count, const std::string& word) {
  return std::to_string(count) + " " + word + (count == 1 ? "" : "s");
}

std::string value_text(const core::Value& value) {
  if (const core::Quantity* quantity = value.quantity())
    return core::format_quantity(quantity->value, quantity->dimension);
  if (const bool* flag = value.boolean()) return *flag ? "true" : "false";
  return value.text() ? "\"" + *value.text() + "\"" : value.type_name();
}

}  // namespace

int check(const CommandLine& line) {
  show_log(line.quiet);
  const auto scenario = read_scenario(line);
  if (line.quiet) return done;
  const model::Scene& scene = scenario->scene;
  std::cout << scene.title << ": no mistakes found\n"
            << "  " << counted(scene.regions.size(), "region") << ", "
            << counted(scene.joints.size(), "joint") << ", " << counted(scene.stages.size(), "stage") << ", "
            << counted(scene.probes.size(), "probe") << '\n';
  for (const script::ParamUse& param : scenario->script.params)
    std::cout << "  --set " << param.name << "=…  now " << value_text(param.value)
              << (param.doc.empty() ? "" : ": " + param.doc) << '\n';
  return done;
}

}  // namespace ashlar::app
