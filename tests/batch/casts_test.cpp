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

namespace {

using namespace batch_tests;
using properties::Random;

constexpr int blocks = 8, count = blocks * vesica::query_block;

/// Shapes that are mostly apart, sizes from 1/4 to 1 with axes from 1 to 2; of every second pair the velocity is aimed.
struct Pairs {
  std::array<Numbers<double>, count> a, b;
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

  static Numbers<double> shape(int kind, Random& random) {
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
      default:
        return {x, y, 1 - t * t, 2 * t, width, height};
    }
  }
};

/// Of all pairs those that certainly miss and those that certainly are in contact at some time; of these what the
/// kernel of contacts settles, or -1 where there is none. Most of the rest are in contact at the start.
struct Tally {
  int missed = 0, meets = 0, settled = -1;
};

Tally tally(const vesica::KernelTable& table, int kind_a, int kind_b) {
  static vesica::batch::NumberColumns first, second;
  const Pairs pairs(kind_a, kind_b);
  const auto view = [](int kind, const std::array<Numbers<double>, count>& shapes) {
    vesica::batch::Shapes<double> all{kind, count, sizeof shapes[0], {}};
    for (int k = 0; k < 6; ++k) all.field[k] = shapes[0].data() + k;
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

TEST(CastKernels, AnswerAsManyAsTheyDid) {
  int sets = 0;
  for (const InstructionSet& set : instruction_sets()) {
    if (!set.usable || set.table->queries->cast == nullptr) continue;
    ++sets;
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = 0; b < properties::kinds; ++b) {
        const Tally t = tally(*set.table, a, b);
        const Tally& e = expected[a][b];
        EXPECT_TRUE(t.missed == e.missed && t.meets == e.meets && t.settled == e.settled)
            << set.name << ' ' << properties::kind_name(a) << ' ' << properties::kind_name(b) << " {" << t.missed
            << ", " << t.meets << ", " << t.settled << '}';
      }
    }
  }
#if defined(__x86_64__)
  EXPECT_TRUE(sets > 0 || !__builtin_cpu_supports("avx2"));
#endif
}

}  // namespace
