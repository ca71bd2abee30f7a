#include "suitesparse/cholesky.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <new>

#include "suitesparse/supernodes.hpp"

namespace ashlar::suitesparse {

using algebra::FactorReport;
using algebra::SymmetricMatrix;

namespace {

/// A pivot below this fraction of its diagonal entry is a zero that round-off has hidden: a free motion.
/// Pivots of sound matrices stay orders above: about (cell size / slenderness)³ for beams.
constexpr double vanished_pivot = 1e-13;

void mix(std::uint64_t& hash, std::span<const Index> values) {
  hash = (hash ^ values.size()) * 0x9E3779B97F4A7C15u;
  for (const Index value : values) {
    hash = (hash ^ static_cast<std::uint32_t>(value)) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 29;
  }
}

cholmod_dense view(double* values, std::size_t rows) {
  cholmod_dense dense{};
  dense.nrow = dense.d = dense.nzmax = rows;
  dense.ncol = 1;
  dense.x = values;
  dense.xtype = CHOLMOD_REAL;
  return dense;
}

}  // namespace

Cholesky::~Cholesky() {
  cholmod_free_dense(&solution_, common_);
  cholmod_free_dense(&y_, common_);
  cholmod_free_dense(&e_, common_);
}

void Cholesky::analyse(const SymmetricPattern& pattern, std::span<const Index> kept,
                       std::span<const Index> node) {
  assert(std::is_sorted(kept.begin(), kept.end()));
  assert(node.size() == static_cast<std::size_t>(pattern.size));
  std::uint64_t fingerprint = 1;
  for (const auto& list :
       {std::span<const Index>(pattern.column_start), std::span<const Index>(pattern.row), kept, node})
    mix(fingerprint, list);
  if (factor_ && fingerprint == fingerprint_) return;
  fingerprint_ = fingerprint;
  kept_.assign(kept.begin(), kept.end());
  trouble_.clear();
  const OneThread one_thread;
  try {
    Ordering ordering = order(pattern, kept, node, method_, common_);
    ordering_ = ordering.words;
    add_structure(pattern, ordering);
    analyse_order(ordering);
  } catch (const std::bad_alloc&) {
    factor_.reset();
    trouble_ = "not enough memory to order " + std::to_string(pattern.size) + " unknowns";
  }
}

void Cholesky::add_structure(const SymmetricPattern& pattern, const Ordering& ordering) {
  // A chain through the kept unknowns, with every other piece of the graph hung on its first link: they are
  // then the top of the elimination tree in any postorder, and their columns stand last.
  std::vector<std::pair<Index, Index>> extra;  // column, row
  for (std::size_t k = 1; k < kept_.size(); ++k) extra.emplace_back(kept_[k - 1], kept_[k]);
  if (!kept_.empty())
    for (const Index i : ordering.last_of_piece)
      extra.emplace_back(std::min(i, kept_[0]), std::max(i, kept_[0]));
  std::sort(extra.begin(), extra.end());

  column_start_.assign(1, 0);
  row_.clear();
  row_.reserve(pattern.row.size() + extra.size());
  auto next = extra.begin();
  for (Index j = 0; j < pattern.size; ++j) {
    const auto begin = pattern.row.begin() + pattern.column_start[j];
    const auto end = pattern.row.begin() + pattern.column_start[j + 1];
    row_.insert(row_.end(), begin, end);
    for (; next != extra.end() && next->first == j; ++next)
      if (!std::binary_search(begin, end, next->second)) row_.push_back(next->second);
    column_start_.push_back(static_cast<Index>(row_.size()));
  }
  value_.clear();
}

cholmod_sparse Cholesky::view() const {
  cholmod_sparse matrix{};
  matrix.nrow = matrix.ncol = static_cast<std::size_t>(size());
  matrix.nzmax = row_.size();
  // CHOLMOD's interface knows no const; it only reads.
  matrix.p = const_cast<Index*>(column_start_.data());
  matrix.i = const_cast<Index*>(row_.data());
  matrix.x = value_.empty() ? nullptr : const_cast<double*>(value_.data());
  matrix.stype = -1;
  matrix.itype = CHOLMOD_INT;
  matrix.xtype = value_.empty() ? CHOLMOD_PATTERN : CHOLMOD_REAL;
  matrix.packed = 1;
  return matrix;
}

void Cholesky::analyse_order(Ordering& ordering) {
  common_->nmethods = 1;
  common_->method[0].ordering = CHOLMOD_GIVEN;
  common_->postorder = 1;
  cholmod_sparse matrix = view();
  factor_.reset(cholmod_analyze_p(&matrix, ordering.unknown.data(), nullptr, 0, common_));
  if (!factor_) {
    trouble_ = common_->status == CHOLMOD_TOO_LARGE
                   ? "the factor has more entries than 32-bit numbers can count"
                   : "not enough memory to analyse the matrix";
    return;
  }
  [[maybe_unused]] const auto* place = static_cast<const int*>(factor_->Perm);
  assert(std::equal(kept_.begin(), kept_.end(), place + interior()));
}

FactorReport Cholesky::factor(const SymmetricMatrix& matrix) {
  FactorReport report;
  report.ordering = ordering_;
  report.reason = trouble_;
  if (!factor_) return report;
  report.entries = common_->lnz;
  report.flops = common_->fl;
  assert(matrix.pattern.size == size());
  // Zeros stay where structure was added; the diagonal comes first in every column.
  value_.assign(row_.size(), 0.0);
  for (Index j = 0; j < size(); ++j)
    std::copy(matrix.value.begin() + matrix.pattern.column_start[j],
              matrix.value.begin() + matrix.pattern.column_start[j + 1], value_.begin() + column_start_[j]);
  shift_.clear();
  for (const Index k : kept_) {
    shift_.push_back(value_[column_start_[k]]);
    value_[column_start_[k]] += shift_.back();
  }
  const OneThread one_thread;
  cholmod_sparse a = view();
  const bool room = reserve_blas_memory();
  if (room) cholmod_factorize(&a, factor_.get(), common_);
  if (!room || common_->status == CHOLMOD_OUT_OF_MEMORY || common_->status == CHOLMOD_TOO_LARGE) {
    report.reason = "not enough memory to factor " + std::to_string(size()) + " unknowns";
    return report;
  }
  report.done = !breakdown(report);
  if (report.done && !kept_.empty()) extract_kept_factor();
  return report;
}

bool Cholesky::breakdown(FactorReport& report) const {
  const auto* unknown = static_cast<const int*>(factor_->Perm);
  if (factor_->minor < factor_->n) {
    report.unknown = unknown[factor_->minor];
    report.reason = "the matrix is not positive definite: a body is free to move, or a stiffness is negative";
    return true;
  }
  const Supernodes nodes(*factor_);
  for (Index s = 0; s < nodes.count; ++s)
    for (Index j = nodes.first_column[s]; j < nodes.first_column[s + 1]; ++j) {
      const double pivot = nodes.column(s, j)[j - nodes.first_column[s]];
      if (pivot * pivot > vanished_pivot * value_[column_start_[unknown[j]]]) continue;
      report.unknown = unknown[j];
      report.reason = "the matrix is singular to working accuracy: a body is free to move";
      return true;
    }
  return false;
}

void Cholesky::extract_kept_factor() {
  const Index from = interior(), count = static_cast<Index>(kept_.size());
  kept_factor_.setZero(count, count);
  const Supernodes nodes(*factor_);
  for (Index s = 0; s < nodes.count; ++s)
    for (Index j = std::max(from, nodes.first_column[s]); j < nodes.first_column[s + 1]; ++j)
      for (Index r = j - nodes.first_column[s]; r < nodes.rows(s); ++r)
        kept_factor_(nodes.row[nodes.rows_at[s] + r] - from, j - from) = nodes.column(s, j)[r];
  schur_ = times_transposed(kept_factor_);
  for (Index k = 0; k < count; ++k) schur_(k, k) -= shift_[static_cast<std::size_t>(k)];
}

void Cholesky::solve(std::span<const double> b, std::span<double> x) const {
  assert(kept_.empty() && b.size() == static_cast<std::size_t>(size()) && x.size() == b.size());
  std::copy(b.begin(), b.end(), x.begin());
  const OneThread one_thread;
  cholmod_dense right = ashlar::suitesparse::view(x.data(), x.size());
  if (!cholmod_solve2(CHOLMOD_A, factor_.get(), &right, nullptr, &solution_, nullptr, &y_, &e_, common_))
    throw std::bad_alloc();
  std::memcpy(x.data(), solution_->x, x.size() * sizeof(double));
}

Eigen::VectorXd Cholesky::condense(std::span<const double> b, std::vector<double>& work) const {
  assert(b.size() == static_cast<std::size_t>(size()));
  const auto* unknown = static_cast<const int*>(factor_->Perm);
  work.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) work[i] = b[unknown[i]];
  solve_lower(Supernodes(*factor_), work);
  // L y = b: what is left for the kept unknowns is L_kk y_k = b_k − L_ki y_i.
  const Eigen::Map<const Eigen::VectorXd> y(work.data() + interior(), static_cast<Index>(kept_.size()));
  return kept_factor_.triangularView<Eigen::Lower>() * y;
}

void Cholesky::expand(const std::vector<double>& work, const Eigen::VectorXd& kept_values,
                      std::span<double> x) const {
  assert(work.size() == static_cast<std::size_t>(size()) && x.size() == work.size());
  // L_iiᵀ x_i = y_i − L_kiᵀ x_k: the whole Lᵀ is solved with L_kkᵀ x_k as its last block.
  std::vector<double> values = work;
  Eigen::Map<Eigen::VectorXd>(values.data() + interior(), kept_values.size()) =
      kept_factor_.transpose().triangularView<Eigen::Upper>() * kept_values;
  solve_lower_transposed(Supernodes(*factor_), values);
  const auto* unknown = static_cast<const int*>(factor_->Perm);
  for (std::size_t i = 0; i < values.size(); ++i) x[unknown[i]] = values[i];
  for (std::size_t k = 0; k < kept_.size(); ++k) x[kept_[k]] = kept_values[static_cast<Index>(k)];
}

std::size_t Cholesky::bytes() const {
  std::size_t sum = sizeof(Index) * (column_start_.capacity() + row_.capacity() + kept_.capacity()) +
                    sizeof(double) * (value_.capacity() + shift_.capacity());
  sum += sizeof(double) * static_cast<std::size_t>(kept_factor_.size() + schur_.size());
  if (factor_)
    sum += factor_->xsize * sizeof(double) + factor_->ssize * sizeof(int) + 2 * factor_->n * sizeof(int);
  return sum;
}

}  // namespace ashlar::suitesparse
