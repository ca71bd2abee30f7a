#include "crosscheck/hertz_reference.hpp"

#include <Eigen/Dense>
#include <fstream>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "crosscheck/calculix.hpp"

namespace ashlar::test {

namespace {

constexpr int most_solutions = 30;

/// What CalculiX says of each node, vertically.
struct Vertical {
  std::map<int, double> move, force;
};

class Solution {
 public:
  Solution(const HertzModel& model, std::filesystem::path folder)
      : model_(model), folder_(std::move(folder)) {}

  /// Displacements of all nodes of the contact, and the forces that their elements take up.
  Vertical solve(const std::vector<bool>& closed) const {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "hertz.inp") << input(closed);
    call_calculix(folder_, "hertz");
    return read();
  }

 private:
  // CalculiX counts from 1. Behind the nodes of the mesh stands one a pair, whose displacement is the pair's
  // gap.
  static int number(int node) { return node + 1; }
  int gap_node(std::size_t pair) const { return static_cast<int>(model_.points.size() + pair) + 1; }

  std::string input(const std::vector<bool>& closed) const {
    std::ostringstream out;
    out.precision(12);
    out << "*NODE\n";
    for (std::size_t i = 0; i < model_.points.size(); ++i)
      out << number(static_cast<int>(i)) << ',' << model_.points[i].x << ',' << model_.points[i].y << ",0\n";
    for (std::size_t k = 0; k < model_.pairs.size(); ++k) out << gap_node(k) << ",0,0,0\n";
    elements(out);
    sets(out);
    for (std::size_t k = 0; k < model_.pairs.size(); ++k)
      if (closed[k])
        out << "*EQUATION\n3\n"
            << number(model_.pairs[k].disc) << ",2,1," << number(model_.pairs[k].block) << ",2,-1,"
            << gap_node(k) << ",2,1\n";
    out << "*BOUNDARY\nAXIS,1,1\nBOTTOM,1,2\n*STEP\n*STATIC\n*BOUNDARY\n";
    for (std::size_t k = 0; k < model_.pairs.size(); ++k)
      if (closed[k]) out << gap_node(k) << ",2,2," << model_.gaps[k] << '\n';
    out << "*CLOAD\n";
    for (const auto& [node, force] : model_.loads) out << number(node) << ",2," << force << '\n';
    out << "*NODE PRINT, NSET=CONTACT\nU,RF\n*END STEP\n";
    return out.str();
  }

  void elements(std::ostream& out) const {
    for (const HertzModel::Body body : {HertzModel::disc, HertzModel::block})
      for (const std::size_t nodes : {8, 6}) {
        out << "*ELEMENT, TYPE=CPE" << nodes << ", ELSET=BODY" << body << '\n';
        for (std::size_t i = 0; i < model_.cells.size(); ++i) {
          const HertzModel::Cell& cell = model_.cells[i];
          if (cell.body != body || cell.nodes.size() != nodes) continue;
          out << i + 1;
          for (const int node : cell.nodes) out << ',' << number(node);
          out << '\n';
        }
      }
    for (const auto& [body, stiffness] :
         {std::pair(HertzModel::disc, "1e3"), std::pair(HertzModel::block, "1e6")})
      out << "*MATERIAL, NAME=M" << body << "\n*ELASTIC\n"
          << stiffness << ",0.3\n*SOLID SECTION, ELSET=BODY" << body << ", MATERIAL=M" << body << "\n1\n";
  }

  void sets(std::ostream& out) const {
    const auto list = [&](const char* name, const std::vector<int>& nodes) {
      out << "*NSET, NSET=" << name << '\n';
      for (const int node : nodes) out << number(node) << ",\n";
    };
    list("AXIS", model_.axis);
    list("BOTTOM", model_.bottom);
    std::vector<int> contact;
    for (const auto& [disc, block] : model_.pairs) contact.insert(contact.end(), {disc, block});
    list("CONTACT", contact);
  }

  Vertical read() const {
    std::ifstream in(folder_ / "hertz.dat");
    Vertical result;
    std::map<int, double>* block = nullptr;
    for (std::string line; std::getline(in, line);) {
      if (line.find("displacements") != std::string::npos) block = &result.move;
      if (line.find("forces") != std::string::npos) block = &result.force;
      std::istringstream words(line);
      int node = 0;
      double x = 0, y = 0;
      if (block && words >> node >> x >> y) (*block)[node - 1] = y;
    }
    for (const auto* each : {&result.move, &result.force})
      if (each->size() != 2 * model_.pairs.size())
        throw std::runtime_error("CalculiX gave no result, see " + (folder_ / "hertz.log").string());
    return result;
  }

  const HertzModel& model_;
  std::filesystem::path folder_;
};

// Nodal forces to pressures on quadratic edges: M p = f of the closed nodes, M the consistent mass (end,
// middle, end).
std::vector<double> pressures(const std::vector<double>& x, const std::vector<double>& force) {
  Eigen::Index closed = 0;
  for (std::size_t k = 0; k < force.size(); ++k)
    if (force[k] != 0) closed = static_cast<Eigen::Index>(k) + 1;
  Eigen::Matrix3d edge;
  edge << 4, 2, -1, 2, 16, 2, -1, 2, 4;
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(closed + 1, closed + 1);
  for (Eigen::Index e = 0; e + 1 < closed; e += 2)
    mass.block<3, 3>(e, e) +=
        (x[static_cast<std::size_t>(e) + 2] - x[static_cast<std::size_t>(e)]) / 30 * edge;
  const Eigen::VectorXd p = mass.topLeftCorner(closed, closed)
                                .ldlt()
                                .solve(Eigen::Map<const Eigen::VectorXd>(force.data(), closed));
  std::vector<double> all(force.size());
  std::copy(p.begin(), p.end(), all.begin());
  return all;
}

}  // namespace

HertzReference compute_hertz(Loading loading, double spacing, const std::filesystem::path& folder,
                             double first_guess) {
  const HertzModel model = make_hertz(loading, spacing);
  const Solution solution(model, folder);
  const std::size_t count = model.pairs.size();
  HertzReference result;
  for (const auto& pair : model.pairs) result.profile.x.push_back(model.points[pair.block].x);
  std::vector<bool> closed(count), next(count);
  for (std::size_t k = 0; k < count; ++k) next[k] = result.profile.x[k] < first_guess;
  std::vector<double> force(count);
  for (int solutions = 0; next != closed; ++solutions) {
    closed = next;
    if (solutions == most_solutions) throw std::runtime_error("the set of closed pairs does not settle");
    const Vertical found = solution.solve(closed);
    for (std::size_t k = 0; k < count; ++k) {
      const auto [disc, block] = model.pairs[k];
      // The block is pushed down: its elements answer with a downward force.
      force[k] = closed[k] ? -found.force.at(block) : 0;
      next[k] = closed[k] ? force[k] > 0 : model.gaps[k] + found.move.at(disc) - found.move.at(block) < 0;
    }
  }
  result.force = std::accumulate(force.begin(), force.end(), 0.0);
  result.profile.p = pressures(result.profile.x, force);
  return result;
}

Profiles compute_reference(double spacing, const std::filesystem::path& folder) {
  Profiles profiles;
  for (const Loading loading : {Loading::flat_top, Loading::pole})
    profiles[loading] = compute_hertz(loading, spacing, folder / name_of(loading)).profile;
  return profiles;
}

}  // namespace ashlar::test
