// SPDX-License-Identifier: Apache-2.0
// Input of the kernels of casts: any two kinds as columns of their forms, in either order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vesica/each_shape.hpp>
#include <vesica/form/form.hpp>
#include <vesica/form/inflated.hpp>

#include "kernels/query_table.hpp"

namespace vesica {

/// A column of numbers, or one that repeats.
struct Column {
  const double* at;
  std::ptrdiff_t step;  // 1, or 0
};

/// A number of a form: `to` - `from`.
struct ColumnDifference {
  Column to, from;
};

/// One operand: the parts of its form, or of its core's, differences not yet taken.
struct SideColumns {
  Column x0, y0, x1, y1;
  ColumnDifference ux, uy, hx, hy;
  bool round, disc, may_vanish, is_point, is_flat;  // flat: hy is 0
  bool has_radius = false;
  Column radius{};
};

/// Pairs whose second shape moves by v t while t runs from 0 to `end`.
struct CastColumns {
  SideColumns a, b;
  const double *vx, *vy;
  double end;
};

/// So many halves, in the length of the widest vector.
template <int halves>
inline constexpr auto constant_column = [] {
  struct Numbers {
    double x[widest_vector];
  } column{};
  for (double& x : column.x) x = 0.5 * halves;
  return column;
}();
template <int halves>
constexpr Column constant() noexcept {
  return {constant_column<halves>.x, 0};
}

struct AsColumns {
  ColumnDifference operator()(const detail::form::Length<Column>& l) const noexcept { return {l.x, constant<0>()}; }
  ColumnDifference operator()(const detail::form::Ratio<Column>& r) const noexcept { return {r.x, constant<0>()}; }
  ColumnDifference operator()(const detail::form::Difference<Column>& d) const noexcept { return {d.to, d.from}; }
  ColumnDifference operator()(const detail::form::HalfWidth<Column>& w) const noexcept { return {w.to, w.from}; }
  ColumnDifference operator()(detail::form::WidthAxis) const noexcept { return {constant<1>(), constant<0>()}; }
  ColumnDifference operator()(detail::form::Constant c) const noexcept {
    return {c.x == 0 ? constant<0>() : c.x == 1 ? constant<2>() : constant<1>(), constant<0>()};
  }
};

template <template <class> class Shape>
SideColumns side_columns(const Shape<Column>& shape) noexcept {
  const auto f = detail::form::of(shape);
  const auto place = detail::form::corners(f.place);
  constexpr AsColumns number;
  using detail::form::Outline;
  return {place.x0,
          place.y0,
          place.x1,
          place.y1,
          number(f.ux),
          number(f.uy),
          number(f.hx),
          number(f.hy),
          f.outline != Outline::straight,
          f.outline == Outline::disc,
          f.axis_may_vanish,
          kind_of<Shape> == Kind::point,
          kind_of<Shape> == Kind::segment};
}

template <template <class> class Shape, std::size_t... Field>
SideColumns side_columns(const QueryOperand& operand, std::index_sequence<Field...>) noexcept {
  const std::ptrdiff_t step = operand.repeated ? 0 : 1;
  const Shape<Column> shape{Column{operand.number[Field], step}...};
  if constexpr (detail::form::Inflated<Shape<Column>>) {
    const auto [core, radius] = detail::form::inflated(shape);
    SideColumns out = side_columns(core);
    out.has_radius = true;
    out.radius = radius;
    out.is_point = false;
    return out;
  } else {
    return side_columns(shape);
  }
}

inline SideColumns side_columns(std::int32_t kind, const QueryOperand& operand) noexcept {
  switch (static_cast<Kind>(kind)) {
#define VESICA_CASE(name, Name) \
  case Kind::name:              \
    return side_columns<Name>(operand, std::make_index_sequence<ShapeTraits<Name<double>>::fields>{});
    VESICA_EACH_SHAPE_WITH_FORM(VESICA_CASE)
    VESICA_EACH_SHAPE_INFLATED(VESICA_CASE)
#undef VESICA_CASE
#define VESICA_CASE(name, Name) case Kind::name:
    VESICA_EACH_SHAPE_WITHOUT_FORM(VESICA_CASE)
#undef VESICA_CASE
    break;
  }
  return {};
}

}  // namespace vesica
