#pragma once
// The return to Mohr–Coulomb's pyramid with tension cut-off, in principal stresses σ1 ≥ σ2 ≥ σ3, tension
// positive. All faces are planes, so that each region's return is a closed formula and nothing iterates:
//   plane   σ = σt − D m f/(n·D m),                 D_ep = D − D m (D n)ᵀ/(n·D m)
//   line    σ = σ0 + r (rg·C(σt − σ0))/(rg·C r),    D_ep = r rgᵀ/(rg·C r),  r = n_a × n_b, rg = m_a × m_b
//   point   σ = σ0,                                 D_ep = 0
// J. Clausen, L. Damkilde, L. Andersen, Efficient return algorithms for associated plasticity with multiple
// yield planes, Int. J. Numer. Methods Engrg. 66 (2006) 1036–1059; the same, An efficient return algorithm
// for non-associated plasticity with linear yield criteria in principal stress space, Comput. Struct. 85
// (2007).

#include "elasticity/materials/common.hpp"
#include "elasticity/materials/plastic.hpp"
#include "elasticity/materials/principal.hpp"

namespace ashlar::elasticity::mohr_coulomb {

struct Strength {
  FrictionalStrength shear;
  double tension = 0;  ///< greatest principal stress [Pa], at most c/tan φ; infinite: none (φ = 0 only)
};

/// Where a stress returns to. Shear plane: σ1, σ3 slide. Compression edge: σ1 = σ2; extension edge: σ2 = σ3.
/// The cut-off meets the shear plane in shear_tension, the edges in the two corners; apex: σ1 = σ2 = σ3 =
/// tension.
enum class Region {
  elastic,
  shear_plane,
  compression_edge,
  extension_edge,
  tension_plane,
  tension_edge,
  apex,
  shear_tension,
  compression_corner,
  extension_corner
};
const char* name_of(Region region);

struct Returned {
  PrincipalAnswer answer;
  Region region = Region::elastic;
  /// By how much the stress breaches a face, or the flow its cone, as a share of the trial stress: rounding.
  double breach = 0;
};

/// Greatest breach of all faces [Pa], each by its distance from the stress; ≤ 0: none.
double excess(const Strength& strength, const Eigen::Vector3d& sorted);

/// `sorted`: trial stress, σ1 ≥ σ2 ≥ σ3. Total: every finite trial stress has an answer.
Returned return_to(const Strength& strength, const Isotropic& moduli, const Eigen::Vector3d& sorted);

}  // namespace ashlar::elasticity::mohr_coulomb
