// SPDX-License-Identifier: Apache-2.0
// The matrix of ratios of 1,000 x 1,000 turned rectangles through the shared library, beside the usual rotated-IoU
// algorithm in float and Boost.Geometry, which answer whole rows of the same matrix, drawn anew each round.
#include <vesica.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "batch/contest.hpp"
#include "relation/area_peer.hpp"
#include "relation/report.hpp"
#include "textbook/rotated_area.hpp"
#include "workloads.hpp"

namespace vesica::bench {
namespace {

using Textbook = textbook::RotatedArea<vesica_rect_f32>;

constexpr std::size_t side = 1000, rows_of_textbook = 16, rows_of_boost = 4;

/// Rectangles 1 to 3 wide and high, scattered over a square this wide.
struct Data {
  const char* name;
  double width;
};
constexpr Data all_data[] = {{"detections", 20}, {"dense", 3}};

/// The least ratios to the yardsticks, on AVX-512.
constexpr double textbook_target = 20, boost_target = 50;

using Rects = std::vector<vesica_rect_f32>;

Rects scattered(double width, Random& random) {
  Rects rects;
  for (std::size_t i = 0; i < side; ++i) {
    const double angle = random.between(0, 6.283185307179586);
    rects.push_back(to_shape<vesica_rect_f32>({random.between(0, width), random.between(0, width), std::cos(angle),
                                               std::sin(angle), random.between(0.5, 1.5), random.between(0.5, 1.5)}));
  }
  return rects;
}

Numbers numbers(const vesica_rect_f32& r) { return {r.cx, r.cy, r.ux, r.uy, r.hx, r.hy}; }

/// One round's rectangles, and what everyone says of them.
struct Round {
  Rects a, b;
  std::array<std::size_t, rows_of_textbook> rows{};  ///< those that are asked of the yardsticks
  std::vector<float> library = std::vector<float>(side * side);
  std::vector<float> textbook = std::vector<float>(rows_of_textbook * side);
  std::vector<double> boost = std::vector<double>(rows_of_boost * side);
  BoostRows polygons;
};

void prepare(Round& round, double width, std::uint64_t number) {
  Random random(seed_of_run() + number);
  round.a = scattered(width, random);
  round.b = scattered(width, random);
  for (std::size_t& row : round.rows) row = static_cast<std::size_t>(random.integer(0, side - 1));
  round.polygons = BoostRows();
  for (std::size_t i = 0; i < rows_of_boost; ++i) round.polygons.add_row(numbers(round.a[round.rows[i]]));
  for (const vesica_rect_f32& rect : round.b) round.polygons.add_column(numbers(rect));
}

std::int64_t by_library(Round& round) {
  vesica_shapes_f32 a, b;
  vesica_shapes_from_records_f32(VESICA_RECT, side, round.a.data(), sizeof round.a[0], &a);
  vesica_shapes_from_records_f32(VESICA_RECT, side, round.b.data(), sizeof round.b[0], &b);
  return vesica_iou_matrix_f32(&a, &b, round.library.data(), side);
}

std::int64_t by_textbook(Round& round) {
  for (std::size_t i = 0; i < rows_of_textbook; ++i) {
    for (std::size_t j = 0; j < side; ++j)
      round.textbook[i * side + j] = Textbook::iou(round.a[round.rows[i]], round.b[j]);
  }
  return static_cast<std::int64_t>(round.textbook[0]);
}

std::int64_t by_boost(Round& round) {
  for (std::size_t i = 0; i < rows_of_boost; ++i) {
    for (std::size_t j = 0; j < side; ++j) round.boost[i * side + j] = round.polygons.iou(i, j);
  }
  return static_cast<std::int64_t>(round.boost[0]);
}

/// Sums of the ratios on the rows that all answer.
struct Sums {
  double library = 0, textbook = 0, boost = 0, hits = 0;
};

void add_sums(const Round& round, Sums& sums) {
  for (std::size_t i = 0; i < rows_of_boost; ++i) {
    for (std::size_t j = 0; j < side; ++j) {
      const float ratio = round.library[round.rows[i] * side + j];
      sums.library += static_cast<double>(ratio);
      sums.textbook += static_cast<double>(round.textbook[i * side + j]);
      sums.boost += round.boost[i * side + j];
      sums.hits += ratio > 0;
    }
  }
}

const char* verdict(double ratio, double target) {
  const char* isa = vesica_isa_name();
  const bool has_target = isa[0] == 'a' && isa[1] == 'v' && isa[2] == 'x' && isa[3] == '5';
  return !has_target ? "" : ratio >= target ? "met" : "MISSED";
}

void report(std::FILE* out, const Data& data) {
  Round round;
  Sums sums;
  std::uint64_t seen = 0;
  const auto begin = [&](std::uint64_t number) {
    if (number == seen && !round.a.empty()) return;
    if (!round.a.empty()) add_sums(round, sums);
    seen = number;
    prepare(round, data.width, number);
  };
  const std::vector<Times> times = contest(
      begin, {[&] { return by_library(round); }, [&] { return by_textbook(round); }, [&] { return by_boost(round); }},
      {.seconds = 0.5, .rounds = 25, .long_passes = true});
  add_sums(round, sums);
  const double library = median(times[0]) / (side * side);
  const double textbook_ratio = median(ratios(times[1], times[0])) * side / rows_of_textbook;
  const double boost_ratio = median(ratios(times[2], times[0])) * side / rows_of_boost;
  std::fprintf(out, "%-10s %-10s %6.3f %8.2f %10.1f %8.1f %-7s %10.0f %8.0f %-7s %11.1e %11.1e\n", vesica_isa_name(),
               data.name, sums.hits / static_cast<double>(rows_of_boost * side * (seen + 1)), library,
               median(times[1]) / (rows_of_textbook * side), textbook_ratio, verdict(textbook_ratio, textbook_target),
               median(times[2]) / (rows_of_boost * side), boost_ratio, verdict(boost_ratio, boost_target),
               sums.textbook / sums.library - 1, sums.boost / sums.library - 1);
}

}  // namespace

void print_iou_matrix_heading(std::FILE* out) {
  std::fprintf(
      out,
      "\nMatrix of 1,000 x 1,000 ratios of turned rectangles in float: nanoseconds a pair, medians over rounds "
      "on fresh rectangles;\nsums: of each one's ratios to the library's, less 1. Targets: %.0f and %.0f times "
      "on AVX-512.\n\n%-10s %-10s %6s %8s %10s %8s %-7s %10s %8s %-7s %11s %11s\n",
      textbook_target, boost_target, "set", "data", "hits", "vesica", "textbook", "ratio", "", "boost", "ratio", "",
      "sums", "sums");
  std::fflush(out);
}

void report_iou_matrix(std::FILE* out) {
  for (const Data& data : all_data) report(out, data);
}

}  // namespace vesica::bench
