// next_status() in every direction, and what remember() keeps.

#include <gtest/gtest.h>

#include "modules/contact/laws/laws.hpp"

namespace ashlar::test {
namespace {

constexpr Tolerance tolerance{1, 1e-12};

Status next(const JointLaw& law, const PointMemory& memory, Status status, const Unknowns& y,
            const Hold& hold = {}) {
  return next_status(law, memory, status, y, respond(law, hold, memory, status, y), tolerance);
}

const JointLaw rough = joint(std::make_shared<Unilateral>(), coulomb(0.5, 1e5));

TEST(status, open_lips_touch_when_they_overlap) {
  const PointMemory memory{Status::open, 0, 0, 0, 0, 2e-4, {}};
  EXPECT_EQ(next(rough, memory, Status::open, {3e-4, 0}), Status::open);
  EXPECT_EQ(next(rough, memory, Status::open, {2e-4 - 1e-13, 0}), Status::open);
  // Dilation wedges them apart: they touch at a gap above 0.
  EXPECT_EQ(next(rough, memory, Status::open, {2e-4 - 1e-10, 0}), Status::stick);
}

TEST(status, a_pull_beyond_the_strength_parts_them) {
  for (const Status status : {Status::stick, Status::slip_forward, Status::slip_backward}) {
    EXPECT_EQ(next(rough, {}, status, {-0.5, 0}), status);
    EXPECT_EQ(next(rough, {}, status, {-2, 0}), Status::open);
  }
  const JointLaw bonded = joint(std::make_shared<TensionCutOff>(5e5), coulomb(0.5, 5e5));
  EXPECT_EQ(next(bonded, {}, Status::stick, {-5e5, 0}), Status::stick);
  EXPECT_EQ(next(bonded, {}, Status::stick, {-5e5 - 2, 0}), Status::open);
  PointMemory broken;
  broken.law[0] = 1;
  EXPECT_EQ(next(bonded, broken, Status::stick, {-2, 0}), Status::open);
}

TEST(status, shear_beyond_the_strength_makes_them_slip) {
  EXPECT_EQ(next(rough, {}, Status::stick, {1e6, 6e5 + 0.5}), Status::stick);
  EXPECT_EQ(next(rough, {}, Status::stick, {1e6, 6e5 + 2}), Status::slip_forward);
  EXPECT_EQ(next(rough, {}, Status::stick, {1e6, -6e5 - 2}), Status::slip_backward);
}

TEST(status, slip_that_would_turn_back_sticks) {
  for (const Status status : {Status::slip_forward, Status::slip_backward}) {
    EXPECT_EQ(next(rough, {}, status, {1e6, 1e-3}), status);
    EXPECT_EQ(next(rough, {}, status, {1e6, -1e-13}), status);
    EXPECT_EQ(next(rough, {}, status, {1e6, -1e-10}), Status::stick);
  }
}

TEST(status, frictionless_lips_never_stick) {
  const JointLaw smooth = joint(std::make_shared<Unilateral>(), std::make_shared<Frictionless>());
  for (const Status status : {Status::stick, Status::slip_forward, Status::slip_backward}) {
    EXPECT_EQ(next(smooth, {}, status, {1e6, -1e-3}), Status::slip_forward);
    EXPECT_EQ(next(smooth, {}, status, {-2, 0}), Status::open);
  }
  EXPECT_EQ(next(smooth, {}, Status::open, {-1e-3, 0}), Status::slip_forward);
}

TEST(status, lips_of_a_traction_law_touch_as_long_as_they_pull) {
  const JointLaw tears = joint(std::make_shared<Cohesive>(Cohesive::Data{1e11, 1e6, 100}), coulomb(0.5, 1e6));
  const double end = 2e-4;
  for (const Status status : {Status::open, Status::stick}) {
    EXPECT_EQ(next(tears, {}, status, {end / 2, 0}), Status::stick);
    EXPECT_EQ(next(tears, {}, status, {end + 1e-9, 0}), Status::open);
    EXPECT_EQ(next(tears, {}, status, {-1e-6, 0}), Status::stick);
  }
  // About to close, torn: neither status is left without a reason.
  PointMemory torn;
  torn.law[0] = 2 * end;
  for (const Status status : {Status::open, Status::stick})
    EXPECT_EQ(next(tears, torn, status, {1e-13, 0}), status);
  EXPECT_EQ(next(tears, torn, Status::stick, {1e-9, 0}), Status::open);
}

TEST(remember, stick_keeps_the_rest_and_slip_moves_it) {
  Coulomb::Data data = coulomb_data(0.5, 1e5);
  data.dilation = 0.1;
  data.stiffness = 10e9;
  const JointLaw law = joint(std::make_shared<Linear>(20e9, 0), std::make_shared<Coulomb>(data));
  const PointMemory before{Status::stick, 2e6, 0, 1e-3, 4e-3, 3e-4, {}};
  const PointMemory stuck = remember(law, {}, before, Status::stick, {3e6, 4e5});
  EXPECT_EQ(stuck.pressure, 3e6);
  EXPECT_EQ(stuck.shear, 4e5);
  EXPECT_EQ(stuck.rest, before.rest);
  EXPECT_EQ(stuck.path, before.path);
  EXPECT_EQ(stuck.dilation, before.dilation);
  const PointMemory slipped = remember(law, {}, before, Status::slip_backward, {2e6, 2e-3});
  EXPECT_EQ(slipped.status, Status::slip_backward);
  EXPECT_NEAR(slipped.shear, -1.1e6, 1e-9);
  EXPECT_NEAR(slipped.rest, -1e-3, 1e-18);
  EXPECT_NEAR(slipped.path, 6e-3, 1e-18);
  EXPECT_NEAR(slipped.dilation, 5e-4, 1e-18);
  // Sticking where it stands now gives the same jump and tractions.
  const PointResponse slip = respond(law, {}, before, Status::slip_backward, {2e6, 2e-3});
  const PointResponse stick = respond(law, {}, slipped, Status::stick, {2e6, slipped.shear});
  EXPECT_NEAR((slip.jump - stick.jump).norm(), 0, 1e-17);
  // Growth below zero is round-off, and makes no path.
  EXPECT_EQ(remember(law, {}, before, Status::slip_forward, {2e6, -1e-15}).path, before.path);
}

TEST(remember, open_lips_rest_where_they_are_and_a_bond_is_broken) {
  const JointLaw bonded = joint(std::make_shared<TensionCutOff>(5e5), coulomb(0.5, 5e5));
  const PointMemory before{Status::stick, 2e6, 3e5, 1e-3, 4e-3, 3e-4, {}};
  const PointMemory open = remember(bonded, {}, before, Status::open, {5e-4, 7e-3});
  EXPECT_EQ(open.pressure, 0);
  EXPECT_FALSE(std::signbit(open.pressure));
  EXPECT_EQ(open.shear, 0);
  EXPECT_EQ(open.rest, 7e-3);
  EXPECT_EQ(open.path, 4e-3);
  EXPECT_EQ(open.dilation, 3e-4);
  EXPECT_EQ(open.law[0], 1);
  EXPECT_EQ(bonded.normal->tensile_strength(open.law), 0);
  EXPECT_EQ(remember(bonded, {}, before, Status::stick, {-4e5, 0}).law[0], 0);
}

TEST(remember, frictionless_lips_travel_no_path) {
  const JointLaw smooth = joint(std::make_shared<Unilateral>(), std::make_shared<Frictionless>());
  PointMemory memory{Status::slip_forward, 2e6, 0, 1e-3, 0, 0, {}};
  memory = remember(smooth, {}, memory, Status::slip_forward, {1e6, -4e-3});
  EXPECT_NEAR(memory.rest, -3e-3, 1e-18);
  EXPECT_EQ(memory.path, 0);
  EXPECT_EQ(memory.shear, 0);
  EXPECT_EQ(memory.pressure, 1e6);
}

TEST(remember, traction_laws_keep_their_variables_in_every_status) {
  const JointLaw tears = joint(std::make_shared<Cohesive>(Cohesive::Data{1e11, 1e6, 100}), coulomb(0.5, 1e6));
  const PointMemory torn = remember(tears, {}, {}, Status::stick, {1e-4, 0});
  EXPECT_EQ(torn.law[0], 1e-4);
  EXPECT_LT(torn.pressure, 0);
  EXPECT_EQ(remember(tears, {}, torn, Status::slip_forward, {5e-5, 0}).law[0], 1e-4);
  EXPECT_EQ(remember(tears, {}, torn, Status::open, {3e-4, 0}).law[0], 3e-4);
}

}  // namespace
}  // namespace ashlar::test
