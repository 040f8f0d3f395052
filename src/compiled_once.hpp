// SPDX-License-Identifier: Apache-2.0
// Long functions of the core that several object files need are compiled in one of them. The others include this file:
// it declares the functions extern template, so that they are not compiled again. The core stays header-only: with
// VESICA_EACH_ALONE, as in tests/flags, an object compiles all that it calls, as users' programs do.
#pragma once

#include <vesica/area.hpp>
#include <vesica/boundary_distance.hpp>
#include <vesica/depth.hpp>
#include <vesica/each_shape.hpp>

#include "fused.hpp"

// `keyword` is `extern template` here, and `template` in the file that has the functions.

// exact_overlap.cpp
#define VESICA_EXACT_OVERLAP(keyword, A, B) \
  keyword std::int32_t detail::decide_undecided(const A<double>&, const B<double>&, Common) noexcept;

// exact_stage.cpp
#define VESICA_EXACT_STAGE(keyword, A, B)                                                             \
  keyword std::int32_t detail::decide_relation(const A<double>&, const B<double>&) noexcept;          \
  keyword std::int32_t detail::depth::undecided_overlap(const A<double>&, const B<double>&) noexcept; \
  keyword bool detail::depth::has_no_depth_exactly(const A<double>&, const B<double>&) noexcept;

// queries/area.cpp
#define VESICA_SHARES(keyword, A, B)                                                        \
  keyword std::int32_t detail::area::shares_by_relation(const A<double>&, const B<double>&, \
                                                        detail::area::Shares&) noexcept;

#define VESICA_SHAPE_MEASURE(keyword, Shape) \
  keyword detail::area::Measure detail::area::shape_measure(const Shape<double>&) noexcept;
#define VESICA_EACH_SHAPE_WITH_AREA(X, keyword) X(keyword, Circle) X(keyword, Aabb) X(keyword, Rect) X(keyword, Ellipse)

// queries/crossings.cpp
#define VESICA_ONE_PLACE(keyword, A, B)                                                           \
  keyword bool detail::crossings::one_place(const A<double>&, const B<double>&, double&, double&, \
                                            const std::optional<detail::crossings::Census>&) noexcept;

// queries/depth.cpp
#define VESICA_DEPTH_IN_ORDER(keyword, A, B)                                                           \
  keyword std::int32_t detail::depth::depth_in_order(const A<double>&, const B<double>&, std::int32_t, \
                                                     Penetration<double>&) noexcept;

// queries/nearest.cpp
#define VESICA_NEAREST(keyword, A, B)                                                                      \
  keyword std::int32_t detail::nearest::nearest_in_order(const A<double>&, const B<double>&, std::int32_t, \
                                                         ClosestPoints<double>&) noexcept;

// queries/relation.cpp
#define VESICA_RELATION(keyword, A, B) \
  keyword std::int32_t detail::called_relation(const A<double>&, const B<double>&) noexcept;

#ifndef VESICA_EACH_ALONE
namespace vesica {

#define VESICA_DECLARE(a, A, b, B) VESICA_EXACT_OVERLAP(extern template, A, B)
VESICA_EACH_PAIR(VESICA_DECLARE)
#undef VESICA_DECLARE

#define VESICA_DECLARE(a, A, b, B)             \
  VESICA_EXACT_STAGE(extern template, A, B)    \
  VESICA_SHARES(extern template, A, B)         \
  VESICA_ONE_PLACE(extern template, A, B)      \
  VESICA_DEPTH_IN_ORDER(extern template, A, B) \
  VESICA_NEAREST(extern template, A, B)        \
  VESICA_RELATION(extern template, A, B)
VESICA_EACH_PAIR_OF_FORMS(VESICA_DECLARE)
#undef VESICA_DECLARE

#define VESICA_DECLARE(a, A, b, B)             \
  VESICA_DEPTH_IN_ORDER(extern template, A, B) \
  VESICA_NEAREST(extern template, A, B)
VESICA_EACH_PAIR_INFLATED(VESICA_DECLARE)
#undef VESICA_DECLARE

VESICA_EACH_SHAPE_WITH_AREA(VESICA_SHAPE_MEASURE, extern template)

#if VESICA_CHOOSES_FUSED
// queries/area_in_disc.cpp
template <>
double detail::area::called_area_in_disc(const detail::area::Against<detail::area::DoubleDouble>&) noexcept;
#endif

}  // namespace vesica
#endif
