// SPDX-License-Identifier: Apache-2.0
// The matrix of ratios of 1,000 x 1,000 AABBs through the shared library, beside a loop by hand, drawn anew each round.
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "batch/contest.hpp"
#include "relation/report.hpp"
#include "workloads.hpp"

namespace vesica::bench {
namespace {

using Box = vesica_aabb_f64;

constexpr std::size_t side = 1000;

/// AABBs 1 to 3 wide and high, scattered over a square this wide.
std::vector<Box> scattered(double width, Random& random) {
  std::vector<Box> boxes(side);
  for (Box& box : boxes) {
    box = {random.between(0, width), random.between(0, width), 0, 0};
    box.max_x = box.min_x + random.between(1, 3);
    box.max_y = box.min_y + random.between(1, 3);
  }
  return boxes;
}

struct Round {
  std::vector<Box> a, b;
  std::vector<double> library = std::vector<double>(side * side), by_hand = std::vector<double>(side * side);
};

std::int64_t by_library(Round& round) {
  vesica_shapes_f64 a, b;
  vesica_shapes_from_records_f64(VESICA_AABB, side, round.a.data(), sizeof round.a[0], &a);
  vesica_shapes_from_records_f64(VESICA_AABB, side, round.b.data(), sizeof round.b[0], &b);
  return vesica_iou_matrix_f64(&a, &b, round.library.data(), side);
}

/// As users write it, with the columns of b side by side.
std::int64_t by_hand(Round& round) {
  std::vector<double> x0(side), y0(side), x1(side), y1(side), area(side);
  for (std::size_t j = 0; j < side; ++j) {
    const Box& q = round.b[j];
    x0[j] = q.min_x, y0[j] = q.min_y, x1[j] = q.max_x, y1[j] = q.max_y;
    area[j] = (q.max_x - q.min_x) * (q.max_y - q.min_y);
  }
  for (std::size_t i = 0; i < side; ++i) {
    const Box p = round.a[i];
    const double area_p = (p.max_x - p.min_x) * (p.max_y - p.min_y);
    double* const row = &round.by_hand[i * side];
    for (std::size_t j = 0; j < side; ++j) {
      const double w = std::min(p.max_x, x1[j]) - std::max(p.min_x, x0[j]);
      const double h = std::min(p.max_y, y1[j]) - std::max(p.min_y, y0[j]);
      const double shared = std::max(w, 0.0) * std::max(h, 0.0);
      row[j] = shared / (area_p + area[j] - shared);
    }
  }
  return static_cast<std::int64_t>(round.by_hand[0]);
}

}  // namespace

void report_iou_of_aabbs(std::FILE* out) {
  for (const double width : {100.0, 20.0, 3.0}) {
    Round round;
    double worst = 0, hits = 0;
    const auto begin = [&](std::uint64_t number) {
      Random random(seed_of_run() + number);
      round.a = scattered(width, random);
      round.b = scattered(width, random);
    };
    const std::vector<Times> times = contest(begin, {[&] { return by_library(round); }, [&] { return by_hand(round); }},
                                             {.seconds = 0.5, .rounds = 25});
    for (std::size_t i = 0; i < side * side; ++i) {
      worst = std::max(worst, std::fabs(round.library[i] - round.by_hand[i]));
      hits += round.library[i] > 0;
    }
    std::fprintf(out, "%-10s %6.3f %8.2f %8.2f %8.2f %11.1e\n", vesica_isa_name(), hits / (side * side),
                 median(times[0]) / (side * side), median(times[1]) / (side * side), median(ratios(times[1], times[0])),
                 worst);
  }
}

void print_iou_of_aabbs_heading(std::FILE* out) {
  std::fprintf(
      out,
      "\nMatrix of 1,000 x 1,000 ratios of AABBs in double, beside a loop by hand: nanoseconds a pair, medians "
      "over rounds on\nfresh AABBs, and the largest difference.\n\n%-10s %6s %8s %8s %8s %11s\n",
      "set", "hits", "vesica", "by hand", "ratio", "difference");
  std::fflush(out);
}

}  // namespace vesica::bench
