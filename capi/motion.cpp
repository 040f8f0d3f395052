// SPDX-License-Identifier: Apache-2.0
// Shapes that move: two, arrays of them, and one through an index.
#include <cmath>
#include <cstring>
#include <limits>
#include <vesica/arithmetic/length.hpp>
#include <vesica/impact_time.hpp>
#include <vesica/polygon/bounds.hpp>

#include "index_arguments.hpp"
#include "join/cast.hpp"
#include "join/nearest.hpp"
#include "queries/cast.hpp"

namespace {

using namespace vesica::capi;
using vesica::Impact;
using vesica::batch::body_at;
using vesica::detail::cast::Body;
using vesica::detail::cast::EarlyOut;
using vesica::detail::cast::Motion;
namespace index = vesica::index;

static_assert(vesica::cast_miss == VESICA_CAST_MISS && vesica::cast_hit == VESICA_CAST_HIT &&
              vesica::cast_start == VESICA_CAST_START && vesica::cast_near == VESICA_CAST_NEAR);
static_assert(sizeof(Impact<double>) == sizeof(vesica_impact_f64) &&
              sizeof(Impact<float>) == sizeof(vesica_impact_f32));

template <class Out, class T>
void write(const Impact<T>& impact, Out* out) noexcept {
  *out = {impact.t, impact.x, impact.y, impact.nx, impact.ny};
}

template <class T>
Motion motion_of(T vx, T vy, T end) noexcept {
  return {static_cast<double>(vx), static_cast<double>(vy), static_cast<double>(end)};
}

template <class T>
Body body_of(int32_t kind, const void* shape) noexcept {
  const T* const numbers = static_cast<const T*>(shape);
  Body body{static_cast<vesica::Kind>(kind), {}};
  for (int k = 0; k < vesica::field_count(kind); ++k) body.number[k] = static_cast<double>(numbers[k]);
  return body;
}

/// For shapes whose kinds are known when this is compiled. The C structs are the core's shapes and contacts byte for
/// byte, and of doubles its result is written where it shall be. `told`: the result of the early out, where it was
/// asked before.
template <class A, class B, class T, class... Told>
VESICA_INLINE int32_t cast_shapes(const void* a, const void* b, const Motion& motion, void* out,
                                  Told... told) noexcept {
  using vesica::detail::cast::in_double;
  const A& first = *static_cast<const A*>(a);
  const B& second = *static_cast<const B*>(b);
  Impact<T>& to = *static_cast<Impact<T>*>(out);
  if constexpr (std::is_same_v<T, double>) {
    const int32_t code = vesica::queries::cast_shapes(first, second, motion, to, told...);
    if (code == VESICA_CAST_MISS) to = vesica::detail::cast::no_impact<double>();
    return code;
  } else {
    Impact<double> found;
    const int32_t code = vesica::queries::cast_shapes(in_double(first), in_double(second), motion, found, told...);
    if (code == VESICA_CAST_MISS) to = vesica::detail::cast::no_impact<T>();
    if (code > 0 && !vesica::detail::cast::rounded_to(found, to)) return VESICA_E_RANGE;
    return code;
  }
}

template <class A, class B, class T>
int32_t cast_known(const void* a, const void* b, T vx, T vy, T end, void* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((cast_known<A, B, T>), a, b, vx, vy, end, out);
  return cast_shapes<A, B, T>(a, b, motion_of(vx, vy, end), out);
}

/// For calls that have not read the control register.
template <class A, class B, class T>
int32_t rest_of_cast(const void* a, const void* b, T vx, T vy, T end, void* out, EarlyOut told) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((cast_known<A, B, T>), a, b, vx, vy, end, out);
  return cast_shapes<A, B, T>(a, b, motion_of(vx, vy, end), out, told);
}

/// The same by kinds: of the pairs that CallTable has casts of.
template <class T>
struct RestOfCasts {
  vesica::RestOfCast<T> of[vesica::kind_count][vesica::kind_count];
};
template <class T>
consteval RestOfCasts<T> rest_of_casts() noexcept {
  RestOfCasts<T> rest{};
  rest.of[VESICA_SEGMENT][VESICA_POINT] = rest_of_cast<vesica::Segment<T>, vesica::Point<T>, T>;
  rest.of[VESICA_CIRCLE][VESICA_POINT] = rest_of_cast<vesica::Circle<T>, vesica::Point<T>, T>;
  rest.of[VESICA_AABB][VESICA_POINT] = rest_of_cast<vesica::Aabb<T>, vesica::Point<T>, T>;
  rest.of[VESICA_RECT][VESICA_POINT] = rest_of_cast<vesica::Rect<T>, vesica::Point<T>, T>;
  rest.of[VESICA_ELLIPSE][VESICA_POINT] = rest_of_cast<vesica::Ellipse<T>, vesica::Point<T>, T>;
  rest.of[VESICA_CAPSULE][VESICA_POINT] = rest_of_cast<vesica::Capsule<T>, vesica::Point<T>, T>;
  rest.of[VESICA_ROUND_RECT][VESICA_POINT] = rest_of_cast<vesica::RoundRect<T>, vesica::Point<T>, T>;
  rest.of[VESICA_CIRCLE][VESICA_CIRCLE] = rest_of_cast<vesica::Circle<T>, vesica::Circle<T>, T>;
  return rest;
}
template <class T>
constinit const RestOfCasts<T> casts_by_kind = rest_of_casts<T>();

/// True if casts take shapes of this kind.
constexpr bool casts_take(int32_t kind) noexcept { return vesica::has_core(kind) || vesica::has_vertices(kind); }

template <class T, class Out>
int32_t cast_path(int32_t kind_a, const void* a, int32_t kind_b, const void* b, const Motion& motion,
                  Out* out) noexcept {
  if (!casts_take(kind_a) || !casts_take(kind_b)) return VESICA_E_KIND;
  if (!vesica::detail::cast::is_sound(motion)) return VESICA_E_ARGUMENT;
  Impact<T> impact = vesica::detail::cast::no_impact<T>();
  constexpr bool is_float = std::is_same_v<T, float>;
  const int32_t code = vesica::polygon::cast({kind_a, is_float, a}, {kind_b, is_float, b}, motion, impact);
  if (code >= 0) write(impact, out);
  return code;
}

template <class T, class Out>
int32_t cast_any(int32_t kind_a, const void* a, int32_t kind_b, const void* b, T vx, T vy, T end, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((cast_any<T, Out>), kind_a, a, kind_b, b, vx, vy, end, out);
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  const Motion motion = motion_of(vx, vy, end);
  if (vesica::has_vertices(kind_a) || vesica::has_vertices(kind_b))
    return cast_path<T>(kind_a, a, kind_b, b, motion, out);
  if (!vesica::has_core(kind_a) || !vesica::has_core(kind_b)) return VESICA_E_KIND;
  if (kind_b == VESICA_POINT) {
    return vesica::with_core(kind_a, [&]<template <class> class Shape>(vesica::Named<Shape>) {
      return cast_shapes<Shape<T>, vesica::Point<T>, T>(a, b, motion, out);
    });
  }
  if (kind_a == VESICA_CIRCLE && kind_b == VESICA_CIRCLE) {
    return cast_shapes<vesica::Circle<T>, vesica::Circle<T>, T>(a, b, motion, out);
  }
  if (!vesica::detail::cast::is_sound(motion)) return VESICA_E_ARGUMENT;
  Impact<T> impact = vesica::detail::cast::no_impact<T>();
  const int32_t code = vesica::queries::cast(body_of<T>(kind_a, a), body_of<T>(kind_b, b), motion, impact);
  if (code >= 0) write(impact, out);
  return code;
}

template <class T, class Out>
VESICA_INLINE int32_t cast(int32_t kind_a, const void* a, int32_t kind_b, const void* b, T vx, T vy, T end,
                           Out* out) noexcept {
  const vesica::CallTable* const calls = vesica::chosen_calls();
  const bool given = a != nullptr && b != nullptr && out != nullptr;
  if (calls != nullptr && given && vesica::is_row(kind_a) && vesica::is_row(kind_b)) {
    const auto call = calls->cast(T{}, kind_a, kind_b);
    if (call != nullptr) return call(a, b, vx, vy, end, out, casts_by_kind<T>.of[kind_a][kind_b]);
  }
  return cast_any(kind_a, a, kind_b, b, vx, vy, end, out);
}

template <class A, class B, class T>
VESICA_INLINE int32_t cast_typed(const void* a, const void* b, T vx, T vy, T end, void* out) noexcept {
  if (a == nullptr || b == nullptr || out == nullptr) return VESICA_E_NULL;
  constexpr int kind_a = static_cast<int>(vesica::ShapeTraits<A>::kind);
  constexpr int kind_b = static_cast<int>(vesica::ShapeTraits<B>::kind);
  // The pairs of kinds that CallTable has casts of.
  if constexpr ((kind_a != VESICA_POINT && kind_b == VESICA_POINT) ||
                (kind_a == VESICA_CIRCLE && kind_b == VESICA_CIRCLE)) {
    const vesica::CallTable* const calls = vesica::chosen_calls();
    if (calls != nullptr) [[likely]]
      return calls->cast(T{}, kind_a, kind_b)(a, b, vx, vy, end, out, rest_of_cast<A, B, T>);
  }
  return cast_known<A, B, T>(a, b, vx, vy, end, out);
}

template <class CTurn>
vesica::Turn<double> turn_of(const CTurn& t) noexcept {
  return {static_cast<double>(t.vx), static_cast<double>(t.vy), static_cast<double>(t.angle)};
}

template <class T, class CTurn, class Out>
int32_t impact_time(int32_t kind_a, const void* a, const CTurn* turn_a, int32_t kind_b, const void* b,
                    const CTurn* turn_b, T tolerance, Out* out, T* gap) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((impact_time<T, CTurn, Out>), kind_a, a, turn_a, kind_b, b, turn_b, tolerance, out, gap);
  if (a == nullptr || turn_a == nullptr || b == nullptr || turn_b == nullptr) return VESICA_E_NULL;
  if (out == nullptr || gap == nullptr) return VESICA_E_NULL;
  if (!casts_take(kind_a) || !casts_take(kind_b)) return VESICA_E_KIND;
  const vesica::Turn<double> first = turn_of(*turn_a), second = turn_of(*turn_b);
  const bool sound = vesica::detail::impact_time::is_sound(first) && vesica::detail::impact_time::is_sound(second);
  if (!sound || !(tolerance > 0)) return VESICA_E_ARGUMENT;
  Impact<T> impact = vesica::detail::cast::no_impact<T>();
  T most = impact.x;
  const auto enough = static_cast<double>(tolerance);
  constexpr bool is_float = std::is_same_v<T, float>;
  const int32_t code = vesica::is_row(kind_a) && vesica::is_row(kind_b)
                           ? vesica::queries::impact_time(body_of<T>(kind_a, a), first, body_of<T>(kind_b, b), second,
                                                          enough, impact, most)
                           : vesica::polygon::impact_time({kind_a, is_float, a}, first, {kind_b, is_float, b}, second,
                                                          enough, impact, most);
  if (code < 0) return code;
  write(impact, out);
  *gap = most;
  return code;
}

/// The numbers of velocities, one or as many as there are pairs.
template <class T>
int64_t many(const CShapesOf<T>* a, const CShapesOf<T>* b, const T* vx, const T* vy, ptrdiff_t stride, T end,
             T* const (&columns)[5]) noexcept {
  const void* some = nullptr;
  for (const T* column : columns) some = column != nullptr ? column : some;
  const bool has_velocities = vx != nullptr && vy != nullptr;
  const int32_t error = check_call(a, b, has_velocities ? some : nullptr, anything(a, b), casts_take);
  if (error != 0) return error;
  const int64_t n = pairs_in_step(*a, *b);
  if (n < 0 || !addressable(n, stride) || !(end >= 0)) return VESICA_E_ARGUMENT;
  const vesica::batch::CastTally tally =
      vesica::batch::cast_many<T>(view<T>(*a), view<T>(*b), n, {vx, vy, stride}, static_cast<double>(end), columns);
  return tally.error != 0 ? tally.error : tally.hits;
}

template <class T>
int64_t many_columns(const CShapesOf<T>* a, const CShapesOf<T>* b, const T* vx, const T* vy, ptrdiff_t stride, T end,
                     T* t, T* x, T* y, T* nx, T* ny) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(many_columns<T>, a, b, vx, vy, stride, end, t, x, y, nx, ny);
  return many<T>(a, b, vx, vy, stride, end, {t, x, y, nx, ny});
}

template <class T, class Out>
int64_t first(const CShapesOf<T>* shapes, const CShapesOf<T>* one, T vx, T vy, T end, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((first<T, Out>), shapes, one, vx, vy, end, out);
  if (out == nullptr) return VESICA_E_NULL;
  const int32_t error = check_call(shapes, one, out, anything(shapes, one), casts_take);
  if (error != 0) return error;
  if (one->count == 1 && has_null(*one)) return VESICA_E_NULL;  // it is looked at even if there are no others
  const Motion motion = motion_of(vx, vy, end);
  if (one->count != 1 || !vesica::detail::cast::is_sound(motion)) return VESICA_E_ARGUMENT;
  Impact<T> impact;
  const auto found = vesica::batch::cast_first<T>(view<T>(*shapes), view<T>(*one), motion, impact);
  if (found.error != 0) return found.error;
  write(impact, out);
  return found.index;
}

template <class T, class Out>
int32_t sweep_bounds(int32_t kind, const void* shape, T vx, T vy, T end, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((sweep_bounds<T, Out>), kind, shape, vx, vy, end, out);
  if (out == nullptr) return VESICA_E_NULL;
  vesica::Aabb<T> box;
  const int32_t error = vesica::with_shape<T>(
      kind, shape, [&](const vesica::CoreOrPath auto& s) { return vesica::sweep_bounds(s, vx, vy, end, box); });
  if (error == 0) *out = {box.min_x, box.min_y, box.max_x, box.max_y};
  return error;
}

/// An item of an index's sets as an operand, which points to what is kept here.
template <class T>
struct Item {
  vesica::Operand operand;
  T number[vesica::max_fields];
  vesica::Polygon<T> path;

  Item(const index::Sets& sets, std::uint32_t item) noexcept {
    const index::Set& set = sets.set[sets.of(item)];
    const bool row = vesica::is_row(set.kind);
    operand = {set.kind, std::is_same_v<T, float>, row ? static_cast<const void*>(number) : &path};
    if (row) {
      for (int k = 0; k < vesica::field_count(set.kind); ++k) number[k] = index::number_of<T>(set, k, item);
    } else {
      path = vesica::path_at<T>(set.paths(), static_cast<int64_t>(item) - set.first);
    }
  }
  Item(const Item&) = delete;
  Item& operator=(const Item&) = delete;
};

/// A moving shape, and the sets of an index that it is asked about.
template <class T>
struct Moving {
  const index::Sets &sets, &single;
  Body body;  // the moving shape, unless it is a path
  Motion motion;
  Impact<T> last, first;  // of the item asked about last, and of the one hit first

  bool with_path(std::uint32_t item) const noexcept {
    return !vesica::is_row(single.set[0].kind) || !vesica::is_row(sets.set[sets.of(item)].kind);
  }
  Body still(std::uint32_t item) const noexcept {
    Body out{};
    out.kind = static_cast<vesica::Kind>(index::read_item<T>(sets, item, out.number));
    return out;
  }
  static int32_t ask(void* context, std::uint32_t item, double end, double& t) {
    Moving& moving = *static_cast<Moving*>(context);
    const Motion until{moving.motion.vx, moving.motion.vy, end};
    const int32_t code = moving.with_path(item)
                             ? vesica::polygon::cast(Item<T>(moving.sets, item).operand,
                                                     Item<T>(moving.single, 0).operand, until, moving.last)
                             : vesica::queries::cast(moving.still(item), moving.body, until, moving.last);
    t = static_cast<double>(moving.last.t);
    return code;
  }
  static int32_t meets(const void* context, std::uint32_t item) {
    const Moving& moving = *static_cast<const Moving*>(context);
    return moving.with_path(item) ? vesica::polygon::meets(Item<T>(moving.sets, item).operand,
                                                           Item<T>(moving.single, 0).operand, moving.motion)
                                  : vesica::queries::meets(moving.still(item), moving.body, moving.motion);
  }
  static void prefetch(const void* context, std::uint32_t item) {
    const Moving& moving = *static_cast<const Moving*>(context);
    const index::Set& set = moving.sets.set[moving.sets.of(item)];
    if (!vesica::is_row(set.kind)) return;
    for (int k = 0; k < vesica::field_count(set.kind); ++k) {
      __builtin_prefetch(set.field[k] + (static_cast<int64_t>(item) - set.first) * set.stride);
    }
  }
  static void keep(void* context) {
    Moving& moving = *static_cast<Moving*>(context);
    moving.first = moving.last;
  }
};

/// A shape that moves and turns among items at rest, as Moving does.
template <class T>
struct TurningAmong : Moving<T> {
  vesica::Turn<double> turn;
  double tolerance;
  int32_t last_answer, answer;
  T last_gap, gap;

  static int32_t ask(void* context, std::uint32_t item, double end, double& t) {
    TurningAmong& self = *static_cast<TurningAmong*>(context);
    constexpr vesica::Turn<double> rest{0, 0, 0};
    self.last_answer = self.with_path(item) ? vesica::polygon::impact_time(Item<T>(self.sets, item).operand, rest,
                                                                           Item<T>(self.single, 0).operand, self.turn,
                                                                           self.tolerance, self.last, self.last_gap)
                                            : vesica::queries::impact_time(self.still(item), rest, self.body, self.turn,
                                                                           self.tolerance, self.last, self.last_gap);
    t = static_cast<double>(self.last.t);
    return self.last_answer > 0 && t > end ? VESICA_CAST_MISS : self.last_answer;
  }
  static void prefetch(const void* context, std::uint32_t item) {
    Moving<T>::prefetch(static_cast<const Moving<T>*>(static_cast<const TurningAmong*>(context)), item);
  }
  static void keep(void* context) {
    TurningAmong& self = *static_cast<TurningAmong*>(context);
    self.first = self.last;
    self.answer = self.last_answer;
    self.gap = self.last_gap;
  }
};

/// Widens the bounds of a shape to those of its turns about their middle, and by the tolerance. No point of it is
/// farther from the middle than half their diagonal r, so none moves farther than r |angle|.
void widen_by_turn(double angle, double tolerance, double (&box)[4]) noexcept {
  constexpr double more = 1 + 0x1p-50, largest = std::numeric_limits<double>::max();
  const double r = vesica::detail::arithmetic::length(0.5 * box[2] - 0.5 * box[0], 0.5 * box[3] - 0.5 * box[1]) * more;
  const double arc = r * std::fabs(angle) * more;
  for (int axis = 0; axis < 2; ++axis) {
    double &low = box[axis], &high = box[axis + 2];
    const double middle = 0.5 * low + 0.5 * high;
    const double rounding = 0x1p-50 * (std::fabs(low) + std::fabs(high) + r + tolerance);
    const double from = std::fmax(middle - r, low - arc), to = std::fmin(middle + r, high + arc);
    low = std::fmax(from - (tolerance + rounding), -largest);
    high = std::fmin(to + (tolerance + rounding), largest);
  }
}

/// An index, its sets, and a single shape with its bounds.
struct Among {
  const void* index;
  index::Sets items, single;
  double box[4];
};

/// Checks the arguments of functions of an index, then calls action(among). is_sound() checks the other arguments, once
/// there is an index.
template <class T, class IsSound, class Action>
int64_t with_index(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one,
                   const IsSound& is_sound, const Action& action) noexcept {
  if (one == nullptr) return VESICA_E_NULL;
  Among among{from, {}, {}, {}};
  const int32_t of_shapes = first_error(view_sets<T>(one, 1, among.single, casts_take),
                                        view_sets<T>(sets, set_count, among.items, casts_take));
  const int32_t error = first_error(check_index(from), of_shapes);
  if (error != 0) return error;
  const bool fits = among.single.items == 1 && among.items.items == index::View(from).items();
  if (!fits || !is_sound()) return VESICA_E_ARGUMENT;
  if (!index::bounds_of_item(index_kernels(), among.single, 0, among.box)) return VESICA_E_SHAPE;
  return action(among);
}

template <class T>
Moving<T> moving_among(const Among& among, const CShapesOf<T>& one, const Motion& motion) noexcept {
  constexpr Impact<T> none = vesica::detail::cast::no_impact<T>();
  return {among.items, among.single, vesica::is_row(one.kind) ? body_at(view<T>(one), 0) : Body{}, motion, none, none};
}

index::Cast cast_of(const Among& among, const Motion& motion, const index::Targets& targets) noexcept {
  return {among.index, targets, among.box, motion.vx, motion.vy, motion.end, among.items.is_float};
}

/// The same for casts: action(cast, moving) answers.
template <class T, class IsSound, class Action>
int64_t through_index(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one,
                      const Motion& motion, const IsSound& is_sound, const Action& action) noexcept {
  return with_index<T>(
      from, sets, set_count, one, [&] { return vesica::detail::cast::is_sound(motion) && is_sound(); },
      [&](const Among& among) {
        Moving<T> moving = moving_among<T>(among, *one, motion);
        return action(
            cast_of(among, motion, {&moving, Moving<T>::ask, Moving<T>::meets, Moving<T>::prefetch, Moving<T>::keep}),
            moving);
      });
}

template <class T>
int64_t index_all(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one, T vx, T vy,
                  T end, int64_t* out, int64_t capacity, int64_t* state) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(index_all<T>, from, sets, set_count, one, vx, vy, end, out, capacity, state);
  if (capacity > 0 && (out == nullptr || state == nullptr)) return VESICA_E_NULL;
  const auto is_sound = [&] { return capacity == 0 || (capacity > 0 && index::cast_state_is_sound(from, state)); };
  return through_index<T>(from, sets, set_count, one, motion_of(vx, vy, end), is_sound,
                          [&](const auto& cast, const auto&) { return index::write_hits(cast, out, capacity, state); });
}

template <class T, class Out>
int64_t index_first(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one, T vx, T vy,
                    T end, Out* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((index_first<T, Out>), from, sets, set_count, one, vx, vy, end, out);
  if (out == nullptr) return VESICA_E_NULL;
  const auto is_sound = [] { return true; };
  return through_index<T>(from, sets, set_count, one, motion_of(vx, vy, end), is_sound,
                          [&](const auto& cast, const auto& moving) {
                            const index::FirstItem found = index::find_first_hit(cast);
                            if (found.error != 0) return int64_t{found.error};
                            write(moving.first, out);
                            return found.item;
                          });
}

template <class T, class CTurn, class Out>
int64_t index_impact_time(const void* from, const CShapesOf<T>* sets, int32_t set_count, const CShapesOf<T>* one,
                          const CTurn* turn, T tolerance, Out* out, T* gap, int32_t* answer) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((index_impact_time<T, CTurn, Out>), from, sets, set_count, one, turn, tolerance, out, gap,
                             answer);
  if (turn == nullptr || out == nullptr || gap == nullptr || answer == nullptr) return VESICA_E_NULL;
  const auto enough = static_cast<double>(tolerance);
  return with_index<T>(
      from, sets, set_count, one, [&] { return vesica::detail::impact_time::is_sound(turn_of(*turn)) && enough > 0; },
      [&](Among& among) {
        const vesica::Turn<double> way = turn_of(*turn);
        widen_by_turn(way.angle, enough, among.box);
        const Motion motion{way.vx, way.vy, 1};
        constexpr T none = std::numeric_limits<T>::quiet_NaN();
        TurningAmong<T> moving{
            moving_among<T>(among, *one, motion), way, enough, VESICA_CAST_MISS, VESICA_CAST_MISS, none, none};
        const index::FirstItem found = index::find_first_hit(cast_of(
            among, motion, {&moving, TurningAmong<T>::ask, nullptr, TurningAmong<T>::prefetch, TurningAmong<T>::keep}));
        if (found.error != 0) return int64_t{found.error};
        write(moving.first, out);
        *gap = moving.gap;
        *answer = moving.answer;
        return found.item;
      });
}

}  // namespace

#define VESICA_MOTION(scalar, T)                                                                                      \
  int32_t vesica_cast_##scalar(int32_t kind_a, const void* a, int32_t kind_b, const void* b, T vx, T vy, T t_end,     \
                               vesica_impact_##scalar* out) {                                                         \
    return cast(kind_a, a, kind_b, b, vx, vy, t_end, out);                                                            \
  }                                                                                                                   \
  int64_t vesica_cast_many_##scalar(const vesica_shapes_##scalar* a, const vesica_shapes_##scalar* b, const T* vx,    \
                                    const T* vy, ptrdiff_t stride, T t_end, T* t, T* x, T* y, T* nx, T* ny) {         \
    return many_columns<T>(a, b, vx, vy, stride, t_end, t, x, y, nx, ny);                                             \
  }                                                                                                                   \
  int64_t vesica_cast_first_##scalar(const vesica_shapes_##scalar* one, const vesica_shapes_##scalar* many, T vx,     \
                                     T vy, T t_end, vesica_impact_##scalar* out) {                                    \
    return first<T>(many, one, vx, vy, t_end, out);                                                                   \
  }                                                                                                                   \
  int32_t vesica_impact_time_##scalar(int32_t kind_a, const void* a, const vesica_turn_##scalar* turn_a,              \
                                      int32_t kind_b, const void* b, const vesica_turn_##scalar* turn_b, T tolerance, \
                                      vesica_impact_##scalar* out, T* gap) {                                          \
    return impact_time(kind_a, a, turn_a, kind_b, b, turn_b, tolerance, out, gap);                                    \
  }                                                                                                                   \
  int32_t vesica_sweep_bounds_##scalar(int32_t kind, const void* shape, T vx, T vy, T t_end,                          \
                                       vesica_aabb_##scalar* out) {                                                   \
    return sweep_bounds(kind, shape, vx, vy, t_end, out);                                                             \
  }                                                                                                                   \
  int64_t vesica_index_cast_##scalar(const void* index, const vesica_shapes_##scalar* sets, int32_t set_count,        \
                                     const vesica_shapes_##scalar* one, T vx, T vy, T t_end, int64_t* out,            \
                                     int64_t capacity, int64_t* state) {                                              \
    return index_all<T>(index, sets, set_count, one, vx, vy, t_end, out, capacity, state);                            \
  }                                                                                                                   \
  int64_t vesica_index_cast_first_##scalar(const void* index, const vesica_shapes_##scalar* sets, int32_t set_count,  \
                                           const vesica_shapes_##scalar* one, T vx, T vy, T t_end,                    \
                                           vesica_impact_##scalar* out) {                                             \
    return index_first<T>(index, sets, set_count, one, vx, vy, t_end, out);                                           \
  }                                                                                                                   \
  int64_t vesica_index_impact_time_##scalar(const void* index, const vesica_shapes_##scalar* sets, int32_t set_count, \
                                            const vesica_shapes_##scalar* one, const vesica_turn_##scalar* turn,      \
                                            T tolerance, vesica_impact_##scalar* out, T* gap, int32_t* answer) {      \
    return index_impact_time<T>(index, sets, set_count, one, turn, tolerance, out, gap, answer);                      \
  }

VESICA_MOTION(f64, double)
VESICA_MOTION(f32, float)

#define VESICA_CAST_OF(a, A, b, B, scalar, T)                                                                          \
  int32_t vesica_cast_##a##_##b##_##scalar(const vesica_##a##_##scalar* s, const vesica_##b##_##scalar* t, T vx, T vy, \
                                           T t_end, vesica_impact_##scalar* out) {                                     \
    return cast_typed<vesica::A<T>, vesica::B<T>>(s, t, vx, vy, t_end, out);                                           \
  }
#define VESICA_CAST(a, A, b, B) VESICA_CAST_OF(a, A, b, B, f64, double) VESICA_CAST_OF(a, A, b, B, f32, float)

VESICA_CAST(point, Point, point, Point)
VESICA_CAST(segment, Segment, point, Point)
VESICA_CAST(circle, Circle, point, Point)
VESICA_CAST(aabb, Aabb, point, Point)
VESICA_CAST(rect, Rect, point, Point)
VESICA_CAST(ellipse, Ellipse, point, Point)
VESICA_CAST(circle, Circle, circle, Circle)
VESICA_CAST(rect, Rect, rect, Rect)
