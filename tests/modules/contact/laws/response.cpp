// respond(): its derivatives against differences, and its values by hand.

#include <gtest/gtest.h>

#include <random>

#include "modules/contact/laws/laws.hpp"

namespace ashlar::test {
namespace {

const std::vector<Status> statuses = {Status::open, Status::stick, Status::slip_forward,
                                      Status::slip_backward};
// Tractions and displacements of the size that rock joints know.
const Eigen::Vector2d scale_of_jump(1e-4, 1e-3);

class Random {
 public:
  /// From low to high, the same on every machine.
  double operator()(double low, double high) { return low + (high - low) * (engine_() / 4294967296.0); }

 private:
  std::mt19937 engine_{7};
};

PointMemory random_memory(Random& random) {
  PointMemory memory;
  memory.rest = random(-2e-3, 2e-3);
  memory.path = random(0, 8e-3);
  memory.dilation = random(0, 1e-4);
  memory.law[0] = random(0, 1) < 0.5 ? 0 : random(0, 3e-4);
  return memory;
}

Unknowns random_unknowns(Random& random, const JointLaw& law, Status status) {
  const bool opening = law.normal->form() == NormalLaw::Form::traction || status == Status::open;
  const double first = opening ? random(-2e-4, 2e-4) : random(-4e5, 4e6);
  const bool sticks = status == Status::stick && !law.friction->frictionless();
  return {first, sticks ? random(-3e6, 3e6) : random(-1e-4, 4e-3)};
}

/// The greatest difference between a derivative and central differences, over the scale of its row and
/// unknown; nothing where two steps disagree: a kink.
std::optional<double> error_of_derivatives(const JointLaw& law, const Hold& hold, const PointMemory& memory,
                                           Status status, const Unknowns& y) {
  const PointResponse here = respond(law, hold, memory, status, y);
  double worst = 0;
  for (int j = 0; j < 2; ++j) {
    const bool displacement = status == Status::open || (j == 1 && status != Status::stick) ||
                              (j == 0 && law.normal->form() == NormalLaw::Form::traction) ||
                              (j == 1 && law.friction->frictionless());
    const double size = displacement ? 1e-3 : 1e6, h = 1e-5 * size;
    const auto at = [&](double by) {
      Unknowns moved = y;
      moved[j] += by;
      return respond(law, hold, memory, status, moved);
    };
    const PointResponse right = at(h), left = at(-h), right2 = at(h / 2), left2 = at(-h / 2);
    const auto compare = [&](const auto& of, const Eigen::Matrix2d& by, double unit) {
      const Eigen::Vector2d coarse = (of(right) - of(left)) / (2 * h), fine = (of(right2) - of(left2)) / h;
      // Both one-sided slopes: a kink in the middle of a step would look smooth to central differences.
      const Eigen::Vector2d forward = (of(right) - of(here)) / h, backward = (of(here) - of(left)) / h;
      const double scale = std::max(unit / size, by.col(j).cwiseAbs().maxCoeff());
      if ((coarse - fine).cwiseAbs().maxCoeff() > 1e-4 * scale ||
          (forward - backward).cwiseAbs().maxCoeff() > 1e-3 * scale)
        return false;
      worst = std::max(worst, (fine - by.col(j)).cwiseAbs().maxCoeff() / scale);
      return true;
    };
    if (!compare([](const PointResponse& r) { return r.jump; }, here.jump_by, 1e-3) ||
        !compare([](const PointResponse& r) { return r.traction; }, here.traction_by, 1e6))
      return {};
  }
  return worst;
}

TEST(joint_law, derivatives_are_those_of_the_values) {
  Random random;
  for (const auto& [name, law] : all_laws())
    for (const Status status : statuses) {
      int checked = 0;
      constexpr int tried = 40;
      for (int i = 0; i < tried; ++i) {
        const PointMemory memory = random_memory(random);
        const Hold hold = i % 2 == 0 ? Hold{} : Hold{1e-11, 3e-11, 2e5, 1e5};
        const Unknowns y = random_unknowns(random, law, status);
        const auto error = error_of_derivatives(law, hold, memory, status, y);
        if (!error) continue;
        ++checked;
        EXPECT_LE(*error, 2e-5) << name << ", status " << static_cast<int>(status) << ", y " << y.transpose();
      }
      EXPECT_GE(checked, tried / 2) << name << ", status " << static_cast<int>(status);
    }
}

TEST(joint_law, open_lips_are_free) {
  const PointMemory memory{Status::open, 0, 0, 1e-3, 0, 2e-4, {}};
  const PointResponse r = respond(joint(std::make_shared<Unilateral>(), coulomb(0.6)), {1e-9, 1e-9, 1e6, 1e6},
                                  memory, Status::open, {3e-3, 5e-3});
  EXPECT_EQ(r.jump, Eigen::Vector2d(3e-3, 5e-3));
  EXPECT_EQ(r.traction, Eigen::Vector2d(0, 0));
  EXPECT_EQ(r.jump_by, Eigen::Matrix2d::Identity());
  EXPECT_EQ(r.traction_by, Eigen::Matrix2d::Zero());
}

TEST(joint_law, what_is_rigid_is_held_by_the_enforcement) {
  const PointMemory memory{Status::stick, 0, 0, 1e-3, 0, 2e-4, {}};
  const JointLaw law = joint(std::make_shared<Unilateral>(), coulomb(0.6));
  const PointResponse exact = respond(law, {}, memory, Status::stick, {2e6, 5e5});
  EXPECT_EQ(exact.jump, Eigen::Vector2d(2e-4, 1e-3));
  EXPECT_EQ(exact.traction, Eigen::Vector2d(-2e6, 5e5));
  // Penetration 1e-10 (2e6 − 5e5), slip 2e-10 (5e5 − 1e5)
  const PointResponse soft = respond(law, {1e-10, 2e-10, 5e5, 1e5}, memory, Status::stick, {2e6, 5e5});
  EXPECT_NEAR(soft.jump[0], 2e-4 - 1.5e-4, 1e-18);
  EXPECT_NEAR(soft.jump[1], 1e-3 + 8e-5, 1e-18);
  const Eigen::Vector2d yielded = yielding(law, {1e-10, 2e-10, 5e5, 1e5}, memory, Status::stick, {2e6, 5e5});
  EXPECT_NEAR((yielded - Eigen::Vector2d(-1.5e-4, 8e-5)).norm(), 0, 1e-18);
}

TEST(joint_law, laws_with_stiffness_need_no_enforcement) {
  const PointMemory memory{Status::stick, 0, 0, 1e-3, 0, 0, {}};
  Coulomb::Data data = coulomb_data(0.6);
  data.stiffness = 10e9;
  const JointLaw law = joint(std::make_shared<Linear>(20e9, 0), std::make_shared<Coulomb>(data));
  for (const Hold& hold : {Hold{}, Hold{1e-9, 1e-9, 7e6, 7e6}}) {
    const PointResponse r = respond(law, hold, memory, Status::stick, {2e6, 5e5});
    EXPECT_NEAR(r.jump[0], -1e-4, 1e-18);
    EXPECT_NEAR(r.jump[1], 1e-3 + 5e-5, 1e-18);
    EXPECT_EQ(yielding(law, hold, memory, Status::stick, {2e6, 5e5}), Eigen::Vector2d(0, 0));
  }
}

TEST(joint_law, slip_has_the_strength_and_dilates) {
  Coulomb::Data data = coulomb_data(0.5, 1e5);
  data.dilation = 0.1;
  data.stiffness = 10e9;
  const JointLaw law = joint(std::make_shared<Linear>(20e9, 0), std::make_shared<Coulomb>(data));
  const PointMemory memory{Status::stick, 2e6, 0, 1e-3, 4e-3, 3e-4, {}};
  const PointResponse r = respond(law, {}, memory, Status::slip_backward, {2e6, 2e-3});
  EXPECT_NEAR(r.traction[1], -1.1e6, 1e-9);
  EXPECT_NEAR(r.jump[1], 1e-3 - 2e-3 - 1.1e-4, 1e-17);
  EXPECT_NEAR(r.jump[0], -1e-4 + 3e-4 + 2e-4, 1e-17);
  EXPECT_EQ(respond(law, {}, memory, Status::slip_forward, {2e6, 2e-3}).traction[1], -r.traction[1]);
}

TEST(joint_law, frictionless_lips_slide_both_ways) {
  const JointLaw law = joint(std::make_shared<Unilateral>(), std::make_shared<Frictionless>());
  const PointMemory memory{Status::slip_forward, 2e6, 0, 1e-3, 0, 0, {}};
  for (const double growth : {-5e-3, 5e-3}) {
    const PointResponse r = respond(law, {}, memory, Status::slip_forward, {2e6, growth});
    EXPECT_EQ(r.traction, Eigen::Vector2d(-2e6, 0));
    EXPECT_EQ(r.jump, Eigen::Vector2d(0, 1e-3 + growth));
  }
}

TEST(joint_law, unknowns_to_begin_with_give_what_is_at_hand) {
  const PointMemory memory{Status::stick, 2e6, 5e5, 1e-3, 0, 2e-4, {}};
  const Eigen::Vector2d jump(1.5e-4, 2e-3);
  const JointLaw rigid = joint(std::make_shared<Unilateral>(), coulomb(0.6));
  EXPECT_EQ(begin_with(rigid, Status::open, memory, jump), jump);
  EXPECT_EQ(begin_with(rigid, Status::stick, memory, jump), Unknowns(2e6, 5e5));
  EXPECT_EQ(begin_with(rigid, Status::slip_forward, memory, jump), Unknowns(2e6, 0));
  const JointLaw smooth = joint(std::make_shared<Unilateral>(), std::make_shared<Frictionless>());
  EXPECT_EQ(begin_with(smooth, Status::slip_forward, memory, jump), Unknowns(2e6, 1e-3));
  const JointLaw tears = joint(std::make_shared<Cohesive>(Cohesive::Data{1e11, 1e6, 100}), coulomb(0.6));
  for (const Status status : statuses) {
    const Unknowns y = begin_with(tears, status, memory, jump);
    EXPECT_NEAR(respond(tears, {}, memory, status, y).jump[0], jump[0], 1e-18);
  }
}

}  // namespace
}  // namespace ashlar::test
