// SPDX-License-Identifier: Apache-2.0
/// The pools of the benchmarks. Every pool is a function of the kinds, the workload and the seed alone.
#pragma once

#include <cstdint>
#include <vector>

#include "random.hpp"
#include "shapes.hpp"

namespace vesica::bench {

enum class Workload {
  rare,        ///< independent shapes, scattered so that about 1% of the pairs overlap
  sparse,      ///< the same, 5%
  some,        ///< the same, 20%
  mixed,       ///< the same, half
  most,        ///< the same, 90%
  clusters,    ///< independent shapes in 30 clusters
  near,        ///< pairs moved along a line until they touch, then apart or together by 1e-6 of the distance
  pixels,      ///< unit squares at whole coordinates that touch along an edge or at a corner
  hundredths,  ///< the same at multiples of 0.01, which are rounded: they touch, miss or overlap by a place
  incident,    ///< a point, a segment's end or a box's corner on a segment exactly, of numbers of 52 digits
  tangent,     ///< integers that touch exactly: no bound on an error can decide
  few_digits,  ///< small integers that touch exactly, ellipses left out
  last_ulp,    ///< pairs within the last unit in the last place of touching, all mantissas full
  exponents,   ///< random exponents over the whole finite range, a field each; the slowest few of many
};

/// Workloads of independent shapes, by the share that overlaps.
inline constexpr Workload by_rate[] = {Workload::rare, Workload::sparse, Workload::some, Workload::mixed,
                                       Workload::most};

const char* name_of(Workload workload);

/// Shapes to draw pairs from. Matched pools pair a[i] with b[i]; others any a with any b, so that a pool of n shapes
/// a side holds n * n pairs: more than any branch predictor can learn.
struct Pool {
  std::vector<Numbers> a, b;
  bool matched = false;
};

/// Does `make_pool` know this workload for this pair of kinds?
bool has_workload(std::int32_t kind_a, std::int32_t kind_b, Workload workload);

/// The pool's sizes are powers of two.
Pool make_pool(std::int32_t kind_a, std::int32_t kind_b, Workload workload, std::uint64_t seed);

/// VESICA_SEED from the environment, or the default seed.
std::uint64_t seed_of_run();

}  // namespace vesica::bench
