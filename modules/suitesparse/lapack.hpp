#pragma once
// Dense factorisations by OpenBLAS's LAPACK, with one thread: the same bits whatever the number of cores.

#include "algebra/dense.hpp"

namespace ashlar::suitesparse {

const algebra::DenseAlgebra& lapack();

/// L Lᵀ of a lower triangular matrix: a third of the work of a full product.
Eigen::MatrixXd times_transposed(const Eigen::MatrixXd& lower);

}  // namespace ashlar::suitesparse
