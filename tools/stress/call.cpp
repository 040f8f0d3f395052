// SPDX-License-Identifier: Apache-2.0
#include "stress/call.hpp"

#include <bit>
#include <cmath>
#include <cstdio>
#include <cstring>

#include "capi/face.hpp"
#include "properties/exact_changes.hpp"
#include "stress/deliberate.hpp"

namespace stress {
namespace {

using capi_tests::Face;

/// An output that shows whether it was written to.
template <class Out>
struct Marked {
  static constexpr int mark = 0xA5;
  Out out;
  Marked() { std::memset(&out, mark, sizeof out); }
  bool wrote() const {
    Marked fresh;
    return std::memcmp(&out, &fresh.out, sizeof out) != 0;
  }
};

/// A struct of numbers, or one number.
template <class T, class Out>
void read_numbers(const Out& out, Answer& answer) {
  constexpr std::size_t count = sizeof(Out) / sizeof(T);
  std::array<T, count> numbers;
  std::memcpy(numbers.data(), &out, sizeof out);
  for (std::size_t i = 0; i < count; ++i) answer.numbers[i] = static_cast<double>(numbers[i]);
}

template <class Out>
void read_crossings(const Out& out, Answer& answer) {
  answer.numbers[0] = out.shared;
  for (std::size_t i = 0; i < 12; ++i) {
    answer.numbers[1 + i] = static_cast<double>(out.x[i]);
    answer.numbers[13 + i] = static_cast<double>(out.y[i]);
  }
}

/// Characters in place of a struct of numbers.
struct Matrix {
  std::array<char, VESICA_DE9IM_SIZE> characters;
};
void read_matrix(const Matrix& out, Answer& answer) {
  for (std::size_t i = 0; i + 1 < out.characters.size(); ++i) {
    answer.numbers[i] = out.characters[i] == 'F' ? -1 : out.characters[i] - '0';
  }
}

/// One call. A and B: the numbers.
template <class T>
struct Caller {
  int kind_a, kind_b;
  const T *a, *b;
  const Motion& motion;
  double distance;
  const Environment& environment;

  /// To T, in the default environment: the compiler may not move it into another one, which would flush subnormals.
  static T rounded(double x) {
    const volatile T to_t = static_cast<T>(x);
    return to_t;
  }

  Answer code(std::int32_t (*function)(std::int32_t, const void*, std::int32_t, const void*)) const {
    Answer answer;
    answer.code = run_in(environment, answer.environment_changed, [&] { return function(kind_a, a, kind_b, b); });
    return answer;
  }

  template <class Out>
  Answer numbers(std::int32_t (*function)(std::int32_t, const void*, std::int32_t, const void*, Out*)) const {
    Marked<Out> marked;
    return finish(marked, [&] { return function(kind_a, a, kind_b, b, &marked.out); });
  }

  template <class Out>
  Answer of_first(std::int32_t (*function)(std::int32_t, const void*, Out*)) const {
    Marked<Out> marked;
    return finish(marked, [&] { return function(kind_a, a, &marked.out); });
  }

  Answer ratios() const {
    Answer all;
    for (std::size_t i = 0; i < ratio_count; ++i) {
      const auto which = static_cast<std::int32_t>(i);
      Marked<T> marked;
      const Answer one = finish(marked, [&] { return Face<T>::ratio(which, kind_a, a, kind_b, b, &marked.out); });
      if (which == 0) all.code = one.code;
      all.wrote = all.wrote || one.wrote;
      all.environment_changed = all.environment_changed || one.environment_changed;
      all.numbers[i] = one.numbers[0];
      all.numbers[ratio_count + i] = one.code;
    }
    return all;
  }

  Answer cast() const {
    Marked<typename Face<T>::Impact> marked;
    const T vx = rounded(motion.vx), vy = rounded(motion.vy), end = rounded(motion.end);
    return finish(marked, [&] { return Face<T>::cast(kind_a, a, kind_b, b, vx, vy, end, &marked.out); });
  }
  Answer sweep_bounds() const {
    Marked<typename Face<T>::Aabb> marked;
    const T vx = rounded(motion.vx), vy = rounded(motion.vy), end = rounded(motion.end);
    return finish(marked, [&] { return Face<T>::sweep_bounds(kind_a, a, vx, vy, end, &marked.out); });
  }

  Answer within() const {
    Answer answer;
    const T limit = rounded(distance);
    const auto call = [&] { return Face<T>::within(kind_a, a, kind_b, b, limit); };
    answer.code = run_in(environment, answer.environment_changed, call);
    return answer;
  }
  Answer de9im() const {
    Marked<Matrix> marked;
    return finish(marked, [&] { return Face<T>::de9im(kind_a, a, kind_b, b, marked.out.characters.data()); });
  }
  Answer intersection() const {
    Marked<std::array<T, 16>> marked;
    return finish(marked, [&] { return Face<T>::intersection(kind_a, a, kind_b, b, marked.out.data()); });
  }

  template <class Out, class Call>
  Answer finish(const Marked<Out>& marked, Call call) const {
    Answer answer;
    answer.code = run_in(environment, answer.environment_changed, call);
    answer.wrote = marked.wrote();
    if (answer.code < 0) return answer;
    if constexpr (std::is_same_v<Out, typename Face<T>::Crossings>) {
      read_crossings(marked.out, answer);
    } else if constexpr (std::is_same_v<Out, Matrix>) {
      read_matrix(marked.out, answer);
    } else {
      read_numbers<T>(marked.out, answer);
    }
    return answer;
  }
};

template <class T>
Answer call(Query query, const Caller<T>& caller) {
  using F = Face<T>;
  switch (query) {
    case Query::overlap:
      return caller.code(F::overlap);
    case Query::relation:
      return caller.code(F::relation);
    case Query::contains:
      return caller.code(F::contains);
    case Query::nearest:
      return caller.numbers(F::nearest);
    case Query::boundary_distance:
      return caller.numbers(F::boundary_distance);
    case Query::depth:
      return caller.numbers(F::depth);
    case Query::area:
      return caller.numbers(F::area);
    case Query::iou:
      return caller.numbers(F::iou);
    case Query::crossings:
      return caller.numbers(F::crossings);
    case Query::shape_area:
      return caller.of_first(F::shape_area);
    case Query::bounds:
      return caller.of_first(F::bounds);
    case Query::ratio:
      return caller.ratios();
    case Query::cast:
      return caller.cast();
    case Query::within:
      return caller.within();
    case Query::signed_distance:
      return caller.numbers(F::signed_distance);
    case Query::de9im:
      return caller.de9im();
    case Query::intersection:
      return caller.intersection();
    default:
      return caller.sweep_bounds();
  }
}

}  // namespace

properties::NumbersOf<float> as_floats(const Numbers& numbers) {
  properties::NumbersOf<float> result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    const volatile float stored = static_cast<float>(numbers[i]);
    result[i] = stored;
  }
  return result;
}

Answer ask(const Case& c, const Environment& environment) {
  const Pair& p = c.pair;
  Answer answer;
  if (c.scalar == Scalar::f64) {
    answer =
        call(c.query, Caller<double>{p.kind_a, p.kind_b, p.a.data(), p.b.data(), c.motion, c.distance, environment});
  } else {
    const auto a = as_floats(p.a), b = as_floats(p.b);
    answer = call(c.query, Caller<float>{p.kind_a, p.kind_b, a.data(), b.data(), c.motion, c.distance, environment});
  }
  if (deliberate_fault() != nullptr) deliberate_fault()(c.query, c.scalar, p, environment, answer);
  return answer;
}

Answer ask(Query query, Scalar scalar, const Pair& p, const Environment& environment) {
  return ask(Case{query, scalar, p}, environment);
}

double draw_distance(Scalar scalar, const Pair& pair, properties::Random& random) {
  const Answer nearest = ask(Query::nearest, scalar, pair);
  double d = nearest.code == 0 && nearest.numbers[0] > 0 ? nearest.numbers[0] : std::fabs(pair.a[0]) * random.unit();
  d = properties::nearest(scalar, d);
  const std::int64_t away = random.chance(0.5) ? random.integer(-3, 3) : std::int64_t{1} << random.integer(0, 20);
  d = properties::at_ordinal(scalar, properties::ordinal(scalar, d) + away);
  return random.chance(0.05) || !(d > 0 && std::isfinite(d)) ? 0 : d;
}

std::int32_t check(Scalar scalar, int kind, const Numbers& numbers) {
  if (scalar == Scalar::f64) return vesica_check_f64(kind, numbers.data());
  return vesica_check_f32(kind, as_floats(numbers).data());
}

bool same_bits(const Answer& a, const Answer& b) {
  return a.code == b.code && std::memcmp(a.numbers.data(), b.numbers.data(), sizeof a.numbers) == 0;
}

std::string text(const Answer& answer) {
  std::string result = std::to_string(answer.code);
  std::size_t count = most_numbers;
  while (count > 0 && std::bit_cast<std::uint64_t>(answer.numbers[count - 1]) == 0) --count;
  for (std::size_t i = 0; i < count; ++i) {
    std::array<char, 40> number{};
    std::snprintf(number.data(), number.size(), " %a", answer.numbers[i]);
    result += number.data();
  }
  return result;
}

}  // namespace stress
