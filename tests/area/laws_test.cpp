// SPDX-License-Identifier: Apache-2.0
// Laws of areas that hold without any tolerance, tested by the library alone:
//   relation       disjoint and touching pairs share 0, contained ones the inner shape's area, equal ones iou 1
//   bounds         0 <= area <= the lesser shape's; above 0 where they cross, unless it underflows; 0 <= iou <= 1
//   symmetry       area(a, b) = area(b, a) and iou(a, b) = iou(b, a)
//   scale          both shapes times 2^k: area times 4^k, iou unchanged
//   floats         what a float gives is the double's answer, rounded
#include <gtest/gtest.h>
#include <vesica.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "area/hard_pairs.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "relation/nesting.hpp"

namespace {

using namespace properties;

constexpr int most_printed = 3;

struct Answer {
  std::int32_t code;
  double value;
};
Answer area(const Pair& p) {
  double out = -1;
  const std::int32_t code = vesica_area_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
  return {code, out};
}
Answer iou(const Pair& p) {
  double out = -1;
  const std::int32_t code = vesica_iou_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data(), &out);
  return {code, out};
}
Answer shape_area(int kind, const Numbers& numbers) {
  double out = -1;
  const std::int32_t code = vesica_shape_area_f64(kind, numbers.data(), &out);
  return {code, out};
}

/// Not so small anywhere that an area could underflow.
bool moderate(const Pair& p) { return is_moderate(p, 0x1p200); }

bool same(const Answer& a, const Answer& b) { return a.code == b.code && a.value == b.value; }

class AreaLaws : public testing::Test {
 protected:
  void demand(bool holds, const char* law, const Pair& p, double got, double wanted) {
    ++asked_;
    if (holds || ++broken_ > most_printed) return;
    ADD_FAILURE() << law << ": " << got << " where " << wanted << " is due, seed " << seed() << "\n  " << describe(p);
  }

  void relation_and_bounds(const Pair& p) {
    const Answer shared = area(p), ratio = iou(p), a = shape_area(p.kind_a, p.a), b = shape_area(p.kind_b, p.b);
    const std::int32_t relation = vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data());
    const bool inside = relation == VESICA_INSIDE || relation == VESICA_INSIDE_TOUCH;
    const bool contains = relation == VESICA_CONTAINS || relation == VESICA_CONTAINS_TOUCH;
    if (relation == VESICA_DISJOINT || relation == VESICA_TOUCH)
      demand(same(shared, {0, 0}), "apart", p, shared.value, 0);
    if (inside) demand(same(shared, a), "inside", p, shared.value, a.value);
    if (contains) demand(same(shared, b), "contains", p, shared.value, b.value);
    if (relation == VESICA_EQUAL) demand(same(a, b) && same(shared, a), "equal", p, shared.value, a.value);
    if (shared.code == 0) {
      demand(shared.value >= 0, "not negative", p, shared.value, 0);
      if (a.code == 0) demand(shared.value <= a.value, "at most a", p, shared.value, a.value);
      if (b.code == 0) demand(shared.value <= b.value, "at most b", p, shared.value, b.value);
      if (relation == VESICA_CROSS && a.value > 0 && b.value > 0 && moderate(p))
        demand(shared.value > 0, "above 0", p, shared.value, 1);
    }
    if (ratio.code != 0) {
      demand(ratio.code == VESICA_E_ARGUMENT && a.value == 0 && b.value == 0, "error", p, ratio.code, 0);
      return;
    }
    demand(ratio.value >= 0 && ratio.value <= 1, "from 0 to 1", p, ratio.value, 1);
    if (relation == VESICA_EQUAL) demand(ratio.value == 1, "1 for equals", p, ratio.value, 1);
    if (relation == VESICA_DISJOINT || relation == VESICA_TOUCH) demand(ratio.value == 0, "0 apart", p, ratio.value, 0);
  }

  void symmetry(const Pair& p) {
    const Pair q{p.kind_b, p.kind_a, p.b, p.a};
    demand(same(area(p), area(q)), "symmetry of area", p, area(q).value, area(p).value);
    demand(same(iou(p), iou(q)), "symmetry of iou", p, iou(q).value, iou(p).value);
  }

  void scale(const Pair& p, Random& random) {
    const int exponent = random.chance(0.5) ? random.integer(-8, 8) : random.integer(-600, 600);
    const auto a = scaled_exactly({p.kind_a, p.a}, Scalar::f64, exponent, random.chance(0.5));
    const auto b = scaled_exactly({p.kind_b, p.b}, Scalar::f64, exponent, random.chance(0.5));
    if (!a || !b) return;
    const Pair q{p.kind_a, p.kind_b, a->numbers, b->numbers};
    demand(same(iou(p), iou(q)), "scale of iou", p, iou(q).value, iou(p).value);
    const Answer before = area(p), after = area(q);
    const double wanted = std::ldexp(before.value, 2 * exponent);
    // If either is subnormal or infinite, it has lost digits.
    const bool nothing = vesica_relation_f64(p.kind_a, p.a.data(), p.kind_b, p.b.data()) <= VESICA_TOUCH;
    const auto normal = [&](const Answer& x) { return x.code == 0 && (nothing || x.value >= 0x1p-1022); };
    if (!normal(before) || !normal(after)) return;
    demand(after.value == wanted, "scale of area", p, after.value, wanted);
  }

  void all(const Pair& p, Random& random) {
    relation_and_bounds(p);
    symmetry(p);
    scale(p, random);
  }

  int asked_ = 0, broken_ = 0;
};

TEST_F(AreaLaws, OnWorkloads) {
  Random random(seed());
  for (int a = VESICA_POINT; a <= VESICA_ELLIPSE; ++a) {
    for (int b = a; b <= VESICA_ELLIPSE; ++b) {
      for (const Workload workload : all_workloads) {
        Stream stream(workload, a, b, Scalar::f64, seed());
        for (int i = 0; i < 120 * repeat(); ++i) all(stream.next(), random);
      }
    }
  }
  EXPECT_GT(asked_, 100000 * repeat());
}

TEST_F(AreaLaws, OnHardPairs) {
  Random random(seed());
  for (int a = VESICA_CIRCLE; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_CIRCLE; b <= VESICA_ELLIPSE; ++b) {
      for (const hard::Case c : hard::all_cases) {
        for (int i = 0; i < 150 * repeat(); ++i) all(hard::draw(c, a, b, random.chance(0.5) ? 1 : 12, random), random);
      }
    }
  }
  EXPECT_GT(asked_, 50000 * repeat());
}

TEST_F(AreaLaws, OnNestedShapes) {
  Random random(seed());
  for (int a = VESICA_CIRCLE; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_CIRCLE; b <= VESICA_ELLIPSE; ++b) {
      for (const relations::Nesting nesting : relations::all_nestings) {
        if (!relations::exists(nesting, a, b)) continue;
        relations::NestingStream stream(nesting, a, b, Scalar::f64, seed());
        for (int i = 0; i < 80 * repeat(); ++i) all(stream.next(), random);
      }
    }
  }
  EXPECT_GT(asked_, 30000 * repeat());
}

/// A round shape beside an AABB of subnormal width and moderate place: half of the width has a
/// digit more than doubles have.
TEST_F(AreaLaws, OnSliversOfSubnormalWidth) {
  Random random(seed());
  for (int i = 0; i < 4000 * repeat(); ++i) {
    const double r = std::ldexp(1, random.integer(-900, -300)), side = random.chance(0.5) ? 1 : -1;
    const double width = side * std::ldexp(2.0 * random.integer(1, 1 << 30) + 1, -1074);
    const double top = std::ldexp(r, random.integer(-2, 2));
    Numbers box{side < 0 ? width : 0, 0, side < 0 ? 0 : width, top};
    Numbers round{side * r, 0, r};
    if (random.chance(0.5)) {
      std::swap(box[0], box[1]);
      std::swap(box[2], box[3]);
      std::swap(round[0], round[1]);
    }
    const bool ellipse = random.chance(0.5);
    if (ellipse) round = {round[0], round[1], 1, 0, r, r};
    all({ellipse ? VESICA_ELLIPSE : VESICA_CIRCLE, VESICA_AABB, round, box}, random);
  }
  EXPECT_GT(asked_, 20000 * repeat());
}

/// A shape with itself, and with itself in other numbers and as other kinds.
TEST_F(AreaLaws, OfAShapeWithItself) {
  Random random(seed());
  for (int kind = VESICA_CIRCLE; kind <= VESICA_ELLIPSE; ++kind) {
    for (const Workload workload : all_workloads) {
      if (workload == Workload::near_contact) continue;
      for (int i = 0; i < 60 * repeat(); ++i) {
        const Pair p = draw(workload, kind, kind, Scalar::f64, random);
        const Shape s{kind, p.a};
        const bool flat = shape_area(kind, p.a).value == 0;
        const auto demand_one = [&](const std::optional<Shape>& other) {
          if (!other) return;
          const Pair q{kind, other->kind, s.numbers, other->numbers};
          const Answer ratio = iou(q);
          if (flat && ratio.code == VESICA_E_ARGUMENT) return;
          demand(same(ratio, {0, 1}), "itself", q, ratio.value, 1);
          demand(same(shape_area(kind, p.a), shape_area(other->kind, other->numbers)), "its area", q,
                 shape_area(other->kind, other->numbers).value, shape_area(kind, p.a).value);
        };
        demand_one(s);
        demand_one(with_negated_axis(s));
        demand_one(with_turned_axis(s));
        demand_one(with_scaled_axis(s, Scalar::f64, random.integer(-40, 40)));
        for (const Shape& other : as_other_kinds(s, Scalar::f64)) {
          if (other.kind >= VESICA_CIRCLE) demand_one(other);
        }
      }
    }
  }
  EXPECT_GT(asked_, 10000 * repeat());
}

/// One shape in another, each step a superset, until they are equal up to one place: areas never decrease.
TEST_F(AreaLaws, AShapeInAnotherHasNoGreaterArea) {
  Random random(seed());
  for (int kind = VESICA_CIRCLE; kind <= VESICA_ELLIPSE; ++kind) {
    for (int i = 0; i < 4000 * repeat(); ++i) {
      const Pair p = draw(Workload::random, kind, kind, Scalar::f64, random);
      const auto larger = grown({kind, p.a}, Scalar::f64, random);
      if (!larger) continue;
      const Pair q{kind, kind, p.a, larger->numbers};
      demand(shape_area(kind, p.a).value <= shape_area(kind, larger->numbers).value, "grown", q,
             shape_area(kind, larger->numbers).value, shape_area(kind, p.a).value);
    }
  }
  EXPECT_GT(asked_, 5000 * repeat());
}

/// Floats: the same shapes in double, and the result rounded.
TEST_F(AreaLaws, OfFloats) {
  for (int a = VESICA_POINT; a <= VESICA_ELLIPSE; ++a) {
    for (int b = VESICA_POINT; b <= VESICA_ELLIPSE; ++b) {
      for (const Workload workload : {Workload::random, Workload::touching, Workload::huge, Workload::tiny}) {
        Stream stream(workload, a, b, Scalar::f32, seed());
        for (int i = 0; i < 60 * repeat(); ++i) {
          const Pair p = stream.next();
          const auto f = narrow(p.a), g = narrow(p.b);
          float shared = -1, ratio = -1, own = -1;
          const std::int32_t code = vesica_area_f32(a, f.data(), b, g.data(), &shared);
          const Answer wide = area(p), wide_ratio = iou(p), wide_own = shape_area(a, p.a);
          const float rounded = static_cast<float>(wide.value);
          if (std::isinf(rounded)) {
            demand(code == VESICA_E_RANGE && shared == -1, "float beyond the range", p, code, VESICA_E_RANGE);
          } else {
            demand(code == wide.code && (code != 0 || shared == rounded), "float", p, shared, wide.value);
          }
          const std::int32_t ratio_code = vesica_iou_f32(a, f.data(), b, g.data(), &ratio);
          const float rounded_ratio = static_cast<float>(wide_ratio.value);
          demand(ratio_code == wide_ratio.code && ratio == rounded_ratio, "float iou", p, ratio, wide_ratio.value);
          const std::int32_t own_code = vesica_shape_area_f32(a, f.data(), &own);
          const float rounded_own = static_cast<float>(wide_own.value);
          demand(std::isinf(rounded_own) ? own_code == VESICA_E_RANGE : own_code == 0 && own == rounded_own,
                 "float shape", p, own, wide_own.value);
        }
      }
    }
  }
  EXPECT_GT(asked_, 10000 * repeat());
}

}  // namespace
