#include "solve/march.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "toy.hpp"

using toy::World;

namespace {

// Dofs of the square: point 2 is the upper right corner.
constexpr toy::Index x2 = 4, y2 = 5, x3 = 6, y3 = 7;

/// Two stages on a fixed bottom edge: a push of 10 N, then of 30 N at the upper right corner.
World pushed_square() {
  World world;
  for (const auto* name : {"first", "second"}) {
    auto& stage = world.stage(name, static_cast<int>(world.scene.stages.size()) - 1);
    stage.supports = {World::hold("square.bottom", 0, 0)};
  }
  return world;
}

}  // namespace

TEST(March, SolvesEachStageAndFactorsOnce) {
  World world = pushed_square();
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, context.stage.name == "first" ? 10 : 30));
  });
  const auto result = world.run();
  ASSERT_TRUE(result.converged);
  EXPECT_EQ(world.solvers_made, 1);
  EXPECT_TRUE(result.stages[0].factored);
  EXPECT_FALSE(result.stages[1].factored);
  // The upper four dofs in closed form: K u = f with the bottom held.
  const Eigen::Matrix4d k = world.springs->matrix().bottomRightCorner<4, 4>();
  const Eigen::Vector4d u = k.llt().solve(Eigen::Vector4d(10, 0, 0, 0));
  EXPECT_NEAR(World::u(result, 0, x2), u[0], 1e-14 * u.norm());
  EXPECT_NEAR(World::u(result, 1, x2), 3 * u[0], 1e-14 * u.norm());
  EXPECT_LT(result.stages[1].balance.relative_error, 1e-14);
  EXPECT_NEAR(result.stages[1].balance.reaction.x, -30, 1e-12);
  // Moment of the push about the origin: −y f.
  EXPECT_NEAR(result.stages[1].balance.load.moment, -30, 1e-12);
}

// The second stage starts from the balance of the first, the joint's force included, and asks only what
// changed.
TEST(March, GoesOnFromABalanceWithAJoint) {
  World world = pushed_square();
  std::shared_ptr<toy::Stop> stop;
  constexpr double stiffness = 1e6;
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, context.stage.name == "first" ? 10 : 30));
    if (!stop)
      stop = std::make_shared<toy::Stop>(context.state, y2, stiffness, [](double, bool) { return true; });
    terms.local.push_back(stop);
  });
  const auto result = world.run();
  ASSERT_TRUE(result.converged);
  EXPECT_FALSE(result.stages[1].factored);
  Eigen::Matrix4d k = world.springs->matrix().bottomRightCorner<4, 4>();
  k(y2 - 4, y2 - 4) += stiffness;
  const Eigen::Vector4d u = k.llt().solve(Eigen::Vector4d(10, 0, 0, 0));
  for (const toy::Index dof : {x2, y2, x3, y3}) {
    EXPECT_NEAR(World::u(result, 0, dof), u[dof - 4], 1e-13 * u.norm());
    EXPECT_NEAR(World::u(result, 1, dof), 3 * u[dof - 4], 1e-13 * u.norm());
  }
  EXPECT_EQ(world.springs->evaluations, 3)
      << "before and after the first solve, after the second: none refined";
}

TEST(March, TakesAllLoadOffAgain) {
  World world = pushed_square();
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    if (context.stage.name == "first") terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
  });
  const auto result = world.run();
  ASSERT_TRUE(result.converged) << result.stages.back().reason;
  EXPECT_LT(std::abs(World::u(result, 1, x2)), 1e-14 * std::abs(World::u(result, 0, x2)));
  EXPECT_LT(result.stages[1].backward_error, 1e-14);
  EXPECT_LT(result.stages[1].balance.relative_error, 1e-8);
  EXPECT_LT(result.stages[0].forward_error, 1e-13);
}

TEST(March, RefusesWhatRoundOffSpoils) {
  for (const double stiffness : {1e6, 1e14}) {
    World world;
    world.stage("push", -1).supports = {World::hold("square.bottom", 0, 0)};
    world.springs = std::make_shared<toy::Springs>(world.model, 1);
    const auto link = std::make_shared<toy::Link>(x2, x3, stiffness);
    world.contribute([&](const auto&, auto& terms) {
      terms.stiffness = {world.springs, link};
      terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
    });
    const auto result = world.run();
    EXPECT_EQ(result.converged, stiffness == 1e6);
    const auto& stage = result.stages.back();
    if (result.converged) {
      EXPECT_LT(stage.forward_error, 1e-8);
      continue;
    }
    EXPECT_EQ(stage.reason.find("round-off alone changes displacements"), 0u) << stage.reason;
    EXPECT_NE(stage.reason.find(" at ("), std::string::npos) << stage.reason;
    EXPECT_NE(stage.advice.find("barely held"), std::string::npos) << stage.advice;
  }
}

TEST(March, EstimatesTheConditionWhereAsked) {
  // Of the upper four dofs' block; then with a stop on one of them, of stiffness 10.
  for (const bool stopped : {false, true})
    for (const bool asked : {false, true}) {
      World world;
      world.stage("push", -1).supports = {World::hold("square.bottom", 0, 0)};
      world.springs = std::make_shared<toy::Springs>(world.model, 1);
      ashlar::core::Settings::Entry entry;
      entry.key = "condition_estimate";
      entry.value = ashlar::core::make_value(asked);
      world.scene.root.entries.push_back(entry);
      const auto link = std::make_shared<toy::Link>(x2, x3, 1e6);
      world.contribute([&](const auto& context, auto& terms) {
        terms.stiffness = {world.springs, link};
        if (stopped)
          terms.local.push_back(
              std::make_shared<toy::Stop>(context.state, y3, 10, [](double, bool) { return true; }));
        terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
      });
      const auto result = world.run();
      ASSERT_TRUE(result.converged) << result.stages.back().reason;
      Eigen::Matrix4d k = world.springs->matrix().bottomRightCorner<4, 4>();
      k(0, 0) += 1e6, k(2, 2) += 1e6, k(0, 2) -= 1e6, k(2, 0) -= 1e6;
      if (stopped) k(3, 3) += 10;
      const auto norm = [](const Eigen::Matrix4d& a) { return a.cwiseAbs().colwise().sum().maxCoeff(); };
      const double right = norm(k) * norm(k.inverse());
      if (!asked) {
        EXPECT_EQ(result.stages[0].condition, 0);
        continue;
      }
      EXPECT_GT(result.stages[0].condition, 0.3 * right);
      EXPECT_LT(result.stages[0].condition, 1.01 * right);
    }
}

TEST(March, FactorsAgainWhenSupportsChange) {
  World world = pushed_square();
  world.scene.stages[1].supports.push_back(World::hold("square.right", 0, std::nullopt));
  world.contribute([&](const auto&, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(y3, -5));
  });
  const auto result = world.run();
  EXPECT_EQ(world.solvers_made, 2);
  EXPECT_TRUE(result.stages[1].factored);
}

TEST(March, MovesPrescribedDofs) {
  World world;
  auto& stage = world.stage("pull", -1);
  stage.supports = {World::hold("square.bottom", 0, 0), World::hold("square.top", std::nullopt, 1e-3)};
  world.contribute([&](const auto&, auto& terms) { terms.stiffness.push_back(world.springs); });
  const auto result = world.run();
  ASSERT_TRUE(result.converged);
  EXPECT_EQ(World::u(result, 0, y2), 1e-3);
  EXPECT_LT(result.stages[0].balance.relative_error, 1e-14);
  ASSERT_EQ(result.stages[0].balance.reactions.size(), 2u);
  EXPECT_NEAR(result.stages[0].balance.reactions[0].second.y, -result.stages[0].balance.reactions[1].second.y,
              1e-9);
}

TEST(March, ASupportAddedLaterHoldsWhereItFindsThePoint) {
  World world;
  world.stage("push", -1).supports = {World::fix("square.bottom")};
  world.stage("hold", 0).supports = {World::fix("square.bottom"), World::fix("square.top")};
  world.stage("unload", 1);
  world.scene.stages[2].supports = world.scene.stages[1].supports;
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    if (context.stage.name != "unload") terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
  });
  const auto result = world.run();
  ASSERT_TRUE(result.converged);
  // Nothing moves, neither when the support comes nor when the load goes: the support takes it over.
  for (const toy::Index dof : {x2, y2, y3}) {
    EXPECT_NEAR(World::u(result, 1, dof), World::u(result, 0, dof), 1e-18);
    EXPECT_NEAR(World::u(result, 2, dof), World::u(result, 0, dof), 1e-18);
  }
  EXPECT_GT(World::u(result, 0, x2), 1e-6);
  EXPECT_NEAR(result.stages[2].balance.reaction.x, 0, 1e-9);
}

TEST(March, BranchesFromANamedStage) {
  World world = pushed_square();
  auto& branch = world.stage("branch", 0);
  branch.supports = {World::hold("square.bottom", 0, 0)};
  // A latch: once it was pushed beyond 2e-5 m it stays closed. The branch must not know of the second stage.
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.local.push_back(std::make_shared<toy::Stop>(
        context.state, x2, 1e6, [](double u, bool closed) { return closed || u > 2e-5; }));
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, context.stage.name == "second" ? 90 : 10));
  });
  const auto result = world.run();
  ASSERT_TRUE(result.converged);
  EXPECT_GT(World::u(result, 1, x2), 2e-5);
  EXPECT_NEAR(World::u(result, 2, x2), World::u(result, 0, x2), 1e-15 * World::u(result, 0, x2));
}

TEST(March, ContactHoldsABodyThatNothingElseHolds) {
  World world;
  auto& stage = world.stage("rest", -1);
  stage.supports = {World::hold("square.left", 0, std::nullopt)};  // free to slide along y
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    for (const toy::Index dof : {1, 3})
      terms.local.push_back(
          std::make_shared<toy::Stop>(context.state, dof, 1e7, [](double u, bool) { return u <= 0; }));
    terms.loads.push_back(std::make_shared<toy::PointLoad>(y2, -100));
    terms.loads.push_back(std::make_shared<toy::PointLoad>(y3, -100));
  });
  // The mesh must know that a joint touches the body, else missing support is a mistake of the script.
  world.model.mesh.joints.push_back({"gap", {"left", "right"}, {{{{0, 0, 0, 1, 0, 1}}, {}}}});
  const auto result = world.run();
  ASSERT_TRUE(result.converged) << result.stages[0].reason;
  EXPECT_NEAR(World::u(result, 0, 1), -1e-5, 1e-16);
  EXPECT_NEAR(World::u(result, 0, 3), -1e-5, 1e-16);
}

TEST(March, NamesACycleAndStops) {
  World world = pushed_square();
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
    terms.local.push_back(
        std::make_shared<toy::Stop>(context.state, x2, 1e6, [](double, bool closed) { return !closed; }));
  });
  const auto result = world.run();
  EXPECT_FALSE(result.converged);
  ASSERT_EQ(result.stages.size(), 1u);
  EXPECT_NE(result.stages[0].reason.find("stop at dof 4"), std::string::npos) << result.stages[0].reason;
}

TEST(March, KeepsTheStagesBeforeTheOneThatFails) {
  World world = pushed_square();
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
    if (context.stage.name == "second")
      terms.local.push_back(
          std::make_shared<toy::Stop>(context.state, x2, 1e6, [](double, bool closed) { return !closed; }));
  });
  const auto result = world.run();
  EXPECT_FALSE(result.converged);
  ASSERT_EQ(result.stages.size(), 2u);
  EXPECT_TRUE(result.stages[0].converged);
  EXPECT_FALSE(result.stages[1].converged);
}

TEST(March, CutsTheStepWhenOnlySmallStepsSettle) {
  constexpr toy::Index x3 = 6;
  constexpr double lift = 1e-3, push = 100, spring = 4e6;
  World world;
  world.stage("lift", -1).supports = {World::hold("square.bottom", 0, 0),
                                      World::hold("square.top", std::nullopt, lift)};
  // In closed form: the upper points' motion along x under the lift, the push and the spring.
  const auto& k = world.springs->matrix();
  Eigen::Matrix2d stiffness;
  stiffness << k(x2, x2) + spring, k(x2, x3), k(x3, x2), k(x3, x3);
  const Eigen::Vector2d force(push - lift * (k(x2, y2) + k(x2, y3)), -lift * (k(x3, y2) + k(x3, y3)));
  const Eigen::Vector2d end = stiffness.llt().solve(force);
  // Half a stage is too far, a quarter is not.
  const double reach = 0.3 * std::abs(end[0]);
  world.contribute([&](const auto& context, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, push));
    terms.local.push_back(std::make_shared<toy::ShyStop>(context.state, x2, spring, reach));
  });
  const auto result = world.run();
  ASSERT_TRUE(result.converged) << result.stages[0].reason;
  EXPECT_EQ(result.stages[0].iterations.back().step, 4);
  EXPECT_NEAR(World::u(result, 0, x2), end[0], 1e-14 * end.norm());
  EXPECT_NEAR(World::u(result, 0, x3), end[1], 1e-14 * end.norm());
  EXPECT_EQ(World::u(result, 0, y2), lift);
}

TEST(March, SaysWhatCanMoveWhereNothingHolds) {
  World world;
  auto& stage = world.stage("loose", -1);
  stage.supports = {World::hold("square.bottom", std::nullopt, 0)};
  world.contribute([&](const auto&, auto& terms) { terms.stiffness.push_back(world.springs); });
  try {
    world.run();
    FAIL() << "a sliding body was solved";
  } catch (const ashlar::core::InputError& error) {
    ASSERT_EQ(error.mistakes().size(), 1u);
    EXPECT_NE(error.mistakes()[0].what.find("slide in x"), std::string::npos) << error.mistakes()[0].what;
    EXPECT_EQ(error.mistakes()[0].what.find("rotate"), std::string::npos) << error.mistakes()[0].what;
  }
}

TEST(March, APointFixedWhereItIsCannotBeHeldElsewhere) {
  World world;
  world.stage("push", -1).supports = {World::fix("square.bottom")};
  world.stage("clash", 0).supports = {World::fix("square.bottom"), World::fix("square.top"),
                                      World::hold("square.right", 0, std::nullopt)};
  world.contribute([&](const auto&, auto& terms) {
    terms.stiffness.push_back(world.springs);
    terms.loads.push_back(std::make_shared<toy::PointLoad>(x2, 10));
  });
  const auto result = world.run();
  EXPECT_FALSE(result.converged);
  ASSERT_EQ(result.stages.size(), 2u);
  EXPECT_NE(result.stages[1].reason.find("is fixed where it is, displaced by"), std::string::npos)
      << result.stages[1].reason;
}

TEST(March, ReportsAMissingEdgeAndAClash) {
  World world;
  auto& stage = world.stage("bad", -1);
  stage.supports = {World::hold("square.botom", 0, 0), World::hold("square.bottom", 0, 0),
                    World::hold("square.left", 1e-3, std::nullopt)};
  world.contribute([&](const auto&, auto& terms) { terms.stiffness.push_back(world.springs); });
  try {
    world.run();
    FAIL();
  } catch (const ashlar::core::InputError& error) {
    ASSERT_EQ(error.mistakes().size(), 2u);
    EXPECT_NE(error.mistakes()[0].advice.find("square.bottom"), std::string::npos);
    EXPECT_NE(error.mistakes()[1].what.find("two different displacements"), std::string::npos);
  }
}
