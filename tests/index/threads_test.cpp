// SPDX-License-Identifier: Apache-2.0
/// Four threads build one index by steps and join its parts: nothing is written by one and read by another but across a
/// barrier (the thread sanitizer sees it), and bytes and pairs are those of one thread.
#include <gtest/gtest.h>

#include <thread>

#include "index/face.hpp"

namespace index_tests {
namespace {

template <class Work>
void in_threads(std::int64_t threads, Work work) {
  std::vector<std::thread> all;
  for (std::int64_t i = 0; i < threads; ++i) all.emplace_back([&work, i] { work(i); });
  for (std::thread& t : all) t.join();
}

TEST(Threads, BuildAndJoin) {
  const Laid<double> laid = mixed<double>("decades_3", 20000, 1);
  const Indexed<double> whole{Laid<double>(laid)};
  const Sets<double> sets(laid);
  const Memory index(vesica_index_size(sets.items)), scratch(vesica_index_scratch(sets.items));
  for (std::int32_t step = 0; step < 5; ++step) {
    const std::int64_t parts = step == 0 || step == 4 ? 1 : 4;
    in_threads(parts, [&](std::int64_t part) {
      EXPECT_GE(vesica_index_step_f64(step, part, parts, sets.data(), sets.count(), index.get(), index.size,
                                      scratch.get(), scratch.size),
                0);
    });
  }
  ASSERT_EQ(std::memcmp(index.get(), whole.index.get(), static_cast<std::size_t>(whole.result)), 0);
  std::vector<Pair> parts[8], all;
  in_threads(4, [&](std::int64_t i) {
    for (const std::int64_t part : {i, i + 4}) parts[part] = join(VESICA_JOIN_OVERLAP, whole, whole, part, 8, 1000);
  });
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  EXPECT_TRUE(all == join(VESICA_JOIN_OVERLAP, whole, whole));
}

}  // namespace
}  // namespace index_tests
