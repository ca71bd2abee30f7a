// Faults of joints: a local term that behaves as the sound one but for one thing.

#include <algorithm>
#include <map>

#include "stability/fault.hpp"

namespace ashlar::stability {

namespace {

using fields::State;
using model::Index;

class FaultyJoints final : public model::LocalTerm {
 public:
  FaultyJoints(std::shared_ptr<model::LocalTerm> sound, Fault fault)
      : LocalTerm(sound->effect()), sound_(std::move(sound)), fault_(fault) {
    take_jumps();
  }

  std::span<const Index> touched() const override { return sound_->touched(); }
  const model::Jumps& jumps() const override { return jumps_; }
  bool follows() const override { return sound_->follows(); }
  bool follow(State& state) override {
    const bool anew = sound_->follow(state);
    take_jumps();
    return anew;
  }
  void respond(const State& state, std::span<const double> unknown,
               model::JumpResponse& response) const override {
    sound_->respond(state, unknown, response);
    if (fault_ != Fault::scaled_traction) return;
    response.traction *= 1.01;
    response.traction_by *= 1.01;
  }
  void begin(const State& state, std::span<const double> jump, std::span<double> unknown) const override {
    sound_->begin(state, jump, unknown);
  }
  model::StatusUpdate update_status(State& state, const model::StatusChange& change,
                                    std::span<double> unknown) const override {
    return fault_ == Fault::frozen_status ? model::StatusUpdate{}
                                          : sound_->update_status(state, change, unknown);
  }
  bool stop_first(State& state, std::span<const double> motion, std::span<double> unknown) const override {
    return sound_->stop_first(state, motion, unknown);
  }
  bool settle(State& state, std::span<const double> unknown) const override {
    const bool again = sound_->settle(state, unknown);
    if (fault_ == Fault::lost_history) forget(state);
    return again;
  }
  void tractions(const State& state, std::span<double> traction) const override {
    sound_->tractions(state, traction);
  }
  std::vector<std::int8_t> status(const State& state) const override { return sound_->status(state); }
  void restore(State& state, std::span<const std::int8_t> status) const override {
    sound_->restore(state, status);
  }
  std::string point_name(std::size_t point) const override { return sound_->point_name(point); }
  std::vector<std::pair<std::string, double>> facts(const State& state,
                                                    std::span<const double> unknown) const override {
    return sound_->facts(state, unknown);
  }
  void add_results(const State& state, model::StageResult& result) const override {
    sound_->add_results(state, result);
  }

 private:
  void take_jumps() {
    jumps_ = sound_->jumps();
    if (fault_ != Fault::reversed_gap) return;
    const auto victim = static_cast<std::size_t>(jumps_.size() / jumps_.width / 2 * jumps_.width);
    for (model::Jumps::Part& part : jumps_.parts[victim]) part.factor = -part.factor;
  }
  /// Of each point's nine numbers: rest, path, dilation and the law's own.
  static void forget(State& state) {
    for (const std::string& name : state.names()) {
      if (!name.starts_with("contact.") || !name.ends_with(".memory")) continue;
      const std::span<double> memory = state.trial(state.find(name));
      for (std::size_t i = 0; i < memory.size(); ++i)
        if (i % 9 >= 3) memory[i] = 0;
    }
  }

  std::shared_ptr<model::LocalTerm> sound_;
  Fault fault_;
  model::Jumps jumps_;
};

class FaultyEffect final : public model::Effect {
 public:
  FaultyEffect(std::unique_ptr<model::Effect> sound, Fault fault) : sound_(std::move(sound)), fault_(fault) {}
  void contribute(const model::StageContext& context, model::Terms& terms) override {
    sound_->contribute(context, terms);
    for (auto& term : terms.local) {
      auto& faulty = made_[term];
      if (!faulty) faulty = std::make_shared<FaultyJoints>(term, fault_);
      term = faulty;
    }
  }

 private:
  std::unique_ptr<model::Effect> sound_;
  Fault fault_;
  std::map<std::shared_ptr<model::LocalTerm>, std::shared_ptr<model::LocalTerm>> made_;
};

}  // namespace

void plant_in_joints(model::Effects& effects, Fault fault) {
  const bool theirs = fault == Fault::lost_history || fault >= Fault::reversed_gap;
  const auto contact = effects.find("contact");
  if (!theirs || contact == effects.end()) return;
  contact->second = std::make_unique<FaultyEffect>(std::move(contact->second), fault);
}

}  // namespace ashlar::stability
