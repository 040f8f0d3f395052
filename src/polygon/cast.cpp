// SPDX-License-Identifier: Apache-2.0
#include "queries/cast.hpp"

#include <vesica/polygon/impact_time.hpp>

#include "polygon/operand.hpp"

namespace vesica {

namespace detail::polygon {

inline bool is_thin(const AnyShape& s, const Heading& v) noexcept {
  return with_shape(s, [&v](const auto& shape) { return polygon::is_thin(shape, v); });
}

}  // namespace detail::polygon

namespace polygon {

namespace {

using detail::cast::Body;
using detail::cast::Motion;

using detail::polygon::Box;
using detail::polygon::box_of;
using detail::polygon::Edge;
using detail::polygon::may_touch;
using detail::polygon::opposite;

Body body_of(const Edge& e) noexcept { return {Kind::segment, {e.x0, e.y0, e.x1, e.y1}}; }
Body body_of(const AnyShape& s) noexcept {
  Body body{static_cast<Kind>(s.kind), {}};
  std::memcpy(body.number, s.number, sizeof s.number);
  return body;
}

/// By the function that exists once for all kinds.
struct AskBodies {
  template <class A, class B>
  std::int32_t operator()(const A& a, const B& b, const Motion& motion, Impact<double>& out) const noexcept {
    return queries::cast(body_of(a), body_of(b), motion, out);
  }
};

/// Is there contact by the end? An edge that is undecided counts only if no other one is met.
struct Meets {
  const Motion& motion;
  std::int32_t error = 0;

  template <class A, class B>
  bool any(const A& a, const B& b) noexcept {
    const std::int32_t code = queries::meets(body_of(a), body_of(b), motion);
    if (code < 0) error = code;
    return code > 0;
  }
  // A walk asks this about two paths.
  bool keeps(const Box& a, const Box& b) const noexcept { return may_touch(a, b, motion); }
  bool visit(const Edge& e, std::int64_t, const Edge& f, std::int64_t) noexcept { return any(e, f); }
};

template <class T>
bool any_edge_meets(const Edges<T>& a, const Box&, const AnyShape& b, const Box& about, bool reversed,
                    Meets& meets) noexcept {
  const Motion relative = reversed ? opposite(meets.motion) : meets.motion;
  return a.for_edges([&](const Edge& e, std::int64_t) {
    return may_touch(box_of(e), about, relative) && (reversed ? meets.any(b, e) : meets.any(e, b));
  });
}
template <class T>
bool any_edge_meets(const Edges<T>& a, const Box& box_a, const Edges<T>& b, const Box& box_b, bool,
                    Meets& meets) noexcept {
  return walk(a, box_a, b, box_b, meets);
}

/// Finds the distance of a segment and an ellipse for impact_time().
struct AskNearest {
  void nearest(const Body& segment, const Body& ellipse, ClosestPoints<double>& out) const noexcept {
    constexpr auto of = [](Kind kind) { return static_cast<int>(kind); };
    queries::nearest.doubles.of[of(Kind::segment)][of(Kind::ellipse)](segment.number, ellipse.number, &out);
  }
};

}  // namespace

bool is_valid(const Operand& s) noexcept {
  const auto check = [&s](auto number) {
    using T = decltype(number);
    return vesica::with_shape<T>(s.kind, s.shape, [](const auto& shape) { return vesica::check(shape); }) == 0;
  };
  return s.is_float ? check(float{}) : check(double{});
}

std::int32_t cast(const Operand& a, const Operand& b, const Motion& motion, Impact<double>& out) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    return detail::polygon::cast_or_error(edges, other, reversed, motion, AskBodies{}, out);
  });
}

std::int32_t meets(const Operand& a, const Operand& b, const Motion& motion) noexcept {
  return with_edges(a, b, [&](const auto& edges, const auto& other, bool reversed) -> std::int32_t {
    Box box, about;
    if (!detail::polygon::is_valid(edges, box) || !detail::polygon::is_valid(other, about)) return error_shape;
    if (!may_touch(box, about, reversed ? opposite(motion) : motion)) return 0;
    Meets meets{motion};
    if (any_edge_meets(edges, box, other, about, reversed, meets)) return 1;
    return detail::polygon::overlap_valid(edges, box, other, about) ? 1 : meets.error;
  });
}

template <class T>
std::int32_t impact_time(const Operand& a, const Turn<double>& turn_a, const Operand& b, const Turn<double>& turn_b,
                         double tolerance, Impact<T>& out, T& gap) noexcept {
  Impact<double> found{};
  double found_gap = 0;
  std::int32_t code = with_edges_of<T>(a, b, [&](const auto& edges, const auto& other, bool reversed) {
    using detail::polygon::turning::impact_time_or_error;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(other)>, AnyShape>) {
      return impact_time_or_error<T>(edges, reversed ? turn_b : turn_a, other, body_of(other),
                                     reversed ? turn_a : turn_b, reversed, tolerance, AskNearest{}, found, found_gap);
    } else {
      static_cast<void>(reversed);
      return impact_time_or_error<T>(edges, turn_a, other, turn_b, tolerance, AskNearest{}, found, found_gap);
    }
  });
  if (code == cast_start) code = cast(a, b, {0, 0, 0}, found);
  if (code <= 0) return code;
  return detail::impact_time::rounded_to(found, found_gap, out, gap) ? code : static_cast<std::int32_t>(error_range);
}
template std::int32_t impact_time(const Operand&, const Turn<double>&, const Operand&, const Turn<double>&, double,
                                  Impact<double>&, double&) noexcept;
template std::int32_t impact_time(const Operand&, const Turn<double>&, const Operand&, const Turn<double>&, double,
                                  Impact<float>&, float&) noexcept;

}  // namespace polygon
}  // namespace vesica
