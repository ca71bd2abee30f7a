#include "suitesparse/umfpack.hpp"

#include <array>
#include <cassert>
#include <new>

#include <umfpack.h>

#include "suitesparse/common.hpp"

namespace ashlar::suitesparse {

using algebra::FactorReport;
using algebra::SymmetricMatrix;
using algebra::SymmetricPattern;

Umfpack::~Umfpack() {
  umfpack_di_free_numeric(&numeric_);
  umfpack_di_free_symbolic(&symbolic_);
}

void Umfpack::analyse(const SymmetricPattern& pattern, std::span<const Index> kept, std::span<const Index>) {
  inner_.assign(static_cast<std::size_t>(pattern.size), 0);
  kept_ = static_cast<Index>(kept.size());
  inside_ = 0;
  for (Index k = 0; k < kept_; ++k) inner_[kept[k]] = -1 - k;
  for (Index& number : inner_)
    if (number >= 0) number = inside_++;
  // Entries of A_ii in each column: those below the diagonal as they stand, those above from their
  // transposed.
  std::vector<Index> count(static_cast<std::size_t>(inside_) + 1);
  const auto each_entry = [&](auto&& use) {
    for (Index j = 0; j < pattern.size; ++j)
      for (Index p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
        const Index row = inner_[pattern.row[p]], column = inner_[j];
        if (row < 0 || column < 0) continue;
        use(row, column);
        if (row != column) use(column, row);
      }
  };
  each_entry([&](Index, Index column) { ++count[column + 1]; });
  for (Index j = 0; j < inside_; ++j) count[j + 1] += count[j];
  column_start_ = count;
  row_.resize(static_cast<std::size_t>(count.back()));
  // Columns come in ascending order: so do the rows that each of them adds to a column.
  each_entry([&](Index row, Index column) { row_[count[column]++] = row; });
  umfpack_di_free_symbolic(&symbolic_);
  trouble_.clear();
  if (inside_ == 0) return;
  const OneThread one_thread;
  if (umfpack_di_symbolic(inside_, inside_, column_start_.data(), row_.data(), nullptr, &symbolic_, nullptr,
                          nullptr) != UMFPACK_OK)
    trouble_ = "not enough memory to order " + std::to_string(inside_) + " unknowns";
}

void Umfpack::add_entry(Index row, Index column, double value, std::vector<Index>& next) {
  const Index r = inner_[row], c = inner_[column];
  if (r >= 0 && c >= 0)
    value_[next[c]++] = value;
  else if (r >= 0)
    from_kept_(r, -1 - c) = value;
  else if (c >= 0)
    to_kept_(-1 - r, c) = value;
  else
    kept_block_(-1 - r, -1 - c) = value;
}

void Umfpack::scatter(const SymmetricMatrix& matrix) {
  const SymmetricPattern& pattern = matrix.pattern;
  value_.assign(row_.size(), 0.0);
  from_kept_.setZero(inside_, kept_);
  to_kept_.setZero(kept_, inside_);
  kept_block_.setZero(kept_, kept_);
  std::vector<Index> next = column_start_;
  for (Index j = 0; j < pattern.size; ++j)
    for (Index p = pattern.column_start[j]; p < pattern.column_start[j + 1]; ++p) {
      const Index i = pattern.row[p];
      add_entry(i, j, matrix.value[p], next);
      if (i != j) add_entry(j, i, matrix.upper.empty() ? matrix.value[p] : matrix.upper[p], next);
    }
}

FactorReport Umfpack::factor(const SymmetricMatrix& matrix) {
  FactorReport report;
  report.ordering = "LU of " + std::to_string(inside_) + " unknowns";
  report.reason = trouble_;
  if (!trouble_.empty()) return report;
  scatter(matrix);
  umfpack_di_free_numeric(&numeric_);
  if (inside_ > 0) {
    const OneThread one_thread;
    std::array<double, UMFPACK_INFO> info{};
    const int status = reserve_blas_memory()
                           ? umfpack_di_numeric(column_start_.data(), row_.data(), value_.data(), symbolic_,
                                                &numeric_, nullptr, info.data())
                           : UMFPACK_ERROR_out_of_memory;
    if (status == UMFPACK_WARNING_singular_matrix)
      report.reason = "the matrix is singular: a body is free to move";
    if (status < 0) report.reason = "not enough memory to factor " + std::to_string(inside_) + " unknowns";
    if (status != UMFPACK_OK) return report;
    report.entries = info[UMFPACK_LNZ] + info[UMFPACK_UNZ];
    report.flops = info[UMFPACK_FLOPS];
  }
  make_schur();
  report.done = true;
  return report;
}

void Umfpack::make_schur() {
  schur_ = kept_block_;
  for (Index k = 0; k < kept_; ++k) schur_.col(k) -= to_kept_ * solve_inside(from_kept_.col(k));
}

Eigen::VectorXd Umfpack::solve_inside(const Eigen::VectorXd& right, bool transposed) const {
  Eigen::VectorXd x(inside_);
  if (inside_ == 0) return x;
  const OneThread one_thread;
  if (umfpack_di_solve(transposed ? UMFPACK_At : UMFPACK_A, column_start_.data(), row_.data(), value_.data(),
                       x.data(), right.data(), numeric_, nullptr, nullptr) < 0)
    throw std::bad_alloc();
  return x;
}

void Umfpack::solve(std::span<const double> b, std::span<double> x) const {
  assert(kept_ == 0);
  const Eigen::Map<const Eigen::VectorXd> right(b.data(), inside_);
  Eigen::Map<Eigen::VectorXd>(x.data(), inside_) = solve_inside(right);
}

void Umfpack::solve_transposed(std::span<const double> b, std::span<double> x) const {
  assert(kept_ == 0);
  const Eigen::Map<const Eigen::VectorXd> right(b.data(), inside_);
  Eigen::Map<Eigen::VectorXd>(x.data(), inside_) = solve_inside(right, true);
}

// `work` is the right-hand side itself.
Eigen::VectorXd Umfpack::condense(std::span<const double> b, std::vector<double>& work) const {
  work.assign(b.begin(), b.end());
  Eigen::VectorXd inside(inside_), kept(kept_);
  for (std::size_t i = 0; i < b.size(); ++i)
    (inner_[i] >= 0 ? inside[inner_[i]] : kept[-1 - inner_[i]]) = b[i];
  return kept - to_kept_ * solve_inside(inside);
}

void Umfpack::expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
                     std::span<double> x) const {
  Eigen::VectorXd inside(inside_);
  for (std::size_t i = 0; i < work.size(); ++i)
    if (inner_[i] >= 0) inside[inner_[i]] = work[i];
  const Eigen::VectorXd solution = solve_inside(inside - from_kept_ * kept_values);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = inner_[i] >= 0 ? solution[inner_[i]] : kept_values[-1 - inner_[i]];
}

std::size_t Umfpack::bytes() const {
  std::size_t sum = sizeof(Index) * (inner_.capacity() + column_start_.capacity() + row_.capacity()) +
                    sizeof(double) * value_.capacity();
  sum += sizeof(double) *
         static_cast<std::size_t>(to_kept_.size() + from_kept_.size() + kept_block_.size() + schur_.size());
  int lower = 0, upper = 0, rows = 0, columns = 0, diagonal = 0;
  if (numeric_ && umfpack_di_get_lunz(&lower, &upper, &rows, &columns, &diagonal, numeric_) == UMFPACK_OK)
    sum += (sizeof(double) + sizeof(Index)) *
           (static_cast<std::size_t>(lower) + static_cast<std::size_t>(upper));
  return sum;
}

}  // namespace ashlar::suitesparse
