#pragma once
// Strains of a displacement of order k on a polygon, projected onto polynomials of degree l ≥ k−1: what the
// virtual element without stabilisation and the axisymmetric one are made of.
// Berrone, Borio, Marcon: Lowest order stabilization free virtual element method for the 2D Poisson equation
// (2021); for solids, Chen, Sukumar: Stabilization-free serendipity virtual element method for plane
// elasticity, Comput. Methods Appl. Mech. Engrg. 404 (2023). Moments beyond degree k−2 are those of Πv, the
// polynomial of degree k nearest to v's dofs (enhanced spaces: Ahmad et al., Comput. Math. Appl. 66 (2013)).
//
//   Σ_q w_q (Π∂_d v)(x_q) m_β(x_q) = ∮ ω v m_β n_d − ∫ v ∂_d(ω m_β)     for all m_β of degree ≤ l
//   Σ_q w_q (Πv/r)(x_q) m_β(x_q)   = ∫ 2π v m_β                          around the axis
//
// with ω the thickness or 2πr, and a rule (w_q, x_q) exact for m_β times the strains of polynomials of order
// k. Volume changes are projected onto degree k−1 only (B̄: Hughes, Int. J. Numer. Methods Engrg. 15, 1980):
// one condition a cell for k = 1, so that incompressible flow is not locked. What they lack beyond it is
// taken from the three normal strains alike; ε_zz in plane strain is thus 0 up to degree k−1. Shape change
// still sees it.

#include <Eigen/Dense>

#include "elasticity/polynomials.hpp"
#include "model/element.hpp"

namespace ashlar::elasticity {

/// Integration points of a cell that the projection needs, as many as any cell of so many corners may need.
int projection_points(std::size_t corners, int order, int degree, bool axisymmetric);

/// Degree l that sees every deformation of a cell of so many corners but rigid motions.
int seeing_degree(std::size_t corners, int order);

class StrainProjection {
 public:
  StrainProjection(const model::Cell& cell, int order, int degree);

  /// Fills weights, places and rows of B.
  void fill(model::IntegrationPoints& points) const;
  /// force += ∫ b·φ over the cell and its depth.
  void add_body_force(Point b, std::span<double> force) const;
  /// Of every deformation but rigid motions, the strains at the points see at least this share: 0 … 1,
  /// against their own energy and that of what polynomials of degree k leave of the dofs. Plane cells.
  double least_seen() const;

 private:
  struct At {
    Point x, xi;
    double area;
  };
  /// By polynomial and scalar dof: of ∂_x φ, ∂_y φ and φ/r.
  struct Gradient {
    Eigen::MatrixXd x, y, around;
  };
  void place_points();
  void orthonormalise();
  void project_values();
  void find_moments();
  Gradient project_gradient() const;
  void add_border(Gradient& g) const;
  void add_inside(Gradient& g) const;
  int scalar_dofs() const;
  /// Mean over the area of m_a m_b.
  double mean_product(int a, int b) const;
  double weight(const At& at) const { return at.area * depth(at.x); }
  double depth(Point x) const { return model::depth(cell_.thickness, cell_.axisymmetric, x); }

  model::Cell cell_;
  int order_, degree_;
  Frame frame_;
  std::vector<Point> local_;
  std::vector<double> integral_;  ///< of the monomials over the cell in ξ
  std::vector<At> at_;
  Eigen::MatrixXd basis_;   ///< orthonormal polynomials at the points × √w
  Eigen::MatrixXd factor_;  ///< monomials = orthonormal · factorᵀ; its lower triangle
  Eigen::MatrixXd dofs_;    ///< of the monomials of degree ≤ k
  Eigen::MatrixXd value_;   ///< Πφ_i by monomials of degree ≤ k
  Eigen::MatrixXd moment_;  ///< ∫ φ_i m_γ over the area
  Gradient gradient_;       ///< coefficients of the orthonormal polynomials
};

}  // namespace ashlar::elasticity
