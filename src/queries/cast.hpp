// SPDX-License-Identifier: Apache-2.0
// Shapes that move, by kind and flat numbers, and arrays of them. Not a Query, because a Query's functions have no
// parameter for the motion.
#pragma once

#include <vesica/cast.hpp>
#include <vesica/impact_time/scene.hpp>

#include "batch.hpp"
#include "polygon/answers.hpp"

namespace vesica::queries {

using detail::cast::Body;
using detail::cast::Motion;

/// The answer for bodies that need not be valid, or error_shape or error_range. After a miss nothing is written. Never
/// inlined: it exists once for all kinds.
std::int32_t cast(const Body& a, const Body& b, const Motion& motion, Impact<double>& out) noexcept;

/// Rounded to T: the time down, all other numbers to the nearest.
template <class T>
std::int32_t cast(const Body& a, const Body& b, const Motion& motion, Impact<T>& out) noexcept;

/// The same for pairs that early outs leave open: begins with the filter for all kinds.
std::int32_t cast_open(const Body& a, const Body& b, const Motion& motion, Impact<double>& out) noexcept;

/// The same for pairs that this filter does not decide.
std::int32_t cast_rest(const Body& a, const Body& b, const Motion& motion, const detail::cast::Filtered& known,
                       Impact<double>& out) noexcept;

/// Is there contact by the end? No more than that: 1 or 0, error_shape, or error_range where that is beyond exact
/// numbers.
std::int32_t meets(const Body& a, const Body& b, const Motion& motion) noexcept;

/// detail::cast::fast_hit with the faster products. Not inlined beside the early out: its registers would double the
/// time of a miss.
template <class A, class B>
detail::cast::EarlyOut fast_hit(const A& a, const B& b, double vx, double vy, double end, Impact<double>& out) noexcept;

/// The answer about two shapes for which the early out returned `early`, or error_argument.
template <template <class> class A, template <class> class B>
VESICA_INLINE std::int32_t cast_shapes(const A<double>& a, const B<double>& b, const Motion& motion,
                                       Impact<double>& out, detail::cast::EarlyOut early) noexcept {
  using namespace detail::cast;
  if (early == EarlyOut::missed) return cast_miss;
  if (early == EarlyOut::hit) early = queries::fast_hit(a, b, motion.vx, motion.vy, motion.end, out);
  if (early != EarlyOut::open) return early == EarlyOut::hit ? cast_hit : cast_miss;
  if (!is_sound(motion)) return error_argument;
  return cast_open(body(a), body(b), motion, out);
}

/// The answer about two shapes, or error_argument. Their first filter is compiled where it is called, and nothing else.
template <template <class> class A, template <class> class B>
VESICA_INLINE std::int32_t cast_shapes(const A<double>& a, const B<double>& b, const Motion& motion,
                                       Impact<double>& out) noexcept {
  using namespace detail::cast;
  if constexpr (HasEarlyOut<A<double>, B<double>>) {
    return cast_shapes(a, b, motion, out, early_out(a, b, motion));
  } else {
    if (!is_sound(motion)) return error_argument;
    const Filtered known = detail::cast::filter(sketch(a), sketch(b), motion);
    if (known.verdict == Verdict::missed) return cast_miss;
    return cast_rest(body(a), body(b), motion, known, out);
  }
}

/// For bodies that turn; otherwise the same. The gap is rounded up.
template <class T>
std::int32_t impact_time(const Body& a, const Turn<double>& turn_a, const Body& b, const Turn<double>& turn_b,
                         double tolerance, Impact<T>& out, T& gap) noexcept;

}  // namespace vesica::queries

namespace vesica::polygon {

/// The same for operands of which one is a path. The motion is sound.
std::int32_t cast(const Operand& a, const Operand& b, const detail::cast::Motion& motion, Impact<double>& out) noexcept;

/// The same as queries::meets().
std::int32_t meets(const Operand& a, const Operand& b, const detail::cast::Motion& motion) noexcept;

/// The same as queries::impact_time().
template <class T>
std::int32_t impact_time(const Operand& a, const Turn<double>& turn_a, const Operand& b, const Turn<double>& turn_b,
                         double tolerance, Impact<T>& out, T& gap) noexcept;

bool is_valid(const Operand& s) noexcept;

/// Rounded to T, as above.
template <class T>
std::int32_t cast(const Operand& a, const Operand& b, const detail::cast::Motion& motion, Impact<T>& out) noexcept {
  Impact<double> found;
  const std::int32_t code = cast(a, b, motion, found);
  if (code <= 0) return code;
  return detail::cast::rounded_to(found, out) ? code : error_range;
}

}  // namespace vesica::polygon

namespace vesica::batch {

/// Velocities of elements, as columns; those of a single one have stride 0.
template <class T>
struct Velocities {
  Unaligned<T> vx, vy;
  std::ptrdiff_t stride;
};

struct CastTally {
  std::int64_t hits = 0;   // those that overlap at the start included
  std::int32_t error = 0;  // error_shape if any shape was invalid, else that of a pair or of a velocity
};

/// columns[k][i] = number k of the impact of b[i], which moves, on a[i], i < n; a column may be null.
template <class T>
CastTally cast_many(const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, const Velocities<T>& v, double end,
                    T* const (&columns)[5]) noexcept;

struct FirstHit {
  std::int64_t index;  // the count of `many` where there is none
  std::int32_t error;
};

/// The shape of `many` that one moving shape hits first; of several at one time the first.
template <class T>
FirstHit cast_first(const Shapes<T>& many, const Shapes<T>& one, const detail::cast::Motion& motion,
                    Impact<T>& out) noexcept;

/// Element i as a body.
template <class T>
detail::cast::Body body_at(const Shapes<T>& shapes, std::int64_t i) noexcept;

}  // namespace vesica::batch
