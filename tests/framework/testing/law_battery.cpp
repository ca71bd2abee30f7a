// The battery finds planted errors: each law here is wrong in one way.

#include "testing/law_battery.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ashlar::testing {
namespace {

enum class Fault { none, shear_entry, last_digits, unsymmetric, impure, nan, axes };

/// σ = (k + ε:ε) ε with the exact tangent, but for the fault. Shear by halves, so that it is isotropic.
class Planted final : public model::Material {
 public:
  explicit Planted(Fault fault) : fault_(fault) {}
  bool linear() const override { return false; }
  int internal_variables() const override { return 1; }
  model::Response respond(const model::Voigt& strain, std::span<const double> committed,
                          std::span<double> trial) const override {
    const model::Voigt tensor{strain[0], strain[1], strain[2] / 2, strain[3]};
    const double k =
        3 + tensor[0] * tensor[0] + tensor[1] * tensor[1] + 2 * tensor[2] * tensor[2] + tensor[3] * tensor[3];
    model::Response made;
    for (int i = 0; i < 4; ++i) {
      made.stress[i] = k * tensor[i];
      for (int j = 0; j < 4; ++j)
        made.tangent[4 * i + j] = 2 * tensor[i] * tensor[j] + (i == j ? k * (i == 2 ? 0.5 : 1) : 0);
    }
    trial[0] = committed[0] + 1;
    plant(made, tensor);
    return made;
  }
  double unit_weight(double) const override { return -1; }
  double shear_modulus() const override { return 1.5; }
  double plane_modulus() const override { return 3; }

 private:
  void plant(model::Response& made, const model::Voigt& tensor) const {
    if (fault_ == Fault::shear_entry) made.tangent[10] *= 2;
    if (fault_ == Fault::last_digits) made.tangent[0] *= 1 + 3e-6;
    if (fault_ == Fault::unsymmetric) made.tangent[1] += 1e-9;
    if (fault_ == Fault::impure) made.stress[0] += 1e-3 * ++calls_;
    if (fault_ == Fault::nan && tensor[0] > 0.5) made.tangent[5] = std::numeric_limits<double>::quiet_NaN();
    if (fault_ == Fault::axes) made.stress[0] *= 1.1;
  }
  Fault fault_;
  mutable int calls_ = 0;
};

Battery battery_of(Fault fault) {
  const Planted law(fault);
  return run_battery(law, random_states(law, 100, 1, 1));
}

TEST(law_battery, a_sound_law_passes) {
  const Battery battery = battery_of(Fault::none);
  EXPECT_EQ(battery.states, 100);
  EXPECT_EQ(battery.kinks + battery.impure + battery.not_finite, 0);
  EXPECT_LE(battery.worst_tangent, 1e-9);
  EXPECT_LE(battery.worst_symmetry, 1e-15);
  EXPECT_LE(objectivity_error(Planted(Fault::none), {{0.4, -0.2, 0.7, 0.1}, {0}}, 0.6), 1e-15);
}

TEST(law_battery, planted_errors_are_found) {
  EXPECT_GT(battery_of(Fault::shear_entry).worst_tangent, 0.1);
  EXPECT_GT(battery_of(Fault::last_digits).worst_tangent, 1e-6);
  EXPECT_FALSE(battery_of(Fault::shear_entry).worst_state.empty());
  EXPECT_GT(battery_of(Fault::unsymmetric).worst_symmetry, 1e-10);
  EXPECT_EQ(battery_of(Fault::impure).impure, 100);
  EXPECT_GT(battery_of(Fault::nan).not_finite, 0);
  EXPECT_GT(objectivity_error(Planted(Fault::axes), {{0.4, -0.2, 0.7, 0.1}, {0}}, 0.6), 0.01);
}

TEST(law_battery, states_are_the_same_every_time_and_half_have_a_past) {
  const Planted law(Fault::none);
  const auto a = random_states(law, 10, 1, 4), b = random_states(law, 10, 1, 4),
             c = random_states(law, 10, 1, 5);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(a[i].strain, b[i].strain);
    EXPECT_NE(a[i].strain, c[i].strain);
    EXPECT_EQ(a[i].committed[0], i % 2);
  }
}

}  // namespace
}  // namespace ashlar::testing
