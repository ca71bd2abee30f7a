#pragma once
// Settings and scenes as the framework would hand them on, made by hand.

#include "core/log.hpp"
#include "model/effect.hpp"

namespace ashlar::test {

using core::Settings;

inline core::Value value(double number) {
  return core::make_value(number);
}
inline core::Value value(bool flag) {
  return core::make_value(flag);
}
inline core::Value value(const char* text) {
  return core::make_value(std::string(text), {"scene.lua", 7, text});
}
inline core::Value list(std::vector<core::Value> items) {
  return core::make_value(core::Table{{}, std::move(items), {}}, {"scene.lua", 5, "list"});
}
inline core::Value pair(double x, double y) {
  return list({value(x), value(y)});
}

/// Settings under construction: said("level", value(3.0)).said(…).
struct Said {
  Settings settings;
  Said& say(const std::string& key, core::Value value) {
    settings.entries.push_back({key, std::move(value), true, {}, {}, {}});
    return *this;
  }
  /// A key of the schema that was not said and has no default.
  Said& silent(const std::string& key) {
    settings.entries.push_back({key, {}, false, {}, {}, {}});
    return *this;
  }
  Said& object(const std::string& key, const Settings& inner) {
    Settings::Entry entry{key, value(inner.name.c_str()), true, {}, {}, {}};
    entry.object = std::make_shared<const Settings>(inner);
    settings.entries.push_back(std::move(entry));
    return *this;
  }
  Said& objects(const std::string& key, std::vector<std::pair<std::string, Settings>> inner) {
    Settings::Entry entry{key, list({}), true, {}, {}, {}};
    entry.objects = std::move(inner);
    settings.entries.push_back(std::move(entry));
    return *this;
  }
};

/// A function of (x, y) as if it came from a script.
class PlaneFunction : public core::Function {
 public:
  explicit PlaneFunction(std::function<double(double, double)> f) : f_(std::move(f)) {}
  std::vector<double> call(std::span<const double> a) const override { return {f_(a[0], a[1])}; }

 private:
  std::function<double(double, double)> f_;
};
inline core::Value function(std::function<double(double, double)> f) {
  core::Value value;
  value.place = {"scene.lua", 9, "function"};
  value.data = std::shared_ptr<const core::Function>(std::make_shared<PlaneFunction>(std::move(f)));
  return value;
}

/// What an effect contributes to a stage with these settings, as a force vector; mistakes are kept.
struct Contribution {
  std::vector<double> force;
  core::Mistakes mistakes;
  model::Terms terms;
};
inline Contribution contribute(model::Effect& effect, const model::Model& model, const Settings& settings,
                               const std::string& stage_name = {}) {
  Contribution result;
  model::Scene scene;
  model::StageData stage;
  stage.name = stage_name;
  stage.settings = settings;
  fields::State state;
  effect.contribute({scene, stage, model, state, result.mistakes}, result.terms);
  result.force.assign(model.dofs.size(), 0.0);
  for (const auto& load : result.terms.loads) load->add_force(result.force);
  return result;
}

/// The mistakes that an effect finds in a scene of one stage.
inline std::vector<core::Mistake> mistakes_of(const model::Effect& effect, const Settings& stage) {
  model::Scene scene;
  scene.stages.emplace_back().settings = stage;
  core::Mistakes mistakes;
  effect.check(scene, mistakes);
  return mistakes.list();
}

/// Whether a line of the log holds these words.
inline bool logged(const std::string& words, core::Level level) {
  for (const auto& [said, line] : core::log().lines())
    if (said == level && line.find(words) != std::string::npos) return true;
  return false;
}

}  // namespace ashlar::test
