// SPDX-License-Identifier: Apache-2.0
#include "queries/cast.hpp"

#include <vesica/impact_time.hpp>

#include "columns.hpp"
#include "fused.hpp"
#include "query.hpp"

namespace vesica {

namespace {

using detail::cast::Body;
using detail::cast::Motion;

std::int32_t answer(const Query& query, const Body& a, const Body& b, void* out) noexcept {
  return query.doubles.of[static_cast<int>(a.kind)][static_cast<int>(b.kind)](a.number, b.number, out);
}

#if VESICA_CHOOSES_FUSED
/// All that each calls is compiled into it, for processors that fuse; what exists beside them is for any.
[[gnu::target("fma"), gnu::flatten]] bool find_meeting_fused(const detail::cast::Scene& scene,
                                                             detail::cast::Meeting& out) noexcept {
  return detail::cast::find_meeting<detail::cast::FusedProducts>(scene, out);
}
template <class A, class B>
[[gnu::target("fma"), gnu::flatten]] detail::cast::EarlyOut fast_hit_fused(const A& a, const B& b, double vx, double vy,
                                                                           double end, Impact<double>& out) noexcept {
  return detail::cast::fast_hit<detail::cast::FusedProducts>(a, b, {vx, vy, end}, out);
}
detail::cast::FindMeeting fused_meeting() noexcept { return has_fused() ? find_meeting_fused : nullptr; }
#else
detail::cast::FindMeeting fused_meeting() noexcept { return detail::cast::fused_meeting; }
#endif

/// Do shapes overlap? 1, 0 or an error. The depth is computed too, for only overlapping shapes have a direction.
std::int32_t overlap_and_depth(const Body& a, const Body& b, Penetration<double>& out) noexcept {
  const std::int32_t error = answer(queries::depth, a, b, &out);
  return error != 0 ? error : out.x != 0 || out.y != 0 ? 1 : 0;
}

/// For shapes that overlap at the start, and their depth.
std::int32_t start(const Body& a, const Body& b, const Penetration<double>& penetration, Impact<double>& out) noexcept {
  ClosestPoints<double> common;
  const std::int32_t error = answer(queries::nearest, a, b, &common);
  if (error != 0) return error;
  out = {0, common.ax, common.ay, penetration.x, penetration.y};
  return cast_start;
}

}  // namespace

namespace queries {

[[gnu::noinline]] std::int32_t cast_rest(const Body& a, const Body& b, const Motion& motion,
                                         const detail::cast::Filtered& known, Impact<double>& out) noexcept {
  Penetration<double> penetration;
  const std::int32_t code = detail::cast::cast_bodies(
      a, b, motion, known, [&] { return overlap_and_depth(a, b, penetration); }, fused_meeting(), out);
  return code == cast_start ? start(a, b, penetration, out) : code;
}

namespace {

/// A pair in which one shape has a core and a radius.
[[gnu::noinline]] std::int32_t cast_cores(const Body& a, const Body& b, const Motion& motion,
                                          Impact<double>& out) noexcept {
  using detail::cast::sketch;
  const detail::cast::Cores cores(a, b);
  const detail::cast::Filtered known = detail::cast::filter(sketch(cores.a), sketch(cores.b), motion);
  Penetration<double> penetration;
  const std::int32_t code = cast_bodies(
      cores.a, cores.b, motion, known, [&] { return overlap_and_depth(a, b, penetration); }, fused_meeting(), out);
  return code == cast_start ? start(a, b, penetration, out) : code;
}

}  // namespace

[[gnu::noinline]] std::int32_t cast_open(const Body& a, const Body& b, const Motion& motion,
                                         Impact<double>& out) noexcept {
  using namespace detail::cast;
  if (is_inflated(a.kind) || is_inflated(b.kind)) return cast_cores(a, b, motion, out);
  return cast_rest(a, b, motion, detail::cast::filter(sketch(a), sketch(b), motion), out);
}

[[gnu::noinline]] std::int32_t meets(const Body& first, const Body& second, const Motion& motion) noexcept {
  using namespace detail::cast;
  const auto [a, b] = Cores(first, second);
  const Filtered known = detail::cast::filter(sketch(a), sketch(b), motion);
  if (known.verdict == Verdict::missed) return 0;
  const std::int32_t at_start = known.apart ? 0 : answer(queries::overlap, first, second, nullptr);
  if (at_start != 0) return at_start;
  if (known.verdict == Verdict::reached) return 1;
  if (known.verdict == Verdict::passed || motion.is_still()) return 0;
  if (known.verdict == Verdict::undecided) return exactly_meets(a, b, motion);
  // Double mostly knows the time, and so whether it is before the end. Of what the filter takes none is out of range.
  Impact<double> unused;
  return cast_rest(a, b, motion, {known.verdict, true}, unused);
}

template <class A, class B>
[[gnu::noinline]] detail::cast::EarlyOut fast_hit(const A& a, const B& b, double vx, double vy, double end,
                                                  Impact<double>& out) noexcept {
#if VESICA_CHOOSES_FUSED
  if (has_fused()) return fast_hit_fused(a, b, vx, vy, end, out);
#endif
  return detail::cast::fast_hit<detail::cast::UsualProducts>(a, b, {vx, vy, end}, out);
}
#define VESICA_FAST_HIT(A, B)                                                                          \
  template detail::cast::EarlyOut fast_hit(const A<double>&, const B<double>&, double, double, double, \
                                           Impact<double>&) noexcept;
VESICA_FAST_HIT(Segment, Point)
VESICA_FAST_HIT(Circle, Point)
VESICA_FAST_HIT(Aabb, Point)
VESICA_FAST_HIT(Rect, Point)
VESICA_FAST_HIT(Ellipse, Point)
VESICA_FAST_HIT(Capsule, Point)
VESICA_FAST_HIT(RoundRect, Point)
VESICA_FAST_HIT(Circle, Circle)
VESICA_FAST_HIT(Ellipse, Ellipse)
#undef VESICA_FAST_HIT

[[gnu::noinline]] std::int32_t cast(const Body& a, const Body& b, const Motion& motion, Impact<double>& out) noexcept {
  if (b.kind == Kind::point) {
    return with_core(static_cast<std::int32_t>(a.kind), [&]<template <class> class Shape>(Named<Shape>) {
      return cast_shapes(detail::cast::shape<Shape>(a), detail::cast::shape<Point>(b), motion, out);
    });
  }
  if (a.kind == Kind::circle && b.kind == Kind::circle) {
    return cast_shapes(detail::cast::shape<Circle>(a), detail::cast::shape<Circle>(b), motion, out);
  }
  if (a.kind == Kind::ellipse && b.kind == Kind::ellipse) {
    return cast_shapes(detail::cast::shape<Ellipse>(a), detail::cast::shape<Ellipse>(b), motion, out);
  }
  return cast_open(a, b, motion, out);
}

template <class T>
std::int32_t cast(const Body& a, const Body& b, const Motion& motion, Impact<T>& out) noexcept {
  Impact<double> found;
  const std::int32_t code = cast(a, b, motion, found);
  if (code <= 0) return code;
  return detail::cast::rounded_to(found, out) ? code : error_range;
}
template std::int32_t cast(const Body&, const Body&, const Motion&, Impact<float>&) noexcept;

namespace {

struct AskBodies {
  const Body &a, &b;
  Penetration<double>& at_start;

  std::int32_t overlap_at_start() const noexcept { return overlap_and_depth(a, b, at_start); }
  void nearest(const Body& p, const Body& q, ClosestPoints<double>& out) const noexcept {
    answer(queries::nearest, p, q, &out);
  }
  void depth(const Body& p, const Body& q, Penetration<double>& out) const noexcept {
    answer(queries::depth, p, q, &out);
  }
};

}  // namespace

template <class T>
std::int32_t impact_time(const Body& a, const Turn<double>& turn_a, const Body& b, const Turn<double>& turn_b,
                         double tolerance, Impact<T>& out, T& gap) noexcept {
  Impact<double> found{};
  double found_gap = 0;
  Penetration<double> penetration;
  std::int32_t code = detail::impact_time::impact_time<T>(a, turn_a, b, turn_b, tolerance, AskBodies{a, b, penetration},
                                                          found, found_gap);
  if (code == cast_start) code = start(a, b, penetration, found);
  if (code <= 0) return code;
  return detail::impact_time::rounded_to(found, found_gap, out, gap) ? code : error_range;
}
template std::int32_t impact_time(const Body&, const Turn<double>&, const Body&, const Turn<double>&, double,
                                  Impact<double>&, double&) noexcept;
template std::int32_t impact_time(const Body&, const Turn<double>&, const Body&, const Turn<double>&, double,
                                  Impact<float>&, float&) noexcept;

}  // namespace queries

namespace batch {

template <class T>
Body body_at(const Shapes<T>& shapes, std::int64_t i) noexcept {
  Body body{static_cast<Kind>(shapes.kind), {}};
  read_element(shapes, i, body.number);
  return body;
}

template Body body_at(const Shapes<double>&, std::int64_t) noexcept;
template Body body_at(const Shapes<float>&, std::int64_t) noexcept;

}  // namespace batch

}  // namespace vesica
