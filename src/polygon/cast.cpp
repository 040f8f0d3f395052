// SPDX-License-Identifier: Apache-2.0
#include "queries/cast.hpp"

#include <vesica/polygon/cast.hpp>

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

Body body_of(const detail::polygon::Edge& e) noexcept { return {Kind::segment, {e.x0, e.y0, e.x1, e.y1}}; }
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

}  // namespace polygon
}  // namespace vesica
