#include "suitesparse/common.hpp"

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

}  // namespace ashlar::suitesparse
