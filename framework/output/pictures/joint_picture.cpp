#include <algorithm>

#include "output/files.hpp"
#include "output/joint_columns.hpp"
#include "output/pictures/frame.hpp"
#include "output/pictures/pictures.hpp"
#include "output/pictures/profiles.hpp"
#include "output/tables.hpp"

namespace ashlar::output {

using model::JointResult;

namespace {

using Quantities = std::vector<JointColumn>;

/// Whether any stage has it at all.
bool occurs(const model::RunResult& result, const std::string& joint, const JointColumn& column) {
  for (const model::StageResult& stage : result.stages)
    for (const JointResult& each : stage.joints)
      for (const JointResult::Row& row : each.rows)
        if (each.name == joint && row.*column.value != 0) return true;
  return false;
}

// The quantities that outputs.joints names for this joint; if it names none, all but those of effects that
// the joint does not have.
Quantities chosen(const model::Scene& scene, const model::RunResult& result, const std::string& joint) {
  const core::Settings::Entry* joints = scene.outputs.find("joints");
  const core::Table* by_name = joints ? joints->value.table() : nullptr;
  const core::Value* said = by_name ? by_name->find(joint) : nullptr;
  Quantities list;
  for (const JointColumn& q : joint_columns)
    for (const core::Value& item : said && said->table() ? said->table()->items : std::vector<core::Value>())
      if (item.text() && *item.text() == q.name) list.push_back(q);
  if (!list.empty()) return list;
  for (std::size_t q = 0; q < joint_columns.size(); ++q)
    if (q < 3 || occurs(result, joint, joint_columns[q])) list.push_back(joint_columns[q]);
  return list;
}

}  // namespace

Picture joint_picture(const model::Scene& scene, const model::RunResult& result, const std::string& name) {
  const Quantities list = chosen(scene, result, name);
  Profiles profiles;
  profiles.s_label = "distance along the joint *s* [m]";
  for (const JointColumn& quantity : list) {
    std::string words = quantity.name;
    std::ranges::replace(words, '_', ' ');
    profiles.quantities.push_back({words, quantity.unit});
  }
  for (const model::StageResult& stage : result.stages)
    for (const JointResult& joint : stage.joints) {
      if (joint.name != name || joint.rows.empty()) continue;
      ProfileCurve& curve = profiles.curves.emplace_back(ProfileCurve{stage.name, {}, {}, {}});
      for (const JointResult::Row& row : rows_and_tips(joint)) {
        ProfileRow& drawn = curve.rows.emplace_back(ProfileRow{row.s, row.piece, false, {}});
        for (const JointColumn& quantity : list) drawn.values.push_back(row.*quantity.value);
      }
    }
  if (profiles.curves.empty()) return {};
  color_curves(profiles.curves);
  return {"joint_" + file_name(name), page_height(profiles), [&scene, name, profiles](Canvas& canvas) {
            draw_title(canvas, "Joint " + name, scene.title);
            draw_profiles(canvas, profiles);
          }};
}

}  // namespace ashlar::output
