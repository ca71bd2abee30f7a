// The contact force, its tangent and its results, point by point.

#include <gtest/gtest.h>

#include "modules/contact/blocks.hpp"

namespace ashlar::contact {
namespace {

using namespace ashlar::test;

/// Reproducible displacements of about 1 mm.
std::vector<double> some_displacement(const model::Model& model) {
  std::vector<double> u(model.dofs.size());
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 1e-3 * std::sin(1.7 * static_cast<double>(i * i) + 0.3);
  return u;
}

/// Puts the points into the statuses that these displacements call for, with tractions that fit.
std::vector<double> unknowns_for(const ContactTerm& term, fields::State& state, std::span<const double> u) {
  std::vector<double> unknown(term.jumps().size());
  const std::vector<double> jump = jumps_at(term, u);
  term.begin(state, jump, unknown);
  const double k = 100 * plane_modulus / term.joints()[0].points[0].h;
  for (std::size_t p = 0; p < term.joints()[0].points.size(); ++p) {
    unknown[2 * p] = -k * jump[2 * p];
    unknown[2 * p + 1] = jump[2 * p + 1];
  }
  term.update_status(state, {}, unknown);
  term.settle(state, unknown);
  return unknown;
}

// Upper block of one cell, lifted or pressed by hand: g = ∓1 mm, k = 100 E'/2 m, each point stands for 1 m.
TEST(contact_term, one_pressed_point_by_hand) {
  const Blocks blocks = two_blocks(1, 1, 0.5);
  ContactTerm term = paper_contact(blocks.model, 100);
  fields::State state = state_for(blocks.model, term);
  std::vector<double> u(blocks.model.dofs.size());
  const ContactPoint& first = term.joints()[0].points[0];
  const ContactPoint& second = term.joints()[0].points[1];
  ASSERT_EQ(first.shares.size(), 2u);
  const Index slave = first.shares[0].dof, master = first.shares[1].dof;
  u[slave + 1] = -1e-3;
  u[second.shares[0].dof + 1] = 2e-3;
  const std::vector<double> unknown = unknowns_for(term, state, u);
  EXPECT_EQ(term.status(state)[1], 0) << "joints begin closed, one point opens";
  EXPECT_NE(term.status(state)[0], 0);
  const double k = 100 * plane_modulus / 2;
  const Eigen::VectorXd force = force_of(blocks.model, term, state);
  EXPECT_NEAR(force[slave + 1], -k * 1e-3 * 1 * 0.5, 1e-9 * k);
  EXPECT_NEAR(force[master + 1], k * 1e-3 * 1 * 0.5, 1e-9 * k);
  EXPECT_EQ(force[second.shares[0].dof + 1], 0) << "an open point carries nothing";
  const auto facts = term.facts(state, unknown);
  EXPECT_EQ(facts[0], (std::pair<std::string, double>{"open", 1}));
  EXPECT_EQ(facts[1], (std::pair<std::string, double>{"closed", 1}));
  EXPECT_DOUBLE_EQ(facts[2].second, 1e-3 / 2);
  EXPECT_DOUBLE_EQ(facts[3].second, k * 1e-3);
  EXPECT_EQ(term.point_name(1), "bed at (2, 1)");
}

// n·A and s·A with A(ξ) u = u_s − (1−ξ) u_m − ξ u_{m+1}, written out in full.
TEST(contact_term, jumps_are_the_papers) {
  const Blocks blocks = two_blocks(4, 3, 0.7, 0.4);  // master edges of 0.5 m
  ContactTerm term = paper_contact(blocks.model, 1000);
  const std::vector<double> u = some_displacement(blocks.model);
  const std::vector<double> jump = jumps_at(term, u);
  const mesh::JointLips& lips = blocks.model.mesh.joints[0];
  const double h = 2.0 / 3;
  for (int i = 0; i < 4; ++i) {
    const Index s = i < 3 ? lips.lips[0][i].from : lips.lips[0][2].to;
    const mesh::LipEdge& edge = lips.lips[1][i];
    const double xi = (i * h - 0.5 * i) / 0.5;
    const auto at = [&](Index p) { return Eigen::Vector2d(u[2 * p], u[2 * p + 1]); };
    const Eigen::Vector2d a = at(s) - (1 - xi) * at(edge.from) - xi * at(edge.to);
    EXPECT_NEAR(jump[2 * i], Eigen::Vector2d(-std::sin(0.4), std::cos(0.4)).dot(a), 1e-17);
    EXPECT_NEAR(jump[2 * i + 1], Eigen::Vector2d(std::cos(0.4), std::sin(0.4)).dot(a), 1e-17);
    EXPECT_NEAR(term.jumps().area[2 * i], (i % 3 == 0 ? h / 2 : h) * 0.7, 1e-15);
  }
}

TEST(contact_term, action_is_reaction_on_one_line) {
  const Blocks blocks = two_blocks(3, 5, 0.7, 0.9);
  ContactTerm term = paper_contact(blocks.model, 50);
  fields::State state = state_for(blocks.model, term);
  unknowns_for(term, state, some_displacement(blocks.model));
  const Eigen::VectorXd force = force_of(blocks.model, term, state);
  EXPECT_GT(force.lpNorm<1>(), 0);
  const auto sum = resultant(blocks.model, {force.data(), static_cast<std::size_t>(force.size())});
  EXPECT_LT(std::hypot(sum.x, sum.y), 1e-14 * force.lpNorm<1>());
  EXPECT_LT(std::abs(sum.moment), 3e-14 * force.lpNorm<1>());
}

// Slave and master exchanged: the same opening and slip of matching lips, with the same signs.
TEST(contact_term, opening_and_slip_do_not_depend_on_the_slave) {
  const Blocks blocks = two_blocks(2, 2);
  for (const int slave : {0, 1}) {
    ContactTerm term = paper_contact(blocks.model, 100, slave);
    fields::State state = state_for(blocks.model, term);
    const std::span<double> u = state.trial(0);
    for (const auto& edge : blocks.model.mesh.joints[0].lips[0])
      for (const Index point : {edge.from, edge.to}) {
        u[2 * point] = 2e-3;
        u[2 * point + 1] = edge.s_from == 0 && point == edge.from ? 1e-3 : -1e-6;
      }
    unknowns_for(term, state, u);
    state.commit();
    model::StageResult stage;
    term.add_results(state, stage);
    const model::JointResult& bed = stage.joints[0];
    ASSERT_EQ(bed.rows.size(), 3u);
    for (const auto& row : bed.rows) EXPECT_DOUBLE_EQ(row.slip, 2e-3) << "first lip forward along the path";
    EXPECT_DOUBLE_EQ(bed.rows[0].opening, 1e-3);
    EXPECT_FALSE(bed.rows[0].closed);
    EXPECT_EQ(bed.rows[0].pressure, 0);
    const double p = 100 * plane_modulus * 1e-6;
    EXPECT_NEAR(bed.rows[1].pressure, p, 1e-9 * p);
    EXPECT_NEAR(bed.normal_force, 1.5 * p, 1e-9 * p);
    EXPECT_NEAR(bed.action_s, (1 * 1 + 2 * 0.5) / 1.5, 1e-9);
    EXPECT_NEAR(bed.cracked_length, 0.5, 1e-15);
    EXPECT_NEAR(bed.resultant.y, 1.5 * p, 1e-9 * p) << "the lower block pushes the first lip's up";
    EXPECT_NEAR(bed.resultant.moment, (1 * 1 + 2 * 0.5) * p, 1e-9 * p);
    EXPECT_NEAR(bed.penetration_over_h, 1e-6, 1e-15);
    EXPECT_EQ(bed.closed, 2);
    EXPECT_EQ(bed.points, 3);
    EXPECT_DOUBLE_EQ(bed.max_slip, 2e-3);
  }
}

}  // namespace
}  // namespace ashlar::contact
