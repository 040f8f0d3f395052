// SPDX-License-Identifier: Apache-2.0
// Several threads at once, on shared input, get the answers of one alone: every function is reentrant. What is wrong
// with them together is for the thread sanitizer to see (sanitize.sh).
#include <gtest/gtest.h>
#include <vesica.h>

#include <array>
#include <cstdint>
#include <thread>
#include <vector>

namespace {

constexpr int side = 24, count = side * side, thread_count = 4;
const std::array<double, 6> ellipse{0.5, 0.25, 0.6, 0.8, 3, 1.5};

/// Circles of a lattice about the ellipse: disjoint, touching nearly, crossing and inside.
std::vector<vesica_circle_f64> circles() {
  std::vector<vesica_circle_f64> result;
  for (int i = 0; i < count; ++i) {
    result.push_back(
        {static_cast<double>(i % side) / 3 - 4, static_cast<double>(i / side) / 3 - 4, 0.25 + i % 5 / 8.0});
  }
  return result;
}

struct Answers {
  std::vector<std::uint8_t> overlap = std::vector<std::uint8_t>(count), relation = std::vector<std::uint8_t>(count);
  std::vector<double> area = std::vector<double>(count), depth = std::vector<double>(count);
  std::int64_t overlaps = 0, scalar_overlaps = 0, scalar_relations = 0;
  bool operator==(const Answers&) const = default;
};

Answers ask(const std::vector<vesica_circle_f64>& discs) {
  Answers answers;
  vesica_shapes_f64 a, b;
  vesica_shapes_from_records_f64(VESICA_ELLIPSE, 1, ellipse.data(), 0, &a);  // one against each circle
  vesica_shapes_from_records_f64(VESICA_CIRCLE, count, discs.data(), sizeof discs[0], &b);
  answers.overlaps = vesica_overlap_many_f64(&a, &b, answers.overlap.data());
  vesica_relation_many_f64(&a, &b, answers.relation.data());
  vesica_area_many_f64(&a, &b, answers.area.data());
  vesica_depth_many_f64(&a, &b, answers.depth.data(), nullptr, nullptr);
  for (const vesica_circle_f64& disc : discs) {
    const double numbers[] = {disc.cx, disc.cy, disc.r};
    answers.scalar_overlaps += vesica_overlap_f64(VESICA_ELLIPSE, ellipse.data(), VESICA_CIRCLE, numbers);
    answers.scalar_relations += vesica_relation_f64(VESICA_ELLIPSE, ellipse.data(), VESICA_CIRCLE, numbers);
  }
  return answers;
}

TEST(Threads, AnswerAsOneAlone) {
  const std::vector<vesica_circle_f64> discs = circles();
  std::array<Answers, thread_count> answers;
  std::vector<std::thread> threads;
  // The threads' calls come first: what a first call does, it does among them.
  for (Answers& own : answers) threads.emplace_back([&] { own = ask(discs); });
  for (std::thread& thread : threads) thread.join();
  const Answers alone = ask(discs);
  EXPECT_GT(alone.overlaps, 0);
  EXPECT_LT(alone.overlaps, count);
  EXPECT_EQ(alone.overlaps, alone.scalar_overlaps);
  for (const Answers& own : answers) EXPECT_TRUE(own == alone);
}

}  // namespace
