// SPDX-License-Identifier: Apache-2.0
// Lattices of touching shapes, on every instruction set, held against the exact stage: the scalar function decides
// contact by integers.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>
#include <vector>
#include <vesica/overlap.hpp>

#include "batch/expect.hpp"
#include "batch/instruction_sets.hpp"
#include "batch/layout.hpp"
#include "by_kind.hpp"
#include "properties/lattice.hpp"

namespace {

using namespace batch_tests;
using properties::Lattice;
using properties::Random;

/// By the exact stage alone, or error_shape.
template <class T>
std::int32_t exact_answer(int kind_a, const Numbers<T>& a, int kind_b, const Numbers<T>& b) {
  return vesica::with_shape<T>(kind_a, a.data(), [&](const vesica::HasCore auto& first) {
    return vesica::with_shape<T>(kind_b, b.data(), [&](const vesica::HasCore auto& second) -> std::int32_t {
      if (vesica::check(first) != 0 || vesica::check(second) != 0) return vesica::error_shape;
      using First = std::remove_cvref_t<decltype(vesica::widen(first))>;
      using Second = std::remove_cvref_t<decltype(vesica::widen(second))>;
      if constexpr (vesica::detail::in_order<First, Second>) {
        return vesica::detail::overlap::exact(vesica::widen(first), vesica::widen(second)) ? 1 : 0;
      } else {
        return vesica::detail::overlap::exact(vesica::widen(second), vesica::widen(first)) ? 1 : 0;
      }
    });
  });
}

template <class T>
std::vector<Lattice> lattices() {
  std::vector<Lattice> all;
  for (const double step : {1.0, 0.5, 0.01, 0x1p-10}) all.push_back({step, 0, 0});
  all.push_back({1, 0, 7});
  all.push_back({0.5, 3, -11});
  const int extremes_f32[] = {-149, -140, -60, 60, 120},
            extremes_f64[] = {-1074, -1000, -540, -360, -170, 170, 340, 1000};
  if constexpr (sizeof(T) == sizeof(float)) {
    for (const int e : extremes_f32) all.push_back({1, e, 0});
  } else {
    for (const int e : extremes_f64) all.push_back({1, e, 0});
    for (const int e : extremes_f64) all.push_back({1, 0, e / 2});
  }
  return all;
}

/// Along x.
template <class T>
void move_away(int kind, Numbers<T>& shape, T by) {
  shape[0] += by;
  if (kind == VESICA_AABB || kind == VESICA_SEGMENT) shape[2] += by;
}

class Contacts : public EveryCase {
 protected:
  void SetUp() override {
    if (GetParam().kind_a == VESICA_ELLIPSE || GetParam().kind_b == VESICA_ELLIPSE) GTEST_SKIP() << "no lattice";
    EveryCase::SetUp();
  }

  /// `far`: the share of pairs that are clearly disjoint.
  template <class T>
  void check(const Lattice& lattice, double far, Layout layout_a) {
    const Case& c = GetParam();
    std::vector<Numbers<T>> a, b;
    Expected expected;
    for (int i = 0; i < 203; ++i) {
      a.push_back(properties::lattice_shape<T>(c.kind_a, lattice, random_));
      b.push_back(properties::lattice_shape<T>(c.kind_b, lattice, random_));
      if (random_.chance(0.2)) properties::move_by_a_place(c.kind_b, b.back(), random_);
      if (random_.chance(far)) move_away(c.kind_b, b.back(), static_cast<T>(std::ldexp(20, lattice.lengths)));
      expected.add(exact_answer(c.kind_a, a[one_shape(layout_a) ? 0 : a.size() - 1], c.kind_b, b.back()));
    }
    const Stored<T> first(c.kind_a, a, layout_a), second(c.kind_b, b, Layout::columns);
    expect_many(*c.set->table, first, second, expected,
                "step " + std::to_string(lattice.step) + ", 2^" + std::to_string(lattice.lengths) + ", axes 2^" +
                    std::to_string(lattice.axes) + ", seed " + std::to_string(properties::seed()));
  }

  Random random_{properties::seed()};
};

TEST_P(Contacts, AreThoseOfTheExactStage) {
  in_its_scalar([this]<class T>(T) {
    for (const Lattice& lattice : lattices<T>()) {
      for (const double far : {0.0, 0.9}) {
        check<T>(lattice, far, Layout::columns);
        check<T>(lattice, far, Layout::single);
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Sets, Contacts, testing::ValuesIn(all_cases()), test_name);

}  // namespace
