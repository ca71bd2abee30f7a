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

// Upper block of one cell, lifted or pressed by hand: g = ∓1 mm, k = 100 E'/2 m, each point stands for 1 m.
TEST(contact_term, one_pressed_point_by_hand) {
  const Blocks blocks = two_blocks(1, 1, 0.5);
  const ContactTerm term = paper_contact(blocks.model, 100);
  fields::State state = state_for(blocks.model, term);
  std::vector<double> u(blocks.model.dofs.size());
  const ContactPoint& first = term.joints()[0].points[0];
  const ContactPoint& second = term.joints()[0].points[1];
  ASSERT_EQ(first.shares.size(), 2u);
  const Index slave = first.shares[0].point, master = first.shares[1].point;
  u[2 * slave + 1] = -1e-3;
  u[2 * second.shares[0].point + 1] = 2e-3;
  EXPECT_EQ(term.update_status(state, touched(term, u)), 1) << "joints begin closed, one point opens";
  EXPECT_EQ(term.status(state), (std::vector<std::int8_t>{1, 0}));
  const double k = 100 * plane_modulus / 2;
  const Local local = local_at(blocks.model, term, state, u);
  EXPECT_NEAR(local.force[2 * slave + 1], -k * 1e-3 * 1 * 0.5, 1e-9 * k);
  EXPECT_NEAR(local.force[2 * master + 1], k * 1e-3 * 1 * 0.5, 1e-9 * k);
  EXPECT_EQ(local.force[2 * second.shares[0].point + 1], 0) << "an open point carries nothing";
  const auto facts = term.facts(state, touched(term, u));
  EXPECT_EQ(facts[0], (std::pair<std::string, double>{"closed", 1}));
  EXPECT_EQ(facts[1], (std::pair<std::string, double>{"open", 1}));
  EXPECT_DOUBLE_EQ(facts[2].second, 1e-3 / 2);
  EXPECT_DOUBLE_EQ(facts[3].second, k * 1e-3);
  EXPECT_EQ(term.point_name(1), "bed at (2, 1)");
}

// K_c = ω H(−g) Aᵀ n nᵀ A with A(ξ) u = u_s − (1−ξ) u_m − ξ u_{m+1}, written out in full.
TEST(contact_term, the_tangent_is_the_papers) {
  const Blocks blocks = two_blocks(4, 3, 0.7, 0.4);  // master edges of 0.5 m
  const ContactTerm term = paper_contact(blocks.model, 1000);
  fields::State state = state_for(blocks.model, term);
  const std::vector<double> zero(blocks.model.dofs.size());
  const Local local = local_at(blocks.model, term, state, zero);
  Eigen::MatrixXd expected = Eigen::MatrixXd::Zero(zero.size(), zero.size());
  const mesh::JointLips& lips = blocks.model.mesh.joints[0];
  const auto at = [&](Index p) { return blocks.model.mesh.points[p]; };
  const double h = 2.0 / 3;
  for (int i = 0; i < 4; ++i) {
    const Index s = i < 3 ? lips.lips[0][i].from : lips.lips[0][2].to;
    const mesh::LipEdge& edge = lips.lips[1][i];
    const double xi = (i * h - 0.5 * i) / 0.5;
    const Eigen::Vector2d n(-std::sin(0.4), std::cos(0.4));
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(2, expected.rows());
    a.block<2, 2>(0, 2 * s) = Eigen::Matrix2d::Identity();
    a.block<2, 2>(0, 2 * edge.from) = -(1 - xi) * Eigen::Matrix2d::Identity();
    a.block<2, 2>(0, 2 * edge.to) = -xi * Eigen::Matrix2d::Identity();
    const double omega = 1000 * plane_modulus / h * (i % 3 == 0 ? h / 2 : h) * 0.7;
    expected += omega * a.transpose() * n * n.transpose() * a;
    EXPECT_NEAR(at(s).x, i * h * std::cos(0.4) - std::sin(0.4), 1e-15);
  }
  EXPECT_LT((local.tangent - expected).norm(), 1e-12 * expected.norm());
}

/// A friction that depends on everything, to test the tangential part of the term.
class Sticky : public Friction {
 public:
  Shear shear(double slip, double pressure) const override {
    return {slip * (2e9 + 0.3 * pressure), 2e9 + 0.3 * pressure, 0.3 * slip};
  }
};

// Central differences of c(u) for a fixed status: c is quadratic in u at most, so only round-off is left.
TEST(contact_term, the_tangent_is_the_derivative_of_the_force) {
  for (const bool sticky : {false, true}) {
    const Blocks blocks = two_blocks(3, 4, 0.7, 0.4);
    std::vector<JointContact> joints = paper_contact(blocks.model, 50).joints();
    if (sticky) joints[0].friction = std::make_shared<Sticky>();
    const ContactTerm term(blocks.model, joints);
    fields::State state = state_for(blocks.model, term);
    std::vector<double> u = some_displacement(blocks.model);
    term.update_status(state, touched(term, u));
    const auto status = term.status(state);
    EXPECT_TRUE(std::count(status.begin(), status.end(), 1) > 0 &&
                std::count(status.begin(), status.end(), 0) > 0);
    const Local local = local_at(blocks.model, term, state, u);
    const double step = 1e-4;
    for (const Index dof : term.touched()) {
      const double before = u[dof];
      u[dof] = before + step;
      const Eigen::VectorXd up = local_at(blocks.model, term, state, u).force;
      u[dof] = before - step;
      const Eigen::VectorXd down = local_at(blocks.model, term, state, u).force;
      u[dof] = before;
      EXPECT_LT(((up - down) / (2 * step) - local.tangent.col(dof)).norm(), 1e-9 * local.tangent.norm());
    }
  }
}

TEST(contact_term, action_is_reaction_on_one_line) {
  const Blocks blocks = two_blocks(3, 5, 0.7, 0.9);
  std::vector<JointContact> joints = paper_contact(blocks.model, 50).joints();
  for (const bool sticky : {false, true}) {
    if (sticky) joints[0].friction = std::make_shared<Sticky>();
    const ContactTerm term(blocks.model, joints);
    const fields::State state = state_for(blocks.model, term);
    const Eigen::VectorXd force = local_at(blocks.model, term, state, some_displacement(blocks.model)).force;
    const auto sum = resultant(blocks.model, {force.data(), static_cast<std::size_t>(force.size())});
    EXPECT_LT(std::hypot(sum.x, sum.y), 1e-14 * force.lpNorm<1>());
    EXPECT_LT(std::abs(sum.moment), 3e-14 * force.lpNorm<1>());
  }
}

// Slave and master exchanged: the same opening and slip of matching lips, with the same signs.
TEST(contact_term, opening_and_slip_do_not_depend_on_the_slave) {
  const Blocks blocks = two_blocks(2, 2);
  for (const int slave : {0, 1}) {
    const ContactTerm term = paper_contact(blocks.model, 100, slave);
    fields::State state = state_for(blocks.model, term);
    const std::span<double> u = state.trial(0);
    for (const auto& edge : blocks.model.mesh.joints[0].lips[0])
      for (const Index point : {edge.from, edge.to}) {
        u[2 * point] = 2e-3;
        u[2 * point + 1] = edge.s_from == 0 && point == edge.from ? 1e-3 : -1e-6;
      }
    term.update_status(state, touched(term, u));
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
    EXPECT_NEAR(bed.resultant.y, 1.5 * p, 1e-9 * p) << "the lower block pushes the first lip's up";
    EXPECT_NEAR(bed.resultant.moment, (1 * 1 + 2 * 0.5) * p, 1e-9 * p);
    EXPECT_NEAR(bed.penetration_over_h, 1e-6, 1e-15);
    EXPECT_EQ(bed.closed, 2);
    EXPECT_EQ(bed.points, 3);
    EXPECT_DOUBLE_EQ(bed.max_slip, 2e-3);
  }
}

// Rigid motion of the whole leaves gaps of round-off only: no point may open.
TEST(contact_term, touching_points_do_not_open_by_round_off) {
  const Blocks blocks = two_blocks(7, 7, 1, 0.3);
  const ContactTerm term = paper_contact(blocks.model, 100);
  fields::State state = state_for(blocks.model, term);
  std::vector<double> u(blocks.model.dofs.size());
  for (Index p = 0; p < blocks.model.mesh.point_count(); ++p) {
    const Point at = blocks.model.mesh.points[p];
    u[2 * p] = 0.013 - 0.0037 * at.y * (1 + 1e-15 * (p % 5));
    u[2 * p + 1] = 0.07 + 0.0037 * at.x * (1 - 2e-15 * (p % 3));
  }
  EXPECT_EQ(term.update_status(state, touched(term, u)), 0);
}

}  // namespace
}  // namespace ashlar::contact
