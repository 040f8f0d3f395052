// SPDX-License-Identifier: Apache-2.0
/// Fresh pairs of one relation for the tables of this folder, and how a call on them is timed.
#pragma once

#include <vesica.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "quantile.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "workloads.hpp"

namespace vesica::bench {

struct OutlinePair {
  Numbers a, b;
};

enum class Relative { disjoint, crossing, nested, overlapping };

inline const char* name_of(Relative relative) {
  constexpr const char* names[] = {"disjoint", "crossing", "nested", "overlapping"};
  return names[static_cast<int>(relative)];
}

inline bool is(Relative relative, std::int32_t relation) {
  switch (relative) {
    case Relative::disjoint:
      return relation == VESICA_DISJOINT;
    case Relative::crossing:
      return relation == VESICA_CROSS;
    case Relative::nested:
      return relation == VESICA_CONTAINS;
    default:
      return relation != VESICA_DISJOINT;
  }
}

/// Half lengths about 1, the shorter down to 1 / aspect of the longer, evenly in its logarithm.
inline Numbers random_shape(std::int32_t kind, double aspect, double x, double y, double size, Random& random) {
  const double angle = random.between(0, 6.283185307179586), longer = size * random.between(0.5, 1);
  if (kind == VESICA_CIRCLE) return {x, y, longer};
  return {x, y, std::cos(angle), std::sin(angle), longer, longer * std::exp2(-random.unit() * std::log2(aspect))};
}

/// For nested ones the inner shape is shrunk until it is inside.
inline OutlinePair draw_pair(std::int32_t kind_a, std::int32_t kind_b, Relative relative, double aspect,
                             Random& random) {
  const double spread = relative == Relative::nested ? 0.3 : relative == Relative::disjoint ? 3 : 1;
  for (;;) {
    OutlinePair p{random_shape(kind_a, aspect, 0, 0, 1, random), {}};
    double size = 1, x = random.between(-spread, spread), y = random.between(-spread, spread);
    p.b = random_shape(kind_b, aspect, x, y, size, random);
    for (int i = 0; i < (relative == Relative::nested ? 30 : 1); ++i) {
      if (is(relative, vesica_relation_f64(kind_a, p.a.data(), kind_b, p.b.data()))) return p;
      for (std::size_t k = kind_b == VESICA_CIRCLE ? 2 : 4; k < (kind_b == VESICA_CIRCLE ? 3 : 6); ++k) p.b[k] *= 0.7;
      p.b[0] *= 0.8, p.b[1] *= 0.8;
    }
  }
}

inline std::vector<OutlinePair> draw_pairs(std::int32_t kind_a, std::int32_t kind_b, Relative relative, double aspect,
                                           std::size_t count) {
  Random random(seed_of_run());
  std::vector<OutlinePair> pairs;
  while (pairs.size() < count) pairs.push_back(draw_pair(kind_a, kind_b, relative, aspect, random));
  return pairs;
}

/// Median nanoseconds a call. Each pass is over other pairs, so that no branch predictor learns them.
template <class Call>
double nanoseconds(const std::vector<OutlinePair>& pairs, const Call& call) {
  using Clock = std::chrono::steady_clock;
  constexpr std::size_t a_pass = 256;
  std::vector<double> times;
  double sum = 0;
  for (std::size_t first = 0; first + a_pass <= pairs.size(); first += a_pass) {
    const Clock::time_point start = Clock::now();
    for (std::size_t i = first; i < first + a_pass; ++i) sum += call(pairs[i]);
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count() / a_pass);
  }
  volatile double used = sum;
  static_cast<void>(used);
  return median(std::move(times));
}

inline constexpr std::size_t pairs_timed = 16384, pairs_checked = 200;

struct OutlineRow {
  std::int32_t kind_a, kind_b;
  Relative relative;
  double aspect;
};

/// Nanoseconds a pair, called and in batches, and the worst error in 2^-53 scale.
struct OutlineFigures {
  double time, batch_time, error;
};

inline void print_head(std::FILE* out, const char* name) {
  std::fprintf(out,
               "\n%s on fresh pairs: ns a call, ns a pair in batches, their ratio, and the worst error of %zu in 2^-53 "
               "scale\n",
               name, pairs_checked);
  std::fprintf(out, "%-9s%-9s%-12s%7s %9s %9s %7s %8s\n", "a", "b", "pairs", "aspect", "ns", "batch", "ratio", "error");
}
inline void print_row(std::FILE* out, const OutlineRow& row, const OutlineFigures& f) {
  std::fprintf(out, "%-9s%-9s%-12s%7.0e %9.0f %9.1f %7.1f %8.2f\n", vesica_kind_name(row.kind_a),
               vesica_kind_name(row.kind_b), name_of(row.relative), row.aspect, f.time, f.batch_time,
               f.time / f.batch_time, f.error);
}

}  // namespace vesica::bench
