#include "suitesparse/common.hpp"

#include <atomic>
#include <cstdlib>

#include <cblas.h>
#include <omp.h>

namespace ashlar::suitesparse {

Common::Common() {
  cholmod_start(&common_);
  common_.supernodal = CHOLMOD_SUPERNODAL;
  common_.final_ll = 1;
  common_.print = 0;
  common_.error_handler = nullptr;
}

// CHOLMOD asks for four threads by name in its loops; only a limit of no parallel levels overrides that.
OneThread::OneThread() : blas_threads_(openblas_get_num_threads()), levels_(omp_get_max_active_levels()) {
  openblas_set_num_threads(1);
  omp_set_max_active_levels(0);
}

OneThread::~OneThread() {
  openblas_set_num_threads(blas_threads_);
  omp_set_max_active_levels(levels_);
}

bool reserve_blas_memory() {
  static std::atomic<bool> reserved = false;
  if (reserved) return true;
  constexpr std::size_t enough = std::size_t{160} << 20;  // OpenBLAS takes 128 MB and a little
  void* room = std::malloc(enough);
  if (!room) return false;
  std::free(room);
  double one = 1;
  cblas_dsyrk(CblasColMajor, CblasLower, CblasNoTrans, 1, 1, 1.0, &one, 1, 0.0, &one, 1);
  reserved = true;
  return true;
}

}  // namespace ashlar::suitesparse
