#pragma once
// Constraints that repeat each other. Where joints meet (T, X) and at corners of a joint, rigid points may
// ask more of the nodes there than these can move: with three bodies A, B, C that stick, A–B and A–C hold B–C
// too, and the tractions of the three are not determined. The pair of spaces is stable again if the joint
// that ends there has one multiplier less: its last point holds the mean jump of its end and the next point,
// with the traction of both (the cross-point modification of mortar methods: B. I. Wohlmuth, Discretization
// Methods and Iterative Solvers Based on Domain Decomposition, Springer 2001, 1.2). A uniform traction passes
// exactly.

#include "contact/contact_term.hpp"

namespace ashlar::contact {

/// Joins such points with their neighbours; returns how many. Points that give way (penalty, stiffness of a
/// law), those that follow their partners and those of two passes stay.
int join_repeated(std::vector<JointContact>& joints);

}  // namespace ashlar::contact
