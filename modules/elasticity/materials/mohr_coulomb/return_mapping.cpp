#include "elasticity/materials/mohr_coulomb/return_mapping.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>
#include <span>

namespace ashlar::elasticity::mohr_coulomb {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Rounding leaves a returned stress this far off its face, as a share of the trial stress.
constexpr double rounding = 1e-12;

/// A face n·σ ≤ limit with flow direction m.
struct Face {
  Vector3d n, m;
  double limit = 0;
  double breach(const Vector3d& stress) const { return (n.dot(stress) - limit) / n.norm(); }
};

/// The faces that a sorted stress can meet: shear between σ1 and σ3, σ1 and σ2, σ2 and σ3, and the cut-off of
/// each. n = (1 + sin φ) e_i − (1 − sin φ) e_j, m the same with ψ, limit = 2c cos φ; the cut-off flows along
/// its normal.
struct Faces {
  Face s13, s12, s23, t1, t2, t3;
  explicit Faces(const Strength& strength) {
    const FrictionalStrength& shear = strength.shear;
    const auto slide = [&](int i, int j) {
      const auto across = [&](double sine) -> Vector3d {
        return (1 + sine) * Vector3d::Unit(i) - (1 - sine) * Vector3d::Unit(j);
      };
      return Face{across(shear.sin_friction), across(shear.sin_dilation),
                  2 * shear.cohesion * shear.cos_friction};
    };
    const auto pull = [&](int i) { return Face{Vector3d::Unit(i), Vector3d::Unit(i), strength.tension}; };
    s13 = slide(0, 2), s12 = slide(0, 1), s23 = slide(1, 2);
    t1 = pull(0), t2 = pull(1), t3 = pull(2);
  }
  double breach(const Vector3d& stress) const {
    double worst = -INFINITY;
    for (const Face* face : {&s13, &s12, &s23, &t1, &t2, &t3}) worst = std::max(worst, face->breach(stress));
    return worst;
  }
};

using Flows = std::array<const Face*, 3>;

/// The least share with which the flows of these faces make up the plastic strain, as a stress 2μ λ|m|:
/// negative if the strain is outside their cone. Two faces: the strain lies in their plane.
double least_share(const Flows& faces, const Vector3d& strain, double mu) {
  const Vector3d &a = faces[0]->m, &b = faces[1]->m;
  const Vector3d c = faces[2] ? faces[2]->m : a.cross(b);
  const double volume = a.cross(b).dot(c);
  double least =
      std::min(strain.cross(b).dot(c) / volume * a.norm(), a.cross(strain).dot(c) / volume * b.norm());
  if (faces[2]) least = std::min(least, a.cross(b).dot(strain) / volume * c.norm());
  return 2 * mu * least;
}

/// Tries one region after the other; the first that breaches nothing is the answer, and by rounding the one
/// that breaches least.
class Search {
 public:
  Search(const Strength& strength, const Isotropic& moduli, const Vector3d& trial)
      : faces_(strength), moduli_(moduli), trial_(trial) {
    stiffness_ = Matrix3d::Constant(moduli.lambda);
    stiffness_.diagonal().array() += 2 * moduli.mu;
    scale_ = std::max(trial.cwiseAbs().maxCoeff(), DBL_MIN);
  }

  bool found() const { return worst_ <= rounding; }
  const Returned& best() const { return best_; }

  void plane(Region region, const Face& face) {
    const Vector3d dm = stiffness_ * face.m, dn = stiffness_ * face.n;
    const double along = face.n.dot(dm);
    const double flow = (face.n.dot(trial_) - face.limit) / along;
    offer({{trial_ - flow * dm, stiffness_ - dm * dn.transpose() / along}, region},
          2 * moduli_.mu * flow * face.m.norm());
  }

  /// `on` is a stress on both faces.
  void line(Region region, const Face& a, const Face& b, const Vector3d& on) {
    const Vector3d r = a.n.cross(b.n), flow_normal = a.m.cross(b.m);
    const double along = energy(flow_normal, r);
    const Vector3d stress = on + r * (energy(flow_normal, trial_ - on) / along);
    offer({{stress, r * flow_normal.transpose() / along}, region},
          least_share({&a, &b, nullptr}, compliant(trial_ - stress), moduli_.mu));
  }

  /// Cones of flows that together cover all that may meet in the point.
  void point(Region region, const Vector3d& stress, std::initializer_list<Flows> cones) {
    const Vector3d strain = compliant(trial_ - stress);
    double share = -INFINITY;
    for (const Flows& cone : cones) share = std::max(share, least_share(cone, strain, moduli_.mu));
    offer({{stress, Matrix3d::Zero()}, region}, share);
  }

 private:
  Vector3d compliant(const Vector3d& stress) const {
    const double mean = stress.mean();
    return (stress.array() - mean) / (2 * moduli_.mu) + mean / (3 * moduli_.bulk);
  }

  /// a·Cb, deviators and means apart: nearly incompressible, the sum would drown in the rounding of one of
  /// them.
  double energy(const Vector3d& a, const Vector3d& b) const {
    const Vector3d da = a.array() - a.mean(), db = b.array() - b.mean();
    return da.dot(db) / (2 * moduli_.mu) + a.mean() * b.mean() / moduli_.bulk;
  }

  void offer(const Returned& candidate, double share) {
    if (found()) return;
    const double breach = std::max(faces_.breach(candidate.answer.stress), -share) / scale_;
    if (!(breach < worst_)) return;
    worst_ = breach;
    best_ = candidate;
    best_.breach = breach;
  }

  Faces faces_;
  const Isotropic& moduli_;
  Vector3d trial_;
  Matrix3d stiffness_;
  double scale_ = 1, worst_ = INFINITY;
  Returned best_;
};

void search_shear(Search& search, const Faces& f, const FrictionalStrength& shear) {
  search.plane(Region::shear_plane, f.s13);
  // The stress on each edge that is nearest to the origin keeps clear of the apex, which may be far away.
  const double up = 1 + shear.sin_friction, down = 1 - shear.sin_friction;
  const double size = f.s13.limit / (up * up + down * down);
  search.line(Region::compression_edge, f.s13, f.s23, size * Vector3d(up, up, -down));
  search.line(Region::extension_edge, f.s13, f.s12, size * Vector3d(up, -down, -down));
}

void search_tension(Search& search, const Faces& f, const Strength& strength) {
  const double t = strength.tension;
  const double up = 1 + strength.shear.sin_friction, down = 1 - strength.shear.sin_friction;
  // σ3 where σ1 = t meets the shear plane; the same as t at the tip of the pyramid, where all corners are
  // one.
  double low = (up * t - f.s13.limit) / down;
  const bool tip = t - low <= rounding * std::max(t, f.s13.limit) / down;
  if (tip) low = t;
  search.plane(Region::tension_plane, f.t1);
  search.line(Region::tension_edge, f.t1, f.t2, {t, t, 0});
  search.line(Region::shear_tension, f.s13, f.t1, {t, 0, low});
  search.point(Region::apex, {t, t, t}, {{&f.t1, &f.t2, &f.t3}});
  search.point(tip ? Region::apex : Region::compression_corner, {t, t, low},
               {{&f.s13, &f.t1, &f.t2}, {&f.s13, &f.s23, &f.t2}});
  search.point(tip ? Region::apex : Region::extension_corner, {t, low, low}, {{&f.s13, &f.s12, &f.t1}});
}

}  // namespace

const char* name_of(Region region) {
  static constexpr std::array names = {
      "elastic",      "shear plane", "compression edge",  "extension edge",     "tension plane",
      "tension edge", "apex",        "shear and tension", "compression corner", "extension corner"};
  return names[static_cast<std::size_t>(region)];
}

double excess(const Strength& strength, const Vector3d& sorted) {
  return Faces(strength).breach(sorted);
}

Returned return_to(const Strength& strength, const Isotropic& moduli, const Vector3d& sorted) {
  const Faces faces(strength);
  if (faces.breach(sorted) <= 0) return {{sorted, {}}, Region::elastic};
  Search search(strength, moduli, sorted);
  search_shear(search, faces, strength.shear);
  if (!search.found() && std::isfinite(strength.tension)) search_tension(search, faces, strength);
  return search.best();
}

}  // namespace ashlar::elasticity::mohr_coulomb
