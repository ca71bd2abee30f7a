#pragma once
// CHOLMOD's objects as C++ values.

#include <memory>

#include <cholmod.h>

namespace ashlar::suitesparse {

/// CHOLMOD's settings and workspace; supernodal, one thread, silent.
class Common {
 public:
  Common();
  ~Common() { cholmod_finish(&common_); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
  operator cholmod_common*() { return &common_; }
  cholmod_common* operator->() { return &common_; }

 private:
  cholmod_common common_;
};

/// Frees with the Common that made it; which must live longer.
struct FreeFactor {
  Common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, *common); }
};
using Factor = std::unique_ptr<cholmod_factor, FreeFactor>;

/// Holds CHOLMOD's own parallel loops and OpenBLAS to one thread while it lives: the sums of a factorisation
/// then do not depend on the machine, and short runs waste no processor time on waiting threads.
class OneThread {
 public:
  OneThread();
  ~OneThread();
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int blas_threads_, levels_;
};

/// Makes OpenBLAS take the working memory that it then keeps. False if there is not enough: OpenBLAS would
/// ask for it again and again, for ever (blas_memory_alloc of version 0.3.21).
bool reserve_blas_memory();

}  // namespace ashlar::suitesparse
