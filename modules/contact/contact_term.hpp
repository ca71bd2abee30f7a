#pragma once
// The contact term: forces between the lips of all joints, as a local term of the stage. README.md has the
// equations.

#include "contact/parts.hpp"
#include "model/results.hpp"

namespace ashlar::contact {

/// One joint with its parts and points.
struct JointContact {
  std::string name;
  JointLaw law;
  std::shared_ptr<const Enforcement> enforcement;
  std::vector<ContactPoint> points;
};

/// All joints of a scene: where they cross they share mesh points. What a point remembers is kept in the
/// state as "contact.JOINT.memory", its multipliers as "contact.JOINT.base". Lips begin in contact where no
/// gap parts them.
class ContactTerm final : public model::LocalTerm {
 public:
  /// Keeps a reference to the model.
  ContactTerm(const model::Model& model, std::vector<JointContact> joints);

  /// Adds the arrays that the points need.
  void add_state(fields::State& state);
  std::size_t bytes() const override;
  std::span<const Index> touched() const override { return touched_; }
  const model::Jumps& jumps() const override { return jumps_; }
  void respond(const fields::State& state, std::span<const double> unknown,
               model::JumpResponse& response) const override;
  void begin(const fields::State& state, std::span<const double> jump,
             std::span<double> unknown) const override;
  int update_status(fields::State& state, const model::StatusChange& change,
                    std::span<double> unknown) const override;
  bool close_first(fields::State& state, std::span<const double> motion,
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
  void add_jumps(const JointContact& joint);
  /// Calls visit(joint, point, first component) for every point.
  void for_each(const auto& visit) const;
  PointMemory from_array(std::span<const double> array, std::size_t joint, std::size_t point) const;
  void put(fields::State& state, std::size_t joint, std::size_t point, const PointMemory& memory) const;
  Hold hold(const fields::State& state, std::size_t joint, std::size_t point) const;
  PointResponse answer(const fields::State& state, std::size_t joint, std::size_t point,
                       std::span<const double> unknown) const;
  /// A point that is to change, and how badly its status fits.
  struct Misfit {
    std::size_t joint = 0, point = 0;
    Index component = 0;
    Status next = Status::open;
    double size = 0;
    PointResponse response;
  };
  std::vector<Misfit> misfits(const fields::State& state, const model::StatusChange& change,
                              std::span<const double> unknown) const;
  void change_status(fields::State& state, const Misfit& misfit, std::span<double> unknown) const;
  bool augment(fields::State& state, std::size_t joint, std::span<const double> unknown, Index first) const;
  model::JointResult joint_result(const fields::State& state, std::size_t joint,
                                  std::span<const double> jump) const;
  void add_row(const PointMemory& memory, std::size_t joint, std::size_t point, std::span<const double> jump,
               model::JointResult& result) const;

  const model::Model& model_;
  std::vector<JointContact> joints_;
  std::vector<Index> touched_;
  model::Jumps jumps_;
  std::vector<fields::State::Id> memory_, base_;  ///< by joint
};

}  // namespace ashlar::contact
