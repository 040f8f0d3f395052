// SPDX-License-Identifier: Apache-2.0
// What each query's kernel computes for one vector of pairs: the core's templates, as the scalar functions use them.
//
// evaluate(a, b, known, out) writes the results and returns where they hold: elsewhere the scalar function is asked, which
// takes the same first step and then goes on.
#pragma once

#include <vesica/area.hpp>
#include <vesica/depth.hpp>
#include <vesica/nearest.hpp>
#include <vesica/relation.hpp>

#include "kernels/query_table.hpp"

namespace vesica {
namespace {

using PairMask = decltype(Doubles(0.0) < Doubles(0.0));

/// What is known of a vector of pairs, where the query asks for it.
struct KnownLanes {
  Doubles overlap;  // 1 or 0
  Doubles area_a, area_b;
};

struct RelationCore {
  static constexpr int results = 1;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes&, Doubles* out) noexcept {
    const auto certain = filter::certain_relation(pair::standing(a, b));
    const auto code = [](Relation relation) { return Doubles(static_cast<double>(relation)); };
    const Doubles nested = select(certain.inside, code(Relation::inside), code(Relation::contains));
    out[0] = select(certain.disjoint, code(Relation::disjoint), select(certain.cross, code(Relation::cross), nested));
    return either(either(certain.disjoint, certain.cross), either(certain.inside, certain.contains));
  }
};

/// Zero where all numbers are finite, NaN elsewhere.
template <class... V>
VESICA_INLINE Doubles zero_if_finite(V... numbers) noexcept {
  const Doubles zero(0.0);
  return ((numbers * zero) + ...);
}

template <class A, class B>
VESICA_INLINE PairMask closest_points(const A& a, const B& b, PairMask overlapping, Doubles* out) noexcept {
  const auto hot = closest::hot_answer(a, b, overlapping);
  const Doubles points[] = {hot.distance, hot.ax, hot.ay, hot.bx, hot.by};
  for (int k = 0; k < 5; ++k) out[k] = points[k];
  return both(hot.settled, zero_if_finite(hot.distance, hot.ax, hot.ay, hot.bx, hot.by) == Doubles(0.0));
}

struct NearestCore {
  static constexpr int results = 5;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes& known, Doubles* out) noexcept {
    return closest_points(a, b, known.overlap > Doubles(0.0), out);
  }
};

/// Outlines of disjoint shapes are as far apart as the shapes; the others are for the scalar function.
struct BoundaryDistanceCore {
  static constexpr int results = 5;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes& known, Doubles* out) noexcept {
    const PairMask overlapping = known.overlap > Doubles(0.0);
    return and_not(closest_points(a, b, overlapping, out), overlapping);
  }
};

/// Disjoint shapes have no depth; overlapping rectangles have one in closed form; others are for the scalar function.
struct DepthCore {
  static constexpr int results = 3;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes& known, Doubles* out) noexcept {
    const Doubles zero(0.0);
    const PairMask overlapping = known.overlap > zero;
    for (int k = 0; k < 3; ++k) out[k] = zero;
    if constexpr (ShapeTraits<A>::kind == Kind::rect && ShapeTraits<B>::kind == Kind::rect) {
      const auto boxes = outline::box_box_depth(outline::box_pair(a, b));
      out[0] = select(overlapping, boxes.depth, zero);
      out[1] = select(overlapping, boxes.x, zero);
      out[2] = select(overlapping, boxes.y, zero);
      return either(boxes.settled, known.overlap == zero);
    }
    return known.overlap == zero;
  }
};

/// The area of rectangles that certainly cross or are certainly disjoint.
VESICA_INLINE PairMask shared_area(const Rect<Doubles>& a, const Rect<Doubles>& b, Doubles& area) noexcept {
  const PairMask disjoint = pair::filter(a, b).disjoint;
  area = Doubles(0.0);
  if (all(disjoint)) return disjoint;
  const auto crossing = clip::crossing_area(a, b);
  area = select(disjoint, area, crossing.area);
  return either(disjoint, crossing.settled);
}

struct AreaCore {
  static constexpr int results = 1;
  VESICA_INLINE static PairMask evaluate(const Rect<Doubles>& a, const Rect<Doubles>& b, const KnownLanes&,
                                         Doubles* out) noexcept {
    return shared_area(a, b, out[0]);
  }
};

/// Areas between 2^-700 and 2^700 need none of the care that iou() takes of their range; the same bits come out.
struct IouCore {
  static constexpr int results = 1;
  VESICA_INLINE static PairMask evaluate(const Rect<Doubles>& a, const Rect<Doubles>& b, const KnownLanes& known,
                                         Doubles* out) noexcept {
    Doubles shared;
    const PairMask settled = shared_area(a, b, shared);
    const Doubles most = max(known.area_a, known.area_b), least = min(known.area_a, known.area_b);
    out[0] = shared / (most + (least - shared));
    return both(settled, both(least >= Doubles(0x1p-700), most <= Doubles(0x1p700)));
  }
};

}  // namespace
}  // namespace vesica
