// SPDX-License-Identifier: Apache-2.0
// Relation, containment and overlap of insides beside overlap, each by kind through the shared library, on the same
// fresh pairs, one straight after the other.
#include <vesica.h>

#include <array>
#include <chrono>
#include <cinttypes>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "quantile.hpp"
#include "relation/report.hpp"
#include "workloads.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Function = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*);

constexpr std::size_t pairs_per_pass = 256;
constexpr int passes = 400;
constexpr double target = 2;

/// The pool's own pairs, or those with one shape a quarter the size and moved into the other: about half are contained.
enum class Data { mixed, sparse, near, nested };
constexpr std::array all_data{Data::mixed, Data::sparse, Data::near, Data::nested};

const char* name_of(Data data) {
  constexpr std::array names{"mixed", "sparse", "near", "nested"};
  return names.at(static_cast<std::size_t>(data));
}

Workload workload_of(Data data) {
  return data == Data::sparse ? Workload::sparse : data == Data::near ? Workload::near : Workload::mixed;
}

/// The shape at a quarter of its size with its first number's place at (x, y).
Numbers shrunk_to(std::int32_t kind, Numbers n, double x, double y) {
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB) return {x, y, x + (n[2] - n[0]) / 4, y + (n[3] - n[1]) / 4};
  if (kind == VESICA_CIRCLE) return {x, y, n[2] / 4};
  if (kind == VESICA_CAPSULE) return {x, y, x + (n[2] - n[0]) / 4, y + (n[3] - n[1]) / 4, n[4] / 4};
  return {x, y, n[2], n[3], n[4] / 4, n[5] / 4, n[6] / 4};
}

struct Kinds {
  std::int32_t a, b;
};

struct Pairs {
  std::array<Numbers, pairs_per_pass> a, b;
};

void draw(const Pool& pool, const Kinds& kinds, Data data, Random& random, Pairs& pairs) {
  for (std::size_t i = 0; i < pairs_per_pass; ++i) {
    const std::size_t index = random.index(pool.a.size());
    pairs.a[i] = pool.a[index];
    pairs.b[i] = pool.b[pool.matched ? index : random.index(pool.b.size())];
    if (data != Data::nested) continue;
    const double reach = random.between(0, 1);
    const bool b_shrinks = random.chance(0.5);
    Numbers& inner = b_shrinks ? pairs.b[i] : pairs.a[i];
    const Numbers& outer = b_shrinks ? pairs.a[i] : pairs.b[i];
    inner = shrunk_to(b_shrinks ? kinds.b : kinds.a, inner, outer[0] + reach * random.between(-1, 1),
                      outer[1] + reach * random.between(-1, 1));
  }
}

double nanoseconds_a_call(Function function, const Kinds& kinds, const Pairs& pairs, std::int64_t& sum) {
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < pairs_per_pass; ++i) {
    sum += function(kinds.a, pairs.a[i].data(), kinds.b, pairs.b[i].data());
  }
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / pairs_per_pass;
}

struct Row {
  double overlap, relation, contains, interiors, ratio, contains_ratio, interiors_ratio;
  double overlapping, contained;  ///< shares of the pairs
};

Row measure(const Kinds& kinds, Data data) {
  const Pool pool = make_pool(kinds.a, kinds.b, workload_of(data), seed_of_run());
  Random random(seed_of_run());
  Pairs pairs{};
  std::array<std::vector<double>, 7> times;
  std::int64_t sum = 0, overlapping = 0, contained = 0;
  constexpr std::array functions{vesica_overlap_f64, vesica_relation_f64, vesica_contains_f64,
                                 vesica_interiors_overlap_f64};
  for (int pass = 0; pass < passes; ++pass) {
    std::array<double, 4> now{};
    for (int k = 0; k < 4; ++k) {
      // Each meets pairs it has not seen, in the same buffers; who goes first takes turns.
      draw(pool, kinds, data, random, pairs);
      const auto which = static_cast<std::size_t>((pass + k) % 4);
      now[which] = nanoseconds_a_call(functions[which], kinds, pairs, sum);
    }
    for (std::size_t i = 0; i < 4; ++i) times[i].push_back(now[i]);
    for (std::size_t i = 1; i < 4; ++i) times[3 + i].push_back(now[i] / now[0]);
    for (std::size_t i = 0; i < pairs_per_pass; ++i) {
      const std::int32_t code = vesica_relation_f64(kinds.a, pairs.a[i].data(), kinds.b, pairs.b[i].data());
      overlapping += code != VESICA_DISJOINT;
      contained += code >= VESICA_INSIDE;
    }
  }
  volatile std::int64_t used = sum;
  static_cast<void>(used);
  constexpr double all = static_cast<double>(pairs_per_pass) * passes;
  return {median(times[0]),
          median(times[1]),
          median(times[2]),
          median(times[3]),
          median(times[4]),
          median(times[5]),
          median(times[6]),
          static_cast<double>(overlapping) / all,
          static_cast<double>(contained) / all};
}

void print(std::FILE* out, const Kinds& kinds, Data data, const Row& row) {
  const std::string name =
      std::string(vesica_kind_name(kinds.a)) + "_" + vesica_kind_name(kinds.b) + "/f64/" + name_of(data);
  const bool has_target = data == Data::mixed || data == Data::sparse;
  std::fprintf(out, "%-30s %6.2f %9.2f %8.2f %8.2f %8.2f %9.2f %8.2f %8.2f %8.2f  %s\n", name.c_str(), row.overlapping,
               row.contained, row.overlap, row.relation, row.contains, row.interiors, row.ratio, row.contains_ratio,
               row.interiors_ratio,
               !has_target           ? ""
               : row.ratio <= target ? "met"
                                     : "MISSED");
}

}  // namespace

void report_relation(std::FILE* out) {
  std::fprintf(
      out,
      "\nNanoseconds a call by kind through the shared library, medians over passes on fresh pairs; seed %" PRIu64
      ".\nratio: the median over passes of relation, contains and interiors_overlap to overlap; relation is to be at "
      "most %.0f\non random pairs (mixed and sparse).\n\n%-30s %6s %9s %8s %8s %8s %9s %8s %8s %8s\n",
      seed_of_run(), target, "pair/scalar/workload", "hits", "contained", "overlap", "relation", "contains",
      "interiors", "ratio", "ratio", "ratio");
  const auto report = [out](std::int32_t a, std::int32_t b) {
    for (const Data data : all_data) {
      if (has_workload(a, b, workload_of(data))) print(out, {a, b}, data, measure({a, b}, data));
    }
  };
  for (std::int32_t a = 0; a < 6; ++a) {
    for (std::int32_t b = a; b < 6; ++b) report(a, b);
  }
  // Each kind of core with a radius with its own kind, and with an ellipse.
  for (const std::int32_t kind : {VESICA_CAPSULE, VESICA_ROUND_RECT}) {
    report(VESICA_ELLIPSE, kind);
    report(kind, kind);
  }
}

}  // namespace vesica::bench
