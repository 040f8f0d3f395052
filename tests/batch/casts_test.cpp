// SPDX-License-Identifier: Apache-2.0
// How many pairs the kernels of casts answer. One that leaves too many to the scalar function is still right, only
// slow. No kernel fuses but in exact products, and the pairs are drawn without a rounding that could differ: all
// instruction sets that have these kernels leave the same number.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>

#include "batch/instruction_sets.hpp"
#include "batch/shapes.hpp"
#include "kernels/cast_columns.hpp"
#include "number_columns.hpp"
#include "properties/random.hpp"

namespace casts_test {
namespace {

using namespace batch_tests;
using properties::Random;

using Shape = std::array<double, 7>;

constexpr int blocks = 8, count = blocks * vesica::query_block;

/// Shapes that are mostly apart, sizes from 1/4 to 1 with axes from 1 to 2; of every second pair the velocity is aimed.
struct Pairs {
  std::array<Shape, count> a, b;
  std::array<double, count> vx, vy;

  Pairs(int kind_a, int kind_b) : a{}, b{}, vx{}, vy{} {
    Random random(1);
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = shape(kind_a, random);
      b[i] = shape(kind_b, random);
      const double spread = i % 2 == 0 ? 1 : 8;
      vx[i] = a[i][0] - b[i][0] + spread * random.between(-1, 1);
      vy[i] = a[i][1] - b[i][1] + spread * random.between(-1, 1);
    }
  }

  static Shape shape(int kind, Random& random) {
    const double x = random.between(-6, 6), y = random.between(-6, 6), t = random.between(-1, 1);
    const double width = random.between(0.25, 1), height = random.between(0.25, 1);
    switch (kind) {
      case VESICA_POINT:
        return {x, y};
      case VESICA_CIRCLE:
        return {x, y, width};
      case VESICA_SEGMENT:
      case VESICA_AABB:
        return {x, y, x + width, y + height};
      case VESICA_CAPSULE:
        return {x, y, x + width, y + height, random.between(0.125, 0.5)};
      case VESICA_ROUND_RECT:
        return {x, y, 1 - t * t, 2 * t, width, height, random.between(0.125, 0.5)};
      default:
        return {x, y, 1 - t * t, 2 * t, width, height};
    }
  }
};

/// A round shape at the origin, and a point or a round shape that comes to it along a coordinate. It passes beside the
/// centre by 2^-4 to 2^-43.
struct NearlyAlong {
  std::array<Shape, count> a, b;
  std::array<double, count> vx, vy;

  NearlyAlong(int kind_a, int kind_b) : a{}, b{}, vx{}, vy{} {
    Random random(1);
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = round(kind_a, random);
      b[i] = round(kind_b, random);
      const int beside = 4 + static_cast<int>(i % 40), along_x = static_cast<int>(i / 40 % 2);
      const double sign = random.sign(), far = random.integer(4, 8), side = random.sign();
      const double off = side * std::ldexp(1, -beside);
      b[i][0] = along_x != 0 ? sign * far : off;
      b[i][1] = along_x != 0 ? off : sign * far;
      vx[i] = along_x != 0 ? -sign * far : 0;
      vy[i] = along_x != 0 ? 0 : -sign * far;
    }
  }

  static Shape round(int kind, Random& random) {
    const double width = random.integer(4, 8) / 8.0, height = random.integer(4, 8) / 8.0;
    if (kind == VESICA_POINT) return {0, 0};
    return kind == VESICA_CIRCLE ? Shape{0, 0, width} : Shape{0, 0, 0, 1, width, height};
  }
};

/// Pairs that certainly miss, pairs that certainly are in contact at some time, and those of the latter that the
/// kernel of contacts settles, or -1 if there is none. Most others are in contact at the start.
struct Tally {
  int missed = 0, meets = 0, settled = -1;
};

template <class Drawn>
Tally tally(const vesica::KernelTable& table, int kind_a, int kind_b) {
  static vesica::batch::NumberColumns first, second;
  const Drawn pairs(kind_a, kind_b);
  const auto view = [](int kind, const std::array<Shape, count>& shapes) {
    vesica::batch::Shapes<double> all{kind, count, sizeof shapes[0], {}};
    for (int k = 0; k < vesica_field_count(kind); ++k) all.field[k] = shapes[0].data() + k;
    return all;
  };
  const vesica::CastTable& casts = *table.queries->cast;
  const vesica::CastKernel kernel = casts.contact[kind_a][kind_b];
  Tally out;
  if (kernel != nullptr) out.settled = 0;
  for (int block = 0; block < blocks; ++block) {
    constexpr std::int32_t n = vesica::query_block;
    first.set(view(kind_a, pairs.a), block * n, n, table);
    second.set(view(kind_b, pairs.b), block * n, n, table);
    const vesica::CastColumns columns{vesica::side_columns(kind_a, first.operand()),
                                      vesica::side_columns(kind_b, second.operand()), pairs.vx.data() + block * n,
                                      pairs.vy.data() + block * n, 1.0};
    std::uint8_t missed[n], meets[n];
    double results[5][n];
    casts.filter(columns, n, {missed, meets});
    double* const out_columns[] = {results[0], results[1], results[2], results[3], results[4]};
    if (kernel != nullptr) kernel(columns, n, out_columns);
    for (std::int32_t i = 0; i < n; ++i) {
      EXPECT_LE(missed[i] + meets[i], 1);
      out.missed += missed[i];
      out.meets += meets[i];
      if (kernel != nullptr && meets[i] != 0) out.settled += !std::isnan(results[0][i]);
    }
  }
  return out;
}

/// By the kinds of the shape at rest and of that which moves.
constexpr Tally expected[6][6] = {
    {{1024, 0, -1}, {898, 126, 125}, {684, 340, 330}, {828, 196, 193}, {517, 507, 484}, {574, 450, 433}},
    {{895, 129, 128}, {735, 289, 287}, {562, 462, 443}, {641, 383, 376}, {444, 580, 541}, {489, 535, 507}},
    {{702, 322, 316}, {596, 428, 415}, {433, 591, 555}, {547, 477, 458}, {363, 661, 607}, {402, 622, 579}},
    {{834, 190, 188}, {651, 373, 367}, {521, 503, 477}, {586, 438, 424}, {420, 604, 560}, {463, 561, 525}},
    {{501, 523, 504}, {446, 578, 551}, {362, 662, 607}, {423, 601, 566}, {325, 699, 619}, {349, 675, 610}},
    {{589, 435, 422}, {498, 526, 505}, {395, 629, 585}, {477, 547, 521}, {346, 678, 616}, {371, 653, 599}},
};

/// The same of pairs with a radius. An ellipse has no kernel with these.
constexpr struct {
  int kind_a, kind_b;
  Tally tally;
} expected_inflated[] = {
    {VESICA_POINT, VESICA_CAPSULE, {740, 284, 277}},      {VESICA_CAPSULE, VESICA_POINT, {725, 299, 290}},
    {VESICA_SEGMENT, VESICA_CAPSULE, {582, 442, 429}},    {VESICA_CAPSULE, VESICA_SEGMENT, {580, 444, 429}},
    {VESICA_CIRCLE, VESICA_CAPSULE, {463, 561, 527}},     {VESICA_CAPSULE, VESICA_CIRCLE, {450, 574, 543}},
    {VESICA_AABB, VESICA_CAPSULE, {509, 515, 493}},       {VESICA_CAPSULE, VESICA_AABB, {501, 523, 502}},
    {VESICA_RECT, VESICA_CAPSULE, {359, 665, 610}},       {VESICA_CAPSULE, VESICA_RECT, {375, 649, 600}},
    {VESICA_ELLIPSE, VESICA_CAPSULE, {404, 620, -1}},     {VESICA_CAPSULE, VESICA_ELLIPSE, {413, 611, -1}},
    {VESICA_CAPSULE, VESICA_CAPSULE, {449, 575, 546}},    {VESICA_ROUND_RECT, VESICA_CAPSULE, {322, 702, 631}},
    {VESICA_POINT, VESICA_ROUND_RECT, {409, 615, 581}},   {VESICA_ROUND_RECT, VESICA_POINT, {408, 616, 580}},
    {VESICA_SEGMENT, VESICA_ROUND_RECT, {378, 646, 602}}, {VESICA_ROUND_RECT, VESICA_SEGMENT, {373, 651, 601}},
    {VESICA_CIRCLE, VESICA_ROUND_RECT, {325, 699, 617}},  {VESICA_ROUND_RECT, VESICA_CIRCLE, {330, 694, 623}},
    {VESICA_AABB, VESICA_ROUND_RECT, {361, 663, 607}},    {VESICA_ROUND_RECT, VESICA_AABB, {359, 665, 609}},
    {VESICA_RECT, VESICA_ROUND_RECT, {285, 739, 621}},    {VESICA_ROUND_RECT, VESICA_RECT, {286, 738, 636}},
    {VESICA_ELLIPSE, VESICA_ROUND_RECT, {298, 726, -1}},  {VESICA_ROUND_RECT, VESICA_ELLIPSE, {311, 713, -1}},
    {VESICA_CAPSULE, VESICA_ROUND_RECT, {329, 695, 627}}, {VESICA_ROUND_RECT, VESICA_ROUND_RECT, {254, 770, 648}},
};

template <class Drawn>
void expect_tally(const InstructionSet& set, int a, int b, const Tally& e) {
  const Tally t = tally<Drawn>(*set.table, a, b);
  EXPECT_TRUE(t.missed == e.missed && t.meets == e.meets && t.settled == e.settled)
      << set.name << ' ' << properties::kind_name(a) << ' ' << properties::kind_name(b) << " {" << t.missed << ", "
      << t.meets << ", " << t.settled << '}';
}

/// If a point meets a round shape within 2^-24 of a coordinate, the kernel leaves it open, as quick single calls do
/// (detail::cast::ends_at()). It leaves next to none of two round shapes.
constexpr struct {
  int kind_a, kind_b;
  Tally tally;
} expected_nearly_along[] = {
    {VESICA_CIRCLE, VESICA_POINT, {0, 1024, 537}},     {VESICA_POINT, VESICA_CIRCLE, {0, 1024, 539}},
    {VESICA_ELLIPSE, VESICA_POINT, {0, 1024, 535}},    {VESICA_POINT, VESICA_ELLIPSE, {0, 1024, 523}},
    {VESICA_CIRCLE, VESICA_CIRCLE, {0, 1024, 1021}},   {VESICA_CIRCLE, VESICA_ELLIPSE, {0, 1024, 1022}},
    {VESICA_ELLIPSE, VESICA_ELLIPSE, {0, 1024, 1022}},
};

TEST(CastKernels, AnswerAsManyAsTheyDid) {
  int sets = 0;
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.usable || set.table->queries->cast == nullptr) continue;
    ++sets;
    for (int a = 0; a < properties::kinds_with_form; ++a) {
      for (int b = 0; b < properties::kinds_with_form; ++b) expect_tally<Pairs>(set, a, b, expected[a][b]);
    }
    for (const auto& e : expected_inflated) expect_tally<Pairs>(set, e.kind_a, e.kind_b, e.tally);
    for (const auto& e : expected_nearly_along) expect_tally<NearlyAlong>(set, e.kind_a, e.kind_b, e.tally);
  }
#if defined(__x86_64__)
  EXPECT_TRUE(sets > 0 || !__builtin_cpu_supports("avx2"));
#endif
}

}  // namespace
}  // namespace casts_test
