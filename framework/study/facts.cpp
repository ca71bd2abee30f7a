// What measures may name in a scene, and the units of what they read.

#include <algorithm>
#include <map>

#include "study/study.hpp"

namespace ashlar::study {

namespace {

using Words = std::vector<std::string>;

const Words joint_quantities = {"normal_force",    "max_slip",           "max_opening",
                                "max_penetration", "penetration_over_h", "max_pressure"};

/// What a probe reads of a field; nothing for fields that only their module knows.
const std::map<std::string, Words> field_quantities = {{"displacement", {"ux", "uy", "u"}},
                                                       {"stress", {"sxx", "syy", "sxy", "szz"}},
                                                       {"principal_stress", {"s1", "s3"}},
                                                       {"principal_angle", {"principal_angle"}},
                                                       {"von_mises", {"von_mises"}}};

bool has(const Words& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

/// The quantities of a probe; `all` is false if a field's own are not known here.
Words quantities_of(const model::ProbeData& probe, bool& all) {
  Words words;
  for (std::string field : probe.quantities) {
    if (field.ends_with("_nodes")) field.resize(field.size() - std::string_view("_nodes").size());
    const auto known = field_quantities.find(field);
    if (known == field_quantities.end())
      all = false;
    else
      words.insert(words.end(), known->second.begin(), known->second.end());
  }
  return words;
}

class Checker {
 public:
  Checker(const Measure& measure, const Facts& facts, core::Mistakes& mistakes)
      : measure_(measure), facts_(facts), mistakes_(mistakes) {}

  void check() {
    if (!measure_.stage.empty()) need("stage", measure_.stage, facts_.stages);
    if (!measure_.probe.empty()) check_probe("probe", measure_.probe);
    if (!measure_.minus.empty()) check_probe("minus", measure_.minus);
    if (!measure_.at.empty()) check_path();
    if (measure_.joint.empty() || !need("joint", measure_.joint, facts_.joints)) return;
    if (!has(joint_quantities, measure_.quantity))
      lacks("quantity", "a joint has no '" + measure_.quantity + "'",
            core::did_you_mean(measure_.quantity, joint_quantities));
  }

 private:
  void lacks(const std::string& key, const std::string& what, const std::string& advice) {
    mistakes_.add(measure_.settings.place_of(key), "the measure '" + measure_.name + "' is missing: " + what,
                  advice);
  }

  bool need(const std::string& key, const std::string& word, const Words& known) {
    if (has(known, word)) return true;
    const std::string kind = key == "minus" ? "probe" : key == "at" ? "stage" : key;
    lacks(key, "the scene has no " + kind + " '" + word + "'",
          known.empty() ? "it has no " + kind + "s at all" : core::did_you_mean(word, known));
    return false;
  }

  void check_probe(const std::string& key, const std::string& name) {
    Words names;
    for (const model::ProbeData& probe : facts_.probes) names.push_back(probe.name);
    if (!need(key, name, names)) return;
    const auto probe = std::ranges::find(facts_.probes, name, &model::ProbeData::name);
    bool all = true;
    const Words known = quantities_of(*probe, all);
    if (!all || has(known, measure_.quantity)) return;
    lacks("quantity", "the probe '" + name + "' reads no '" + measure_.quantity + "'",
          core::did_you_mean(measure_.quantity, known) + "; the scene says which fields a probe reads");
  }

  void check_path() {
    const std::string begin = "stages.";
    if (!measure_.at.starts_with(begin)) return;
    const std::string rest = measure_.at.substr(begin.size());
    for (const std::string& stage : facts_.stages)
      if (rest.starts_with(stage + ".")) return;
    need("at", rest.substr(0, rest.find('.')), facts_.stages);
  }

  const Measure& measure_;
  const Facts& facts_;
  core::Mistakes& mistakes_;
};

}  // namespace

Facts facts_of(const model::Scene& scene) {
  Facts facts;
  for (const model::StageData& stage : scene.stages) facts.stages.push_back(stage.name);
  for (const model::JointData& joint : scene.joints) facts.joints.push_back(joint.line.name);
  facts.probes = scene.probes;
  return facts;
}

void check_measures(const Study& study, const Facts& facts, core::Mistakes& mistakes) {
  for (const Measure& measure : study.measures) Checker(measure, facts, mistakes).check();
}

std::string unit_of(const Measure& measure) {
  if (!measure.cost.empty()) return measure.cost == "iterations" ? "" : "s";
  const auto among = [&](std::initializer_list<const char*> words) {
    return std::ranges::any_of(words, [&](const char* word) { return measure.quantity == word; });
  };
  if (among({"ux", "uy", "u", "max_slip", "max_opening", "max_penetration"})) return "m";
  if (among({"sxx", "syy", "sxy", "szz", "s1", "s3", "von_mises", "max_pressure"})) return "Pa";
  return measure.quantity == "normal_force" ? "N" : "";
}

}  // namespace ashlar::study
