#pragma once
// What a joint's profile and a joint as a whole have to say: one list for tables, files and pictures.

#include <array>

#include "model/results.hpp"

namespace ashlar::output {

struct JointColumn {
  const char* name;
  const char* unit;
  double model::JointResult::Row::*value;
  bool traction;  ///< not known at welded tips
};

inline constexpr std::array<JointColumn, 6> joint_columns = {
    {{"opening", "m", &model::JointResult::Row::opening, false},
     {"slip", "m", &model::JointResult::Row::slip, false},
     {"pressure", "Pa", &model::JointResult::Row::pressure, true},
     {"shear_stress", "Pa", &model::JointResult::Row::shear, true},
     {"water_pressure", "Pa", &model::JointResult::Row::water, true},
     {"utilisation", "", &model::JointResult::Row::utilisation, true}}};

struct JointNumber {
  const char* name;
  double model::JointResult::*value;
};

inline constexpr std::array<JointNumber, 15> joint_numbers = {
    {{"normal_force", &model::JointResult::normal_force},
     {"shear_force", &model::JointResult::shear_force},
     {"strength_force", &model::JointResult::strength_force},
     {"safety", &model::JointResult::safety},
     {"action_s", &model::JointResult::action_s},
     {"cracked_length", &model::JointResult::cracked_length},
     {"max_opening", &model::JointResult::max_opening},
     {"max_slip", &model::JointResult::max_slip},
     {"max_penetration", &model::JointResult::max_penetration},
     {"penetration_over_h", &model::JointResult::penetration_over_h},
     {"max_pressure", &model::JointResult::max_pressure},
     {"max_shear", &model::JointResult::max_shear},
     {"water_force", &model::JointResult::water_force},
     {"length", &model::JointResult::length},
     {"contact_length", &model::JointResult::contact_length}}};

/// "open", "stick" or "slip".
inline const char* state_word(model::JointResult::Row::State state) {
  using State = model::JointResult::Row::State;
  return state == State::open ? "open" : state == State::stick ? "stick" : "slip";
}

}  // namespace ashlar::output
