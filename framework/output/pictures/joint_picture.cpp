#include <algorithm>
#include <array>

#include "output/files.hpp"
#include "output/pictures/frame.hpp"
#include "output/pictures/pictures.hpp"
#include "output/pictures/profiles.hpp"
#include "output/tables.hpp"

namespace ashlar::output {

using model::JointResult;

namespace {

struct Quantity {
  const char* name;
  const char* unit;
  double JointResult::Row::*value;
};
constexpr std::array<Quantity, 3> quantities = {{{"opening", "m", &JointResult::Row::opening},
                                                 {"slip", "m", &JointResult::Row::slip},
                                                 {"pressure", "Pa", &JointResult::Row::pressure}}};

// The quantities that outputs.joints names for this joint; all if it names none.
std::vector<Quantity> chosen(const model::Scene& scene, const std::string& joint) {
  const core::Settings::Entry* joints = scene.outputs.find("joints");
  const core::Table* by_name = joints ? joints->value.table() : nullptr;
  const core::Value* said = by_name ? by_name->find(joint) : nullptr;
  std::vector<Quantity> list;
  for (const Quantity& q : quantities)
    for (const core::Value& item : said && said->table() ? said->table()->items : std::vector<core::Value>())
      if (item.text() && *item.text() == q.name) list.push_back(q);
  if (list.empty()) return {quantities.begin(), quantities.end()};
  return list;
}

}  // namespace

Picture joint_picture(const model::Scene& scene, const model::RunResult& result, const std::string& name) {
  const std::vector<Quantity> list = chosen(scene, name);
  Profiles profiles;
  profiles.s_label = "distance along the joint *s* [m]";
  for (const Quantity& quantity : list) profiles.quantities.push_back({quantity.name, quantity.unit});
  for (const model::StageResult& stage : result.stages)
    for (const JointResult& joint : stage.joints) {
      if (joint.name != name || joint.rows.empty()) continue;
      ProfileCurve& curve = profiles.curves.emplace_back(ProfileCurve{stage.name, {}, {}, {}});
      for (const JointResult::Row& row : rows_and_tips(joint)) {
        ProfileRow& drawn = curve.rows.emplace_back(ProfileRow{row.s, row.piece, false, {}});
        for (const Quantity& quantity : list) drawn.values.push_back(row.*quantity.value);
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
