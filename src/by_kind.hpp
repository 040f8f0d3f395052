// SPDX-License-Identifier: Apache-2.0
// From a kind and flat numbers to a shape.
#pragma once

#include <cstring>
#include <type_traits>
#include <utility>
#include <vesica/each_shape.hpp>
#include <vesica/form/form.hpp>
#include <vesica/form/inflated.hpp>
#include <vesica/polygon.hpp>
#include <vesica/shapes.hpp>

namespace vesica {

/// Shapes without a radius around a core (form/form.hpp).
using detail::form::HasForm;

/// These and cores with a radius (form/inflated.hpp). Most queries answer all of them; any other shape is an unknown
/// kind to each query that does not say that it answers it.
template <class Shape>
concept HasCore = HasForm<Shape> || detail::form::Inflated<Shape>;

/// These, polygons and polylines.
template <class Shape>
concept CoreOrPath = HasCore<Shape> || Path<Shape>;

/// Kinds whose shapes are a row of numbers: those of each_shape.hpp.
VESICA_INLINE constexpr bool is_row(std::int32_t kind) noexcept { return kind >= 0 && kind < kind_count; }
/// Those, polygons and polylines.
VESICA_INLINE constexpr bool is_kind(std::int32_t kind) noexcept { return kind >= 0 && kind < all_kinds; }
/// Polygons and polylines.
VESICA_INLINE constexpr bool has_vertices(std::int32_t kind) noexcept { return is_kind(kind) && !is_row(kind); }

/// One shape from its struct's bytes, which need no alignment.
template <class Shape>
Shape load(const void* numbers) noexcept {
  Shape shape;
  std::memcpy(&shape, numbers, sizeof shape);
  return shape;
}

/// A kind of shape without its scalar.
template <template <class> class Shape>
struct Named {};

/// action(Named<Shape>), or error_kind if it is no kind.
template <class Action>
VESICA_INLINE constexpr std::int32_t with_name(std::int32_t kind, Action action) noexcept {
  switch (static_cast<Kind>(kind)) {
#define VESICA_CASE(name, Name) \
  case Kind::name:              \
    return action(Named<Name>{});
    VESICA_EACH_SHAPE(VESICA_CASE)
#undef VESICA_CASE
  }
  return error_kind;
}

/// action(Named<Shape>) for a shape that has a form, else error_kind.
template <class Action>
VESICA_INLINE constexpr std::int32_t with_form(std::int32_t kind, Action action) noexcept {
  return with_name(kind, [&]<template <class> class Shape>(Named<Shape> name) -> std::int32_t {
    if constexpr (HasForm<Shape<double>>) {
      return action(name);
    } else {
      return error_kind;
    }
  });
}

/// action(shape), or error_kind for a shape that it does not take.
template <class Shape, class Action>
std::int32_t call_with(const void* numbers, Action& action) noexcept {
  if constexpr (std::is_invocable_v<Action&, Shape>) {
    return action(load<Shape>(numbers));
  } else {
    return error_kind;
  }
}

/// Calls action with the shape of scalar T that the kind and its struct make.
template <class T, class Action>
std::int32_t with_shape(std::int32_t kind, const void* shape, Action action) noexcept {
  if (shape == nullptr) return error_null;
  if (kind == polygon_kind) return call_with<Polygon<T>>(shape, action);
  if (kind == polyline_kind) return call_with<Polyline<T>>(shape, action);
  return with_name(kind,
                   [&]<template <class> class Shape>(Named<Shape>) { return call_with<Shape<T>>(shape, action); });
}

/// action(Named<Shape>) for a shape that has a core, else error_kind.
template <class Action>
VESICA_INLINE constexpr std::int32_t with_core(std::int32_t kind, Action action) noexcept {
  return with_name(kind, [&]<template <class> class Shape>(Named<Shape> name) -> std::int32_t {
    if constexpr (HasCore<Shape<double>>) {
      return action(name);
    } else {
      return error_kind;
    }
  });
}

/// The numbers a shape of this kind has, or error_kind.
VESICA_INLINE constexpr std::int32_t field_count(std::int32_t kind) noexcept {
  return is_row(kind) ? fields_of_kind[kind] : static_cast<std::int32_t>(error_kind);
}

/// action(std::integral_constant<int, n>), where n is one of the kinds' counts of numbers.
template <class Action>
VESICA_INLINE constexpr void with_field_count(int n, Action action) noexcept {
  constexpr auto occurs = [](int count) {
    for (const int fields : fields_of_kind) {
      if (fields == count) return true;
    }
    return false;
  };
  const auto try_count = [&]<int count>(std::integral_constant<int, count> constant) {
    if constexpr (occurs(count)) {
      if (n == count) action(constant);
    }
  };
  [&]<int... count>(std::integer_sequence<int, count...>) {
    (try_count(std::integral_constant<int, count + 1>{}), ...);
  }
  (std::make_integer_sequence<int, max_fields>{});
}

/// True if shapes of this kind have a form.
constexpr bool has_form(std::int32_t kind) noexcept {
  return with_form(kind, []<template <class> class Shape>(Named<Shape>) { return 1; }) == 1;
}

/// True if shapes of this kind have a core.
constexpr bool has_core(std::int32_t kind) noexcept {
  return with_core(kind, []<template <class> class Shape>(Named<Shape>) { return 1; }) == 1;
}

/// True if shapes of this kind have a core, or are polygons or polylines.
constexpr bool has_core_or_path(std::int32_t kind) noexcept { return has_core(kind) || has_vertices(kind); }

/// True if shapes of this kind may have an area.
constexpr bool has_area(std::int32_t kind) noexcept {
  return with_core(kind, []<template <class> class Shape>(Named<Shape>) {
           if constexpr (HasForm<Shape<double>>) return detail::form::FormOf<Shape<double>>::has_area ? 1 : 0;
           return 1;
         }) == 1;
}

}  // namespace vesica
