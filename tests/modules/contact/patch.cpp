// Two elastic blocks pressed on each other: what the method gets right, and by how much it fails.

#include <gtest/gtest.h>

#include "modules/contact/blocks.hpp"

namespace ashlar::contact {
namespace {

using namespace ashlar::test;

model::JointResult results_of(const ContactTerm& term, const fields::State& state) {
  model::StageResult stage;
  term.add_results(state, stage);
  return stage.joints.at(0);
}

/// Largest error of the pressure along the bed under a uniform pressure of 1 MPa, relative.
double patch_error(int lower, int upper, int slave, Weight weight = Weight::tributary) {
  const Blocks blocks = two_blocks(lower, upper, 0.8);
  const auto term = std::make_shared<ContactTerm>(paper_contact(blocks.model, 100, slave, weight));
  fields::State state = state_for(blocks.model, *term);
  EXPECT_GT(settle(blocks, term, pressure_on_top(blocks, 1e6), 2 * blocks.top[0], state), 0);
  double worst = 0;
  for (const auto& row : results_of(*term, state).rows)
    worst = std::max(worst, std::abs(row.pressure / 1e6 - 1));
  return worst;
}

// Uniform pressure on matching lips is exact; the penalty's own error is the penetration p h / (factor E').
TEST(contact_patch, matching_lips_pass_a_uniform_pressure_exactly) {
  for (const int slave : {0, 1}) EXPECT_LT(patch_error(6, 6, slave), 1e-10);
  const Blocks blocks = two_blocks(4, 4);
  for (const double factor : {10.0, 1e2, 1e4}) {
    const auto term = std::make_shared<ContactTerm>(paper_contact(blocks.model, factor));
    fields::State state = state_for(blocks.model, *term);
    EXPECT_EQ(settle(blocks, term, pressure_on_top(blocks, 1e6), 2 * blocks.top[0], state), 1);
    const model::JointResult bed = results_of(*term, state);
    EXPECT_NEAR(bed.normal_force, 2e6, 1e-8 * 2e6);
    EXPECT_NEAR(bed.penetration_over_h * factor * plane_modulus / 1e6, 1, 1e-8);
    // The top sinks by p (2 m) / E' and by the penetration.
    const double sinks = -state.committed(0)[2 * blocks.top[0] + 1];
    EXPECT_NEAR(sinks, 1e6 / plane_modulus * (2 + 0.5 / factor), 1e-8 * sinks);
  }
}

// The known weakness of one-pass node-to-segment: printed, so that node insertion can be compared with it.
TEST(contact_patch, lips_that_do_not_match_fail_the_patch_test) {
  const double fine_slave = patch_error(4, 6, 0), coarse_slave = patch_error(4, 6, 1);
  const double equal = patch_error(4, 6, 0, Weight::equal);
  std::printf(
      "one-pass patch test, 4 edges below and 6 above: pressure wrong by %.3f (finer lip slave), %.3f "
      "(coarser), %.3f (finer, equal weights)\n",
      fine_slave, coarse_slave, equal);
  EXPECT_GT(fine_slave, 1e-3);
  EXPECT_GT(coarse_slave, 1e-3);
  EXPECT_LT(std::max(fine_slave, coarse_slave), 0.5);
  // Equal weights make the ends of matching lips twice as stiff: wrong by some tenths of 1/factor.
  const double ends = patch_error(6, 6, 0, Weight::equal);
  EXPECT_GT(ends, 1e-4);
  EXPECT_LT(ends, 1e-2);
}

// A load beyond the middle third opens one side; it closes again when the load goes back.
TEST(contact_patch, opens_and_closes_without_a_cycle) {
  const Blocks blocks = two_blocks(12, 12);
  const auto term = std::make_shared<ContactTerm>(paper_contact(blocks.model, 100));
  fields::State state = state_for(blocks.model, *term);
  const auto load_at = [&](std::size_t first) {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(blocks.model.dofs.size());
    for (std::size_t i = first; i < first + 2; ++i) load[2 * blocks.top[i] + 1] = -5e5;
    return load;
  };
  const Index hold = 2 * blocks.top[0];
  const int to_open = settle(blocks, term, load_at(11), hold, state);
  const model::JointResult open = results_of(*term, state);
  std::printf("eccentric load: %d statuses, %d of %d points closed\n", to_open, open.closed, open.points);
  EXPECT_GT(to_open, 1);
  EXPECT_LE(to_open, 8);
  EXPECT_LT(open.closed, open.points);
  EXPECT_GT(open.max_opening, 0);
  EXPECT_NEAR(open.normal_force, 1e6, 1e-2);
  EXPECT_NEAR(open.resultant.moment, 1e6 * 23.0 / 12, 1e-1);
  const int to_close = settle(blocks, term, pressure_on_top(blocks, 1e6), hold, state);
  EXPECT_GT(to_close, 1);
  EXPECT_LE(to_close, 8);
  EXPECT_EQ(results_of(*term, state).closed, 13);
}

// The right halves of two cells above and two below share their points: the crack ends at (1, 0).
TEST(contact_results, a_welded_tip_is_told_and_its_half_edge_is_no_contact_length) {
  mesh::Mesh mesh =
      test::hand_mesh({{0, -1}, {1, -1}, {2, -1}, {0, 0}, {1, 0}, {2, 0}, {0, 0}, {0, 1}, {1, 1}, {2, 1}},
                      {{0, 1, 4, 3}, {1, 2, 5, 4}, {6, 4, 8, 7}, {4, 5, 9, 8}});
  mesh.joints.push_back({"bed", {"upper", "lower"}, {test::lip(mesh, {6, 4}), test::lip(mesh, {3, 4})}});
  const model::Model model = test::plain_model(std::move(mesh));
  ContactTerm term = test::paper_contact(model, 100, 0);
  const model::JointResult crack = results_of(term, test::state_for(model, term));
  ASSERT_EQ(crack.rows.size(), 1u);
  ASSERT_EQ(crack.tips.size(), 1u);
  EXPECT_EQ(crack.tips[0].s, 1);
  EXPECT_EQ(crack.tips[0].at.x, 1);
  EXPECT_EQ(crack.length, 1);
  EXPECT_DOUBLE_EQ(crack.contact_length, 0.5);
}

}  // namespace
}  // namespace ashlar::contact
