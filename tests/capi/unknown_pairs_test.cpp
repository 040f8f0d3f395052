// SPDX-License-Identifier: Apache-2.0
// A query need not know every pair: asked about one that it does not know, it returns the error of an unknown kind.
#include <gtest/gtest.h>

#include "query.hpp"

namespace {

using namespace vesica;

/// Knows discs with discs and with points. Its answer for other pairs does not compile.
struct OfDiscs {
  static constexpr Reversal reversal = Reversal::none;
  template <class A, class B>
  static constexpr bool answers = ShapeTraits<A>::kind <= Kind::circle&& ShapeTraits<B>::kind ==
                                  Kind::circle&& ShapeTraits<A>::kind != Kind::segment;
  template <class A, class B>
  static std::int32_t answer([[maybe_unused]] const A& a, const B& b) noexcept {
    if constexpr (ShapeTraits<B>::kind == Kind::circle) {
      return static_cast<std::int32_t>(b.r);
    } else {
      return static_cast<std::int32_t>(a.r);
    }
  }
};

constexpr Query of_discs{
    .doubles = pair_table<OfDiscs, double>(), .floats = pair_table<OfDiscs, float>(), .reversal = Reversal::none};

constexpr double numbers[] = {3, 4, 5, 6, 7, 8};

std::int32_t ask_discs(Kind a, Kind b) {
  return ask<double>(of_discs, static_cast<std::int32_t>(a), numbers, static_cast<std::int32_t>(b), numbers, nullptr);
}

TEST(UnknownPairs, AreAnErrorInEitherOrder) {
  EXPECT_EQ(ask_discs(Kind::circle, Kind::circle), 5);
  EXPECT_EQ(ask_discs(Kind::point, Kind::circle), 5);
  EXPECT_EQ(ask_discs(Kind::circle, Kind::point), 5);
  EXPECT_EQ(ask_discs(Kind::point, Kind::point), error_kind);
  EXPECT_EQ(ask_discs(Kind::segment, Kind::circle), error_kind);
  EXPECT_EQ(ask_discs(Kind::circle, Kind::ellipse), error_kind);
  EXPECT_EQ(ask_discs(Kind::ellipse, Kind::circle), error_kind);
}

TEST(UnknownPairs, AreToldApart) {
  const auto answers = [](Kind a, Kind b) {
    return of_discs.answers(static_cast<std::int32_t>(a), static_cast<std::int32_t>(b));
  };
  EXPECT_TRUE(answers(Kind::circle, Kind::point));
  EXPECT_FALSE(answers(Kind::circle, Kind::rect));
  EXPECT_FALSE(answers(Kind::rect, Kind::circle));
}

TEST(UnknownPairs, OfOneShapeToo) {
  const auto radius = [](const Circle<double>& disc) { return static_cast<std::int32_t>(disc.r); };
  EXPECT_EQ(with_shape<double>(static_cast<std::int32_t>(Kind::circle), numbers, radius), 5);
  EXPECT_EQ(with_shape<double>(static_cast<std::int32_t>(Kind::rect), numbers, radius), error_kind);
}

}  // namespace
