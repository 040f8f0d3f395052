// SPDX-License-Identifier: Apache-2.0
// How far areas are from a reference of 60 digits and more, in units of u x aspect x the lesser shape's area, u =
// 2^-53. The header promises 64 for aspects of up to 10^4. The worst of each kind of pair and case is printed.
#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <cstdio>

#include "area/hard_pairs.hpp"
#include "area/reference.hpp"
#include "properties/generators.hpp"
#include "relation/nesting.hpp"

namespace {

using namespace properties;

constexpr double promised = 64;
constexpr double most_aspect = 1e4;

/// The worst of many pairs.
struct Worst {
  double deviation = 0;
  Pair pair{};
  int crossing = 0;

  /// A pair that crosses, whose shapes' sizes are within 10^15 of each other; others are not the formulas' work.
  void ask(const Pair& p) {
    double a = 0, b = 0, area = -1;
    if (vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) != VESICA_CROSS) return;
    if (vesica_shape_area_f64(p.kind_a, p.a.data(), &a) != 0 || vesica_shape_area_f64(p.kind_b, p.b.data(), &b) != 0)
      return;
    const double least = std::fmin(a, b), most = std::fmax(a, b);
    if (least < 1e-290 || most > 1e290 || most / least > 1e30) return;
    ASSERT_EQ(vesica_area_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &area), 0) << describe(p);
    const auto found = reference::deviation(p.kind_a, p.a.data(), p.kind_b, p.b.data(), area);
    if (found.aspect > most_aspect * 1.001) return;
    ++crossing;
    if (found.in_roundoffs <= deviation) return;
    deviation = found.in_roundoffs;
    pair = p;
  }
  void report(int kind_a, int kind_b, const char* name) const {
    std::printf("%-8s %-8s %-17s %5d crossing, worst %.3g u x aspect x area\n", kind_name(kind_a), kind_name(kind_b),
                name, crossing, deviation);
    EXPECT_LE(deviation, promised) << describe(pair) << ", seed " << seed();
  }
};

template <class Check>
void for_areal_kinds(const Check& check) {
  for (int a = VESICA_CIRCLE; a <= VESICA_ELLIPSE; ++a) {
    for (int b = a; b <= VESICA_ELLIPSE; ++b) check(a, b);
  }
}

void ask_hard_pairs(double most_ratio) {
  for_areal_kinds([&](int kind_a, int kind_b) {
    for (const hard::Case c : hard::all_cases) {
      Random random(seed() + static_cast<std::uint64_t>(100 * kind_a + 10 * kind_b + static_cast<int>(c)));
      Worst worst;
      for (int i = 0; i < 60 * repeat(); ++i) worst.ask(hard::draw(c, kind_a, kind_b, most_ratio, random));
      worst.report(kind_a, kind_b, hard::name(c));
    }
  });
}

TEST(AreaAccuracy, HardPairs) { ask_hard_pairs(1); }

TEST(AreaAccuracy, HardPairsOfVeryDifferentSizes) { ask_hard_pairs(12); }

TEST(AreaAccuracy, Workloads) {
  for_areal_kinds([](int kind_a, int kind_b) {
    for (const Workload workload : all_workloads) {
      Stream stream(workload, kind_a, kind_b, Scalar::f64, seed());
      Worst worst;
      for (int i = 0; i < 60 * repeat(); ++i) worst.ask(stream.next());
      worst.report(kind_a, kind_b, name(workload));
    }
  });
}

TEST(AreaAccuracy, NestedShapes) {
  for_areal_kinds([](int kind_a, int kind_b) {
    for (const relations::Nesting nesting : relations::all_nestings) {
      if (!relations::exists(nesting, kind_a, kind_b)) continue;
      relations::NestingStream stream(nesting, kind_a, kind_b, Scalar::f64, seed());
      Worst worst;
      for (int i = 0; i < 80 * repeat(); ++i) worst.ask(stream.next());
      worst.report(kind_a, kind_b, relations::name(nesting));
    }
  });
}

}  // namespace
