#pragma once
// The contact term: forces between the lips of all joints, as a local term of the stage. README.md has the
// equations.

#include "contact/parts.hpp"
#include "model/results.hpp"

namespace ashlar::contact {

/// One joint with its parts and points.
struct JointContact {
  std::string name;
  int slave = 0;  ///< lip whose points carry the contact
  std::shared_ptr<const NormalLaw> law;
  std::shared_ptr<const Enforcement> enforcement;
  std::shared_ptr<const Friction> friction;
  std::vector<ContactPoint> points;
};

/// All joints of a scene: where they cross they share mesh points. The status of a point is 1 (closed) or 0
/// (open); joints begin closed. It is kept in the state as "contact.JOINT.open", one number a point.
class ContactTerm final : public model::LocalTerm {
 public:
  /// Keeps a reference to the model.
  ContactTerm(const model::Model& model, std::vector<JointContact> joints);

  void add_state(fields::State& state) const;
  std::size_t bytes() const override;
  std::span<const Index> touched() const override { return touched_; }
  void add_local(const fields::State& state, std::span<const double> u, Eigen::Ref<Eigen::VectorXd> force,
                 Eigen::Ref<Eigen::MatrixXd> tangent) const override;
  int update_status(fields::State& state, std::span<const double> u) const override;
  std::vector<std::int8_t> status(const fields::State& state) const override;
  std::string point_name(std::size_t point) const override;
  /// "closed", "open" (points), "penetration/h", "pressure" (the greatest [Pa]).
  std::vector<std::pair<std::string, double>> facts(const fields::State& state,
                                                    std::span<const double> u) const override;
  void add_results(const fields::State& state, model::StageResult& result) const override;

  const std::vector<JointContact>& joints() const { return joints_; }

 private:
  struct Motion {
    double gap = 0, slip = 0;  ///< [m]
  };
  /// Gap and slip of a point at the touched displacements.
  Motion motion(std::size_t joint, std::size_t point, std::span<const double> u) const;
  void add_point(std::size_t joint, std::size_t point, std::span<const double> u,
                 Eigen::Ref<Eigen::VectorXd> force, Eigen::Ref<Eigen::MatrixXd> tangent) const;
  model::JointResult joint_result(std::size_t joint, std::span<const double> open,
                                  std::span<const double> u) const;
  void add_row(std::size_t joint, std::size_t point, bool closed, std::span<const double> u,
               model::JointResult& result) const;
  std::span<const double> open(const fields::State& state, std::size_t joint) const;

  const model::Model& model_;
  std::vector<JointContact> joints_;
  std::vector<Index> touched_;
  /// By joint and point: the place in `touched_` of the first dof of each share.
  std::vector<std::vector<std::vector<Index>>> local_;
};

}  // namespace ashlar::contact
