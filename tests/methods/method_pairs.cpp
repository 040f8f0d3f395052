// SPDX-License-Identifier: Apache-2.0
#include "methods/method_pairs.hpp"

#include <vesica.h>

#include <cmath>
#include <cstdio>

#include "properties/answers.hpp"

namespace method_pairs {
namespace {

bool overlap_f64(const Pair& pair) { return properties::overlap_by_kind(Scalar::f64, pair) == 1; }

bool overlap_of_library(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b) == 1;
}

properties::Numbers with_sizes_times(int kind, properties::Numbers numbers, double factor) {
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (properties::is_size(properties::role(kind, i))) numbers[static_cast<std::size_t>(i)] *= factor;
  }
  if (kind != VESICA_SEGMENT) return numbers;
  const double x = (numbers[0] + numbers[2]) / 2, y = (numbers[1] + numbers[3]) / 2;
  return {x + factor * (numbers[0] - x), y + factor * (numbers[1] - y), x + factor * (numbers[2] - x),
          y + factor * (numbers[3] - y)};
}

Pair with_sizes_times(const Pair& pair, double factor) {
  return {pair.kind_a, pair.kind_b, with_sizes_times(pair.kind_a, pair.a, factor),
          with_sizes_times(pair.kind_b, pair.b, factor)};
}

/// A pair of lengths below 2^-400 becomes 2^600 times as large: subnormal sizes have no relative gap.
Pair away_from_subnormal(Pair pair) {
  bool tiny = true;
  const auto each_length = [&pair](const auto& visit) {
    for (int i = 0; i < 6; ++i) {
      const auto field = static_cast<std::size_t>(i);
      if (properties::role(pair.kind_a, i) != properties::Role::axis) visit(pair.a[field]);
      if (properties::role(pair.kind_b, i) != properties::Role::axis) visit(pair.b[field]);
    }
  };
  each_length([&tiny](double x) { tiny &= std::abs(x) < 0x1p-400; });
  if (tiny) each_length([](double& x) { x = std::ldexp(x, 600); });
  return pair;
}

/// The second shape's centre at `distance` times its place as seen from the first one's.
Pair at_distance(Pair pair, double distance) {
  for (const std::size_t i : {0U, 1U}) pair.b[i] = pair.a[i] + distance * (pair.b[i] - pair.a[i]);
  return pair;
}

}  // namespace

std::int32_t truth(Scalar scalar, const Pair& pair) { return properties::overlap_by_kind(scalar, pair); }

Pair moved_near_contact(const Pair& pair, Scalar scalar, double relative_gap, Random& random) {
  double together = 0, apart = 1;
  while (overlap_f64(at_distance(pair, apart))) apart *= 2;
  for (int i = 0; i < 52; ++i) {
    const double middle = (together + apart) / 2;
    (overlap_f64(at_distance(pair, middle)) ? together : apart) = middle;
  }
  Pair near = at_distance(pair, together * (1 + random.sign() * relative_gap));
  near.b = properties::nearest_shape(scalar, pair.kind_b, near.b);
  return near;
}

Pair near_tangent(int kind_a, int kind_b, Scalar scalar, double relative_gap, Random& random) {
  const Pair pair = properties::draw(properties::Workload::random, kind_a, kind_b, scalar, random);
  return moved_near_contact(pair, scalar, relative_gap, random);
}

bool within_gap(const Pair& given, double gap) {
  const Pair pair = away_from_subnormal(given);
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

}  // namespace method_pairs
