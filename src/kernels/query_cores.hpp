// SPDX-License-Identifier: Apache-2.0
// Each query's computation for one vector of pairs: the core's templates, as the scalar functions use them.
//
// evaluate(a, b, known, out) writes the results and returns the lanes in which they are final. For the other lanes the
// scalar function is asked, which begins with the same step and then continues with slower ones.
#pragma once

#include <vesica/area.hpp>
#include <vesica/nearest.hpp>
#include <vesica/relation.hpp>

#include "kernels/query_table.hpp"

namespace vesica {
namespace {

using detail::nearest::MaskOf;
using PairMask = MaskOf<Doubles>;

/// Facts known about a vector of pairs beforehand, if the query needs it.
template <class V>
struct KnownLanes {
  V overlap;  // 1 or 0
  V area_a, area_b;
  V radius_a, radius_b;
};

struct RelationCore {
  static constexpr int results = 1;
  template <class A, class B>
  VESICA_INLINE static PairMask evaluate(const A& a, const B& b, const KnownLanes<Doubles>&, Doubles* out) noexcept {
    const auto certain = filter::certain_relation(detail::relation::certain_facts(a, b));
    const auto code = [](Relation relation) { return Doubles(static_cast<double>(relation)); };
    const Doubles nested = select(certain.inside, code(Relation::inside), code(Relation::contains));
    out[0] = select(certain.disjoint, code(Relation::disjoint), select(certain.cross, code(Relation::cross), nested));
    return either(either(certain.disjoint, certain.cross), either(certain.inside, certain.contains));
  }
};

template <class V, class A, class B>
VESICA_INLINE MaskOf<V> closest_points(const A& a, const B& b, MaskOf<V> overlapping, V* out) noexcept {
  const auto lanes = detail::nearest::lane_answer(a, b, overlapping);
  const V points[] = {lanes.distance, lanes.ax, lanes.ay, lanes.bx, lanes.by};
  for (int k = 0; k < 5; ++k) out[k] = points[k];
  return both(lanes.settled, detail::all_finite(lanes.distance, lanes.ax, lanes.ay, lanes.bx, lanes.by));
}

struct NearestCore {
  static constexpr int results = 5;
  template <class V, class A, class B>
  VESICA_INLINE static MaskOf<V> evaluate(const A& a, const B& b, const KnownLanes<V>& known, V* out) noexcept {
    return closest_points(a, b, known.overlap > V(0.0), out);
  }
};

/// Are the circles about two shapes apart? The sum r of their radii is relatively 2^-48 too
/// large, and an operation here errs relatively by 2^-53, so rounding cannot make d^2 > r^2 wrong.
VESICA_INLINE PairMask circles_apart(Doubles dx, Doubles dy, Doubles radii) noexcept {
  return dx * dx + dy * dy > radii * radii;
}

/// The area of valid rectangles that certainly cross or are certainly disjoint.
VESICA_INLINE PairMask shared_area(const Rect<Doubles>& a, const Rect<Doubles>& b, const KnownLanes<Doubles>& known,
                                   Doubles& area) noexcept {
  const PairMask disjoint = detail::overlap::filter(a, b).disjoint,
                 valid = known.radius_a + known.radius_b > Doubles(0.0);
  area = Doubles(0.0);
  if (all(both(disjoint, valid))) return disjoint;
  const auto crossing = detail::area::crossing_area(a, b);
  area = select(disjoint, area, crossing.area);
  return both(either(disjoint, crossing.settled), valid);
}

/// The same of AABBs.
VESICA_INLINE PairMask shared_area(const Aabb<Doubles>& a, const Aabb<Doubles>& b, const KnownLanes<Doubles>&,
                                   Doubles& area) noexcept {
  const auto quick = detail::area::quick_area(a, b);
  area = quick.area;
  return quick.settled;
}

struct AreaCore {
  static constexpr int results = 1;
  template <class Box>
  VESICA_INLINE static PairMask evaluate(const Box& a, const Box& b, const KnownLanes<Doubles>& known,
                                         Doubles* out) noexcept {
    return shared_area(a, b, known, out[0]);
  }
};

/// What is settled has areas of moderate size, so the scaling with which iou() avoids overflow is left out. The bits
/// are the same.
struct IouCore {
  static constexpr int results = 1;
  template <class Box>
  VESICA_INLINE static PairMask evaluate(const Box& a, const Box& b, const KnownLanes<Doubles>& known,
                                         Doubles* out) noexcept {
    Doubles shared;
    const PairMask settled = shared_area(a, b, known, shared);
    const Doubles most = max(known.area_a, known.area_b), least = min(known.area_a, known.area_b);
    out[0] = shared / (most + (least - shared));
    return settled;
  }
};

}  // namespace
}  // namespace vesica
