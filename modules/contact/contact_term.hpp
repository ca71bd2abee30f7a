#pragma once
// The contact term: forces between the lips of all joints, as a local term of the stage. README.md has the
// equations.

#include <map>

#include "contact/parts.hpp"
#include "model/results.hpp"

namespace ashlar::contact {

/// One joint with its parts and points.
struct JointContact {
  std::string name;
  JointLaw law;
  std::shared_ptr<const Enforcement> enforcement;
  std::vector<ContactPoint> points;
  /// If the lips move far along each other: what pairs them anew before each step.
  std::shared_ptr<const Pairing> follow = {};
};

/// A joint whose points are paired anew: one contact point a slave node at all times, without shares where it
/// faces nothing.
struct Follower {
  std::size_t joint = 0;
  mesh::JointLips lips;
  int slave = 0;
  std::vector<ContactPoint> alone;         ///< by point: without a partner
  std::map<Index, std::size_t> number_of;  ///< by the slave node's dof
  std::map<Index, Point> place;            ///< undeformed, of all nodes of both lips by dof
};

/// All joints of a scene: where they cross they share mesh points. What a point remembers is kept in the
/// state as "contact.JOINT.memory", its multipliers as "contact.JOINT.base". Lips begin in contact where no
/// gap parts them.
class ContactTerm final : public model::LocalTerm {
 public:
  /// Keeps a reference to the model.
  ContactTerm(const model::Model& model, std::vector<JointContact> joints,
              std::shared_ptr<const CycleRule> rule);

  /// Adds the arrays that the points need.
  void add_state(fields::State& state);
  std::size_t bytes() const override;
  std::span<const Index> touched() const override { return touched_; }
  const model::Jumps& jumps() const override { return jumps_; }
  bool follows() const override { return !followers_.empty(); }
  bool follow(fields::State& state) override;
  void respond(const fields::State& state, std::span<const double> unknown,
               model::JumpResponse& response) const override;
  void begin(const fields::State& state, std::span<const double> jump,
             std::span<double> unknown) const override;
  model::StatusUpdate update_status(fields::State& state, const model::StatusChange& change,
                                    std::span<double> unknown) const override;
  bool stop_first(fields::State& state, std::span<const double> motion,
                  std::span<double> unknown) const override;
  bool settle(fields::State& state, std::span<const double> unknown) const override;
  void tractions(const fields::State& state, std::span<double> traction) const override;
  std::vector<std::int8_t> status(const fields::State& state) const override;
  void restore(fields::State& state, std::span<const std::int8_t> status) const override;
  std::string point_name(std::size_t point) const override;
  /// Numbers of points that are open, stick, slip; "penetration/h", "pressure" (the greatest [Pa]).
  std::vector<std::pair<std::string, double>> facts(const fields::State& state,
                                                    std::span<const double> unknown) const override;
  void add_results(const fields::State& state, model::StageResult& result) const override;

  const std::vector<JointContact>& joints() const { return joints_; }
  /// What a point remembers, committed or on trial.
  PointMemory committed(const fields::State& state, std::size_t joint, std::size_t point) const;
  PointMemory trial(const fields::State& state, std::size_t joint, std::size_t point) const;

 private:
  void find_touched();
  void gather_jumps();
  void add_jumps(const JointContact& joint);
  /// Calls visit(joint, point, first component) for every point.
  void for_each(const auto& visit) const;
  PointMemory from_array(std::span<const double> array, std::size_t joint, std::size_t point) const;
  /// No stage has dealt with it yet.
  bool unseen(const fields::State& state, std::size_t joint, std::size_t point) const;
  void put(fields::State& state, std::size_t joint, std::size_t point, const PointMemory& memory) const;
  Hold hold(const fields::State& state, std::size_t joint, std::size_t point) const;
  PointResponse answer(const fields::State& state, std::size_t joint, std::size_t point,
                       std::span<const double> unknown) const;
  /// A point that is to change, and by how much its status breaks the laws [m].
  struct Misfit {
    std::size_t joint = 0, point = 0;
    Index component = 0;
    Status next = Status::open;
    double violation = 0;
    PointResponse response;
  };
  struct Misfits {
    std::vector<Misfit> list;
    double complementarity = 0;
  };
  Misfits misfits(const fields::State& state, const model::StatusChange& change,
                  std::span<const double> unknown) const;
  void slip_before_parting(const fields::State& state, std::vector<Misfit>& list) const;
  void change_status(fields::State& state, const Misfit& misfit, std::span<double> unknown) const;
  bool augment(fields::State& state, std::size_t joint, std::span<const double> unknown, Index first) const;
  model::JointResult joint_result(const fields::State& state, std::size_t joint,
                                  std::span<const double> jump) const;
  void add_row(const PointMemory& memory, std::size_t joint, std::size_t point, std::span<const double> jump,
               model::JointResult& result) const;

  const model::Model& model_;
  std::unique_ptr<model::Model> moved_;  ///< with the lips where they are, for followers
  std::vector<JointContact> joints_;
  std::shared_ptr<const CycleRule> rule_;
  std::vector<Follower> followers_;
  std::vector<Index> touched_;
  model::Jumps jumps_;
  std::vector<fields::State::Id> memory_, base_, slip_;  ///< by joint
};

}  // namespace ashlar::contact
