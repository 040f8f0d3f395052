// SPDX-License-Identifier: Apache-2.0
#include "methods/rect_pairs.hpp"

#include <vesica.h>

#include <cmath>
#include <cstdio>

#include "properties/answers.hpp"

namespace rect_pairs {
namespace {

bool overlap_f64(const Pair& pair) { return properties::overlap_by_kind(Scalar::f64, pair) == 1; }

bool overlap_of_library(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b) == 1;
}

/// Sizes stand in the last two fields of rectangles and ellipses.
Pair with_sizes_times(Pair pair, double factor) {
  for (const std::size_t i : {4U, 5U}) {
    pair.a[i] *= factor;
    pair.b[i] *= factor;
  }
  return pair;
}

/// The second shape's centre at `distance` times its place as seen from the first one's.
Pair at_distance(Pair pair, double distance) {
  for (const std::size_t i : {0U, 1U}) pair.b[i] = pair.a[i] + distance * (pair.b[i] - pair.a[i]);
  return pair;
}

}  // namespace

std::int32_t truth(Scalar scalar, const Pair& pair) { return properties::overlap_by_kind(scalar, pair); }

Pair near_tangent(int kind_a, int kind_b, Scalar scalar, double relative_gap, Random& random) {
  const Pair pair = properties::draw(properties::Workload::random, kind_a, kind_b, scalar, random);
  double together = 0, apart = 1;
  while (overlap_f64(at_distance(pair, apart))) apart *= 2;
  for (int i = 0; i < 52; ++i) {
    const double middle = (together + apart) / 2;
    (overlap_f64(at_distance(pair, middle)) ? together : apart) = middle;
  }
  Pair near = at_distance(pair, together * (1 + random.sign() * relative_gap));
  near.b = properties::nearest_shape(scalar, kind_b, near.b);
  return near;
}

bool within_gap(const Pair& pair, double gap) {
  return overlap_f64(with_sizes_times(pair, 1 - gap)) != overlap_f64(with_sizes_times(pair, 1 + gap));
}

double decided_gap(Scalar scalar) { return scalar == Scalar::f64 ? 1e-9 : 1e-4; }

Counts count(const Method& method, Scalar scalar, std::int64_t cases, const std::function<Pair()>& next) {
  Counts counts;
  for (; counts.cases < cases; ++counts.cases) {
    const Pair pair = next();
    const std::int32_t expected = truth(scalar, pair), answer = method(pair);
    counts.overlapping += expected;
    if (answer == 2) ++counts.uncertain;
    if (answer < 0) ++counts.refused;
    if (answer == expected || answer == 2 || answer < 0) continue;
    ++counts.wrong;
    if (within_gap(pair, decided_gap(scalar))) continue;
    if (++counts.wrong_beyond_gap == 1) counts.first_wrong = properties::describe(pair);
  }
  return counts;
}

Counts count(const Method& method, properties::Workload workload, int kind_a, int kind_b, Scalar scalar, int cases) {
  properties::Stream stream(workload, kind_a, kind_b, scalar, properties::seed(), overlap_of_library);
  return count(method, scalar, std::int64_t{cases} * properties::repeat(), [&] { return stream.next(); });
}

Counts count_near_tangent(const Method& method, double relative_gap, int kind_a, int kind_b, Scalar scalar, int cases) {
  Random random(properties::seed());
  return count(method, scalar, std::int64_t{cases} * properties::repeat(),
               [&] { return near_tangent(kind_a, kind_b, scalar, relative_gap, random); });
}

void print(const std::string& method, Scalar scalar, const std::string& workload, const Counts& counts) {
  std::printf("%-32s %s %-20s %8lld cases %8lld overlapping %7lld wrong %8lld uncertain %5lld refused\n",
              method.c_str(), properties::name(scalar), workload.c_str(), static_cast<long long>(counts.cases),
              static_cast<long long>(counts.overlapping), static_cast<long long>(counts.wrong),
              static_cast<long long>(counts.uncertain), static_cast<long long>(counts.refused));
}

}  // namespace rect_pairs
