#include "contact/repeated.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/QR>

#include "contact/pairing/lip.hpp"

namespace ashlar::contact {

namespace {

// Points nearer than this part of the mesh size are at one place.
constexpr double one_place = 1e-6;
// Constraints whose directions differ by less repeat each other.
constexpr double repeated = 1e-9;

struct Place {
  std::size_t joint = 0, point = 0;
};

/// Directions in which a point is held exactly whatever its status.
struct Rigid {
  bool normal = false, tangential = false;
};

Rigid rigid(const JointContact& joint, const ContactPoint& point) {
  const Hold hold = joint.enforcement->hold(point, {0, 0}, 1);
  const Friction& friction = *joint.law.friction;
  Rigid held;
  held.normal = hold.normal == 0 && joint.law.normal->form() == NormalLaw::Form::rigid;
  held.tangential = hold.tangential == 0 && !friction.frictionless() && std::isinf(friction.stiffness());
  return held;
}

/// What one point asks of the nodes: normal · J = …, and tangent · J = … where it may stick.
void add_rows(const JointContact& joint, const ContactPoint& point, std::vector<Index>& dofs,
              std::vector<Eigen::VectorXd>& rows) {
  const auto column = [&](Index dof) {
    const auto at = std::ranges::find(dofs, dof) - dofs.begin();
    if (at == static_cast<std::ptrdiff_t>(dofs.size())) dofs.push_back(dof);
    return at;
  };
  const auto row = [&](Point direction) {
    Eigen::VectorXd& values = rows.emplace_back(Eigen::VectorXd::Zero(0));
    for (const ContactPoint::Share& share : point.shares)
      for (int axis = 0; axis < 2; ++axis) {
        const auto at = column(share.dof + axis);
        if (at >= values.size()) values.conservativeResizeLike(Eigen::VectorXd::Zero(at + 1));
        values[at] += share.factor * (axis == 0 ? direction.x : direction.y);
      }
  };
  const Rigid held = rigid(joint, point);
  if (held.normal) row(point.normal);
  if (held.tangential) row(point.tangent);
}

/// How many of the constraints of these points follow from the others.
Index surplus(const std::vector<JointContact>& joints, const std::vector<Place>& places) {
  std::vector<Index> dofs;
  std::vector<Eigen::VectorXd> rows;
  for (const Place& place : places)
    add_rows(joints[place.joint], joints[place.joint].points[place.point], dofs, rows);
  Eigen::MatrixXd matrix =
      Eigen::MatrixXd::Zero(static_cast<Index>(rows.size()), static_cast<Index>(dofs.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    matrix.row(static_cast<Index>(i)).head(rows[i].size()) = rows[i].transpose();
  if (matrix.size() == 0) return 0;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  qr.setThreshold(repeated);
  return matrix.rows() - qr.rank();
}

/// Two passes ask everything twice, all along: no point has a neighbour to be joined with.
bool on_both_lips(const JointContact& joint) {
  return std::ranges::any_of(joint.points,
                             [&](const ContactPoint& p) { return p.slave != joint.points.front().slave; });
}

/// Rigid points by the places that two or more share.
std::vector<std::vector<Place>> meetings(const std::vector<JointContact>& joints) {
  std::vector<Place> all;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].follow || on_both_lips(joints[j])) continue;
    for (std::size_t p = 0; p < joints[j].points.size(); ++p) {
      const Rigid held = rigid(joints[j], joints[j].points[p]);
      if ((held.normal || held.tangential) && !joints[j].points[p].shares.empty()) all.push_back({j, p});
    }
  }
  const auto point = [&](const Place& place) -> const ContactPoint& {
    return joints[place.joint].points[place.point];
  };
  std::ranges::stable_sort(all, {}, [&](const Place& place) { return point(place).at.x; });
  std::vector<std::vector<Place>> groups;
  std::vector<char> taken(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (taken[i]) continue;
    const Point at = point(all[i]).at;
    const double near = one_place * point(all[i]).h;
    std::vector<Place> group;
    for (std::size_t k = i; k < all.size() && point(all[k]).at.x <= at.x + near; ++k)
      if (!taken[k] && geometry::distance(point(all[k]).at, at) <= near) {
        group.push_back(all[k]);
        taken[k] = 1;
      }
    if (group.size() > 1) groups.push_back(std::move(group));
  }
  return groups;
}

/// The next point of the same stretch of lip, if there is one.
std::optional<std::size_t> neighbour(const std::vector<ContactPoint>& points, std::size_t point) {
  const auto beside = [&](std::size_t other) {
    return points[other].piece == points[point].piece && !points[other].shares.empty() &&
           geometry::distance(points[other].at, points[point].at) > one_place * points[point].h;
  };
  if (point + 1 < points.size() && beside(point + 1)) return point + 1;
  if (point > 0 && beside(point - 1)) return point - 1;
  return {};
}

/// `one` stands for both from here on.
void join(ContactPoint& one, const ContactPoint& other) {
  const double area = one.area + other.area, share = other.area / area;
  const double stands_for = one.area / one.weight + other.area / other.weight;
  merge_shares(one, other);
  one.slip += share * (other.slip - one.slip);
  one.s += share * (other.s - one.s);
  one.at = one.at + share * (other.at - one.at);
  one.length += other.length;
  one.area = area;
  one.weight = area / stands_for;
}

/// Joints that end at a meeting give up a point before those that pass, later ones before earlier ones.
std::vector<std::size_t> by_right(const std::vector<Place>& group) {
  std::vector<std::size_t> order(group.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto passes = [&](std::size_t i) {
    return std::ranges::count(group, group[i].joint, &Place::joint) > 1;
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    if (passes(a) != passes(b)) return passes(b);
    return group[a].joint > group[b].joint;
  });
  return order;
}

}  // namespace

int join_repeated(std::vector<JointContact>& joints) {
  std::vector<std::vector<char>> spent(joints.size());  // has given up its place, or taken another's
  for (std::size_t j = 0; j < joints.size(); ++j) spent[j].resize(joints[j].points.size());
  std::vector<Place> given_up;
  for (std::vector<Place> group : meetings(joints)) {
    std::erase_if(group, [&](const Place& place) { return spent[place.joint][place.point]; });
    Index more = surplus(joints, group);
    for (const std::size_t i : by_right(group)) {
      if (more == 0) break;
      const Place& place = group[i];
      std::vector<ContactPoint>& points = joints[place.joint].points;
      const auto next = neighbour(points, place.point);
      if (!next || spent[place.joint][*next]) continue;
      std::vector<Place> rest;
      for (const Place& other : group)
        if (!spent[other.joint][other.point] && &other != &place) rest.push_back(other);
      const Index left = surplus(joints, rest);
      if (left >= more) continue;
      more = left;
      join(points[*next], points[place.point]);
      spent[place.joint][place.point] = spent[place.joint][*next] = 1;
      given_up.push_back(place);
    }
  }
  std::ranges::sort(given_up, std::ranges::greater{}, &Place::point);
  for (const Place& place : given_up) {
    auto& points = joints[place.joint].points;
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(place.point));
  }
  return static_cast<int>(given_up.size());
}

}  // namespace ashlar::contact
