#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace ashlar::core {
namespace {

class Parallel : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_thread_count(GetParam()); }
  void TearDown() override { set_thread_count(1); }
};

TEST_P(Parallel, covers_every_index_once) {
  EXPECT_EQ(thread_count(), GetParam());
  for (const std::size_t count : {0u, 1u, 2u, 7u, 1000u, 12345u}) {
    std::vector<int> visits(count, 0);
    parallel_for(count, 3, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

TEST_P(Parallel, small_loops_stay_together) {
  std::atomic<int> calls = 0;
  parallel_for(99, 50, [&](std::size_t, std::size_t) { ++calls; });
  EXPECT_EQ(calls, 1);
}

TEST_P(Parallel, the_first_exception_by_index_is_rethrown) {
  for (int attempt = 0; attempt < 50; ++attempt) {
    try {
      parallel_for(1000, 1, [](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (i >= 137) throw std::runtime_error(std::to_string(i));
      });
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "137");
    }
  }
}

TEST_P(Parallel, loops_nest) {
  std::vector<int> visits(64 * 64, 0);
  parallel_for(64, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      parallel_for(64, 1, [&, i](std::size_t b, std::size_t e) {
        for (std::size_t j = b; j < e; ++j) ++visits[64 * i + j];
      });
  });
  EXPECT_EQ(visits, std::vector<int>(64 * 64, 1));
}

INSTANTIATE_TEST_SUITE_P(threads, Parallel, ::testing::Values(1, 2, 3, 8));

}  // namespace
}  // namespace ashlar::core
