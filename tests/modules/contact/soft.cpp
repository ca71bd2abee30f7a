// Joints of a stiffness of their own in the solver: what closes is the law, and only the rest is penetration.

#include <gtest/gtest.h>

#include "contact/enforcement/augmented_lagrange/augmented_lagrange.hpp"
#include "contact/enforcement/lagrange/lagrange.hpp"
#include "contact/friction/coulomb/coulomb.hpp"
#include "contact/normal_laws/barton_bandis/barton_bandis.hpp"
#include "contact/normal_laws/cohesive/cohesive.hpp"
#include "contact/normal_laws/linear/linear.hpp"
#include "modules/contact/blocks.hpp"

namespace ashlar::contact {
namespace {

using namespace ashlar::test;

struct Case {
  const char* name;
  std::shared_ptr<const NormalLaw> law;
  double closure;  ///< under 1 MPa [m]
};
const std::vector<Case> cases = {
    {"unilateral", std::make_shared<Unilateral>(), 0},
    {"linear", std::make_shared<Linear>(2e9, 0), 5e-4},
    {"barton_bandis", std::make_shared<BartonBandisClosure>(1e9, 1e-3), 5e-4},
    {"cohesive", std::make_shared<Cohesive>(Cohesive::Data{1e10, 1e5, 10}), 1e-4}};

std::shared_ptr<const Friction> rough(double stiffness) {
  Coulomb::Data data;
  data.friction = data.residual_friction = 0.6;
  data.stiffness = stiffness;
  return std::make_shared<Coulomb>(data);
}

TEST(soft_joints, close_as_their_law_says_whatever_the_enforcement) {
  const Blocks blocks = two_blocks(4, 4);
  const double factor = 100, rigid = 1e6 / plane_modulus * 2;
  for (const auto& [name, law, closure] : cases)
    for (const bool smooth : {true, false})
      for (const int held : {0, 1, 2}) {
        Parts parts;
        parts.law = {law, smooth ? parts.law.friction : rough(INFINITY)};
        if (held == 0) parts.enforcement = std::make_shared<Lagrange>();
        if (held == 1) parts.enforcement = std::make_shared<Penalty>(factor, 0);
        if (held == 2) parts.enforcement = std::make_shared<AugmentedLagrange>(factor, 1e6, 1e-10);
        const auto term = std::make_shared<ContactTerm>(contact_with(blocks.model, parts));
        fields::State state = state_for(blocks.model, *term);
        ASSERT_GT(settle(blocks, term, pressure_on_top(blocks, 1e6), 2 * blocks.top[0], state), 0)
            << name << held;
        model::StageResult stage;
        term->add_results(state, stage);
        const model::JointResult& bed = stage.joints.at(0);
        for (const auto& row : bed.rows) EXPECT_NEAR(row.pressure, 1e6, 1e-9 * 1e6) << name << held;
        // Only what the law keeps rigid gives way, and only to a penalty.
        const bool gives = closure == 0 && held == 1;
        const double overlap = gives ? 1e6 * 0.5 / (factor * plane_modulus) : 0;
        EXPECT_NEAR(bed.max_penetration, overlap, 1e-9 * rigid) << name << held;
        const double sinks = -state.committed(0)[2 * blocks.top[0] + 1];
        EXPECT_NEAR(sinks, rigid + closure + overlap, 1e-8 * rigid) << name << held;
      }
}

}  // namespace
}  // namespace ashlar::contact
