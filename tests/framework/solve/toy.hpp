#pragma once
// A toy scene for the march: one quadrilateral's corner points with springs, and contact-like terms on single
// dofs.

#include "model/effect.hpp"
#include "solve/march.hpp"
#include "testing/dense_solver.hpp"

namespace toy {

using namespace ashlar;
using geometry::Index;

/// The unit square as one cell, edges named bottom, right, top, left.
inline mesh::Mesh square() {
  mesh::Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const std::array<Index, 4> ring{0, 1, 2, 3};
  mesh.cell_points.append(ring);
  mesh.cell_edges.append(ring);
  mesh.edge_points = {{0, 1}, {1, 2}, {2, 3}, {3, 0}};
  mesh.edge_cells = {{0, -1}, {0, -1}, {0, -1}, {0, -1}};
  mesh.regions = {"square"};
  mesh.cell_region = {0};
  mesh.edge_groups = {
      {"square.bottom", {0}}, {"square.right", {1}}, {"square.top", {2}}, {"square.left", {3}}};
  return mesh;
}

inline model::Model square_model() {
  model::Model model;
  model.mesh = square();
  model.dofs = fields::DofMap(model.mesh, {"displacement", "m", 2, 1, 0, 0});
  model.length = std::sqrt(2.0);
  return model;
}

/// Springs between all pairs of points, of stiffness k along their lines: rigid motions cost nothing.
class Springs : public model::Stiffness {
 public:
  Springs(const model::Model& model, double stiffness) : Stiffness("springs") {
    std::vector<Index> dofs(8);
    for (Index i = 0; i < 8; ++i) dofs[i] = i;
    groups_.append(dofs);
    matrix_.setZero();
    for (Index i = 0; i < 4; ++i)
      for (Index j = 0; j < i; ++j) {
        const geometry::Point d = model.mesh.points[i] - model.mesh.points[j];
        const double length = geometry::norm(d);
        Eigen::Matrix<double, 8, 1> b = Eigen::Matrix<double, 8, 1>::Zero();
        b[2 * i] = d.x / length, b[2 * i + 1] = d.y / length;
        b[2 * j] = -d.x / length, b[2 * j + 1] = -d.y / length;
        matrix_ += stiffness * b * b.transpose();
      }
  }
  const algebra::Adjacency& groups() const override { return groups_; }
  void add_tangent(const algebra::ScatterMap& map, std::span<double> value) const override {
    const auto where = map[0];
    for (Index i = 0, at = 0; i < 8; ++i)
      for (Index j = 0; j <= i; ++j, ++at)
        if (where[at] >= 0) value[where[at]] += matrix_(i, j);
  }
  void add_internal_force(std::span<const double> u, std::span<double> force) const override {
    ++evaluations;
    Eigen::Map<Eigen::Matrix<double, 8, 1>>(force.data()) +=
        matrix_ * Eigen::Map<const Eigen::Matrix<double, 8, 1>>(u.data());
  }
  void add_results(const fields::State& state, model::StageResult& result) const override {
    const auto u = state.committed(0);
    result.fields.push_back(
        {"displacement", "m", model::FieldResult::On::points, 2, {"x", "y"}, {u.begin(), u.end()}});
  }
  const Eigen::Matrix<double, 8, 8>& matrix() const { return matrix_; }
  mutable int evaluations = 0;  ///< of forces

 private:
  algebra::Adjacency groups_;
  Eigen::Matrix<double, 8, 8> matrix_;
};

/// A spring between two dofs.
class Link : public model::Stiffness {
 public:
  Link(Index a, Index b, double stiffness) : Stiffness("springs"), dofs_{a, b}, stiffness_(stiffness) {
    groups_.append(dofs_);
  }
  const algebra::Adjacency& groups() const override { return groups_; }
  void add_tangent(const algebra::ScatterMap& map, std::span<double> value) const override {
    const auto where = map[0];
    for (std::size_t i = 0; i < 3; ++i)
      if (where[i] >= 0) value[where[i]] += i == 1 ? -stiffness_ : stiffness_;
  }
  void add_internal_force(std::span<const double> u, std::span<double> force) const override {
    const double pull = stiffness_ * (u[dofs_[0]] - u[dofs_[1]]);
    force[dofs_[0]] += pull;
    force[dofs_[1]] -= pull;
  }
  void add_results(const fields::State&, model::StageResult&) const override {}

 private:
  algebra::Adjacency groups_;
  std::array<Index, 2> dofs_;
  double stiffness_;
};

class PointLoad : public model::Load {
 public:
  PointLoad(Index dof, double force) : Load("push"), dof_(dof), force_(force) {}
  void add_force(std::span<double> force) const override { force[dof_] += force_; }

 private:
  Index dof_;
  double force_;
};

/// A stop below one dof: force k u while closed. How it chooses its status is up to `choose`.
class Stop : public model::LocalTerm {
 public:
  using Choose = std::function<bool(double u, bool closed)>;
  Stop(fields::State& state, Index dof, double stiffness, Choose choose)
      : LocalTerm("stop"), dofs_{dof}, stiffness_(stiffness), choose_(std::move(choose)) {
    status_ = state.add("stop.status." + std::to_string(dof), 1);
    traction_ = state.add("stop.traction." + std::to_string(dof), 1);
    jumps_.width = 1;
    jumps_.parts = {{{0, 1.0}}};
    jumps_.initial = {0};
    jumps_.area = {1};
    jumps_.ground = {stiffness};
  }
  std::span<const Index> touched() const override { return dofs_; }
  const model::Jumps& jumps() const override { return jumps_; }
  void respond(const fields::State& state, std::span<const double> unknown,
               model::JumpResponse& response) const override {
    const double k = closed(state) ? stiffness_ : 0;
    response.resize(1, 1);
    response.jump[0] = unknown[0];
    response.jump_by(0, 0) = 1;
    response.traction[0] = k * unknown[0];
    response.traction_by(0, 0) = k;
  }
  void begin(const fields::State&, std::span<const double> jump, std::span<double> unknown) const override {
    unknown[0] = jump[0];
  }
  model::StatusUpdate update_status(fields::State& state, const model::StatusChange&,
                                    std::span<double> unknown) const override {
    const bool was = closed(state), now = choose_(unknown[0], was);
    state.trial(status_)[0] = now;
    return {was != now, 0};
  }
  bool stop_first(fields::State& state, std::span<const double> motion, std::span<double>) const override {
    if (closed(state) || motion[0] >= 0) return false;
    state.trial(status_)[0] = 1;
    return true;
  }
  bool settle(fields::State& state, std::span<const double> unknown) const override {
    state.trial(traction_)[0] = closed(state) ? stiffness_ * unknown[0] : 0;
    return false;
  }
  void tractions(const fields::State& state, std::span<double> traction) const override {
    traction[0] = state.trial(traction_)[0];
  }
  std::vector<std::int8_t> status(const fields::State& state) const override {
    return {static_cast<std::int8_t>(state.trial(status_)[0])};
  }
  void restore(fields::State& state, std::span<const std::int8_t> status) const override {
    state.trial(status_)[0] = status[0];
  }
  std::string point_name(std::size_t) const override { return "stop at dof " + std::to_string(dofs_[0]); }
  std::vector<std::pair<std::string, double>> facts(const fields::State&,
                                                    std::span<const double>) const override {
    return {};
  }

 protected:
  virtual bool closed(const fields::State& state) const { return state.trial(status_)[0] != 0; }

 private:
  std::array<Index, 1> dofs_;
  double stiffness_;
  Choose choose_;
  fields::State::Id status_, traction_;
  model::Jumps jumps_;
};

/// A stop that is always closed, but whose status settles only where a step moves its dof less than `reach`.
class ShyStop : public Stop {
 public:
  ShyStop(fields::State& state, Index dof, double stiffness, double reach)
      : Stop(state, dof, stiffness, {}), reach_(reach) {
    flips_ = state.add("shy.flips." + std::to_string(dof), 1);
  }
  model::StatusUpdate update_status(fields::State& state, const model::StatusChange&,
                                    std::span<double> unknown) const override {
    if (std::abs(unknown[0] - state.committed(0)[touched()[0]]) <= reach_) return {};
    state.trial(flips_)[0] = 1 - state.trial(flips_)[0];
    return {1, 0};
  }
  std::vector<std::int8_t> status(const fields::State& state) const override {
    return {static_cast<std::int8_t>(state.trial(flips_)[0])};
  }

 protected:
  bool closed(const fields::State&) const override { return true; }

 private:
  double reach_;
  fields::State::Id flips_;
};

/// An effect from a lambda.
class Made : public model::Effect {
 public:
  using Contribute = std::function<void(const model::StageContext&, model::Terms&)>;
  explicit Made(Contribute contribute) : contribute_(std::move(contribute)) {}
  void contribute(const model::StageContext& context, model::Terms& terms) override {
    contribute_(context, terms);
  }

 private:
  Contribute contribute_;
};

/// Stages that all call for the effect "toy", whose terms depend on the stage's name.
struct World {
  model::Scene scene;
  model::Plan plan;
  model::Model model = square_model();
  core::Registry registry;
  std::map<std::string, std::unique_ptr<model::Effect>> effects;
  std::shared_ptr<Springs> springs = std::make_shared<Springs>(model, 1e6);
  int solvers_made = 0;

  World() {
    scene.regions.push_back({"square", {}, {}, {}, {}});
    scene.solver.name = "dense";
    registry.add_schema({"solver", "dense", "", "", {}});
    registry.add_make("solver", "dense", std::function<algebra::MakeSolver>([this](const core::Settings&) {
                        ++solvers_made;
                        return std::make_unique<ashlar::testing::DenseSolver>();
                      }));
  }
  void contribute(Made::Contribute contribute) {
    effects["toy"] = std::make_unique<Made>(std::move(contribute));
  }
  model::StageData& stage(const std::string& name, int parent) {
    model::StageData stage;
    stage.name = name;
    stage.parent = parent;
    scene.stages.push_back(stage);
    plan.stages.push_back({name, {{"toy", "", {}, false}}});
    return scene.stages.back();
  }
  static model::SupportData hold(const std::string& edge, std::optional<double> x, std::optional<double> y) {
    model::SupportData support;
    support.name = support.edge = edge;
    if (x) support.move[0] = core::make_value(*x);
    if (y) support.move[1] = core::make_value(*y);
    return support;
  }
  /// Holds an edge's points where the stage finds them.
  static model::SupportData fix(const std::string& edge) {
    model::SupportData support;
    support.name = support.edge = edge;
    support.move = {core::Value{}, core::Value{}};
    return support;
  }
  model::RunResult run() {
    solve::Observer observer;
    return solve::march({scene, plan, model, registry, effects}, observer);
  }
  /// A displacement component of a stage's result.
  static double u(const model::RunResult& result, std::size_t stage, Index dof) {
    return result.stages.at(stage).fields.at(0).values.at(dof);
  }
};

}  // namespace toy
