#include "core/parallel.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace ashlar::core {

namespace {

thread_local bool inside_loop = false;

/// Threads that wait for the next loop. Range r of a loop always goes to thread r; range 0 to the caller.
class Pool {
 public:
  ~Pool() { resize(1); }

  int size() const { return static_cast<int>(workers_.size()) + 1; }

  void resize(int threads) {
    {
      const std::lock_guard lock(mutex_);
      leaving_ = true;
    }
    wake_.notify_all();
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
    leaving_ = false;
    try {
      for (int i = 1; i < threads; ++i)
        workers_.emplace_back([this, i, seen = generation_] { serve(static_cast<std::size_t>(i), seen); });
    } catch (const std::system_error&) {
      // The system gives no more threads: those that there are do the work, with the same results.
    }
  }

  void run(std::size_t count, std::size_t ranges, const std::function<void(std::size_t, std::size_t)>& body) {
    {
      const std::lock_guard lock(mutex_);
      body_ = &body;
      count_ = count;
      ranges_ = ranges;
      errors_.assign(ranges, nullptr);
      running_ = ranges - 1;
      ++generation_;
    }
    wake_.notify_all();
    do_range(0);
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return running_ == 0; });
    for (const std::exception_ptr& error : errors_)
      if (error) std::rethrow_exception(error);
  }

 private:
  void do_range(std::size_t range) {
    inside_loop = true;
    try {
      (*body_)(count_ * range / ranges_, count_ * (range + 1) / ranges_);
    } catch (...) {
      errors_[range] = std::current_exception();
    }
    inside_loop = false;
  }

  void serve(std::size_t range, std::size_t seen) {
    for (;;) {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [&] { return leaving_ || generation_ != seen; });
      if (leaving_) return;
      seen = generation_;
      if (range >= ranges_) continue;
      lock.unlock();
      do_range(range);
      lock.lock();
      if (--running_ == 0) done_.notify_one();
    }
  }

  std::vector<std::thread> workers_;
  std::mutex mutex_;
  std::condition_variable wake_, done_;
  const std::function<void(std::size_t, std::size_t)>* body_ = nullptr;
  std::size_t count_ = 0, ranges_ = 0, running_ = 0, generation_ = 0;
  std::vector<std::exception_ptr> errors_;
  bool leaving_ = false;
};

Pool& pool() {
  static Pool instance;
  return instance;
}

std::mutex busy;

}  // namespace

int thread_count() {
  return pool().size();
}

void set_thread_count(int threads) {
  const std::lock_guard lock(busy);
  if (std::max(1, threads) != pool().size()) pool().resize(std::max(1, threads));
}

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body) {
  if (count == 0) return;
  // A loop inside a loop, or beside another one, runs on its own thread.
  std::unique_lock lock(busy, std::defer_lock);
  const bool alone = inside_loop || !lock.try_lock();
  const std::size_t most = alone ? 1 : static_cast<std::size_t>(pool().size());
  const std::size_t ranges = std::min(most, count / std::max<std::size_t>(1, grain));
  if (ranges > 1) return pool().run(count, ranges, body);
  if (lock.owns_lock()) lock.unlock();
  body(0, count);
}

}  // namespace ashlar::core
