// SPDX-License-Identifier: Apache-2.0
/// Known contacts: pairs of shapes whose answer follows from how they were made, so that no oracle is needed.
///
/// A test states one pair of literals and the numbers that part it. Every such family is asked
///  - at lengths times 2^-1060 ... 2^1000 (float: 2^-140 ... 2^120) and axes times 2^k with their sizes divided,
///    wherever all numbers stay exactly representable; also moved far from the origin,
///  - one representable number to either side of each number named,
///  - mirrored in x and y, turned by a quarter, and with the same shapes written differently,
///  - through the typed function and by kind in both orders, in double and float.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <initializer_list>

#include "capi/typed.hpp"

namespace contact {

// Places of the numbers in a shape, as the C structs name them.
namespace point {
enum Field { x, y };
}
namespace segment {
enum Field { x0, y0, x1, y1 };
}
namespace circle {
enum Field { cx, cy, r };
}
namespace aabb {
enum Field { min_x, min_y, max_x, max_y };
}
namespace rect {
enum Field { cx, cy, ux, uy, hx, hy };
}
namespace ellipse {
enum Field { cx, cy, ux, uy, a, b };
}
namespace capsule {
enum Field { x0, y0, x1, y1, r };
}
namespace round_rect {
enum Field { cx, cy, ux, uy, hx, hy, r };
}

enum Side { first, second };

/// One number of one of the two shapes, and a direction for it: to the next representable number up or down.
struct Nudge {
  Side side;
  int field;
  bool up;
};
constexpr Nudge up(Side side, int field) { return {side, field, true}; }
constexpr Nudge down(Side side, int field) { return {side, field, false}; }

/// A shape as flat numbers; those beyond its kind's count are 0.
template <class T>
struct Shape {
  std::int32_t kind;
  std::array<T, 7> number;
};

/// The typed functions of one pair of kinds; null for kinds that have none.
struct Functions {
  std::int32_t (*f64)(const double*, const double*);
  std::int32_t (*f32)(const float*, const float*);
};

/// The answers a family expects: as stated, after a nudge, and after the opposite nudge.
struct Answers {
  std::int32_t stated, nudged, opposite;
};

/// Checks one family as the head of this file says. The literals themselves must be among the cases asked.
void expect(const Functions& functions, const Shape<double>& a, const Shape<double>& b,
            std::initializer_list<Nudge> nudges, const Answers& answers);

struct NoTypedFunctions {
  static constexpr Functions functions() { return {nullptr, nullptr}; }
};
template <auto overlap_f64, auto overlap_f32>
struct TypedFunctions {
  static constexpr Functions functions() { return {capi::Typed<overlap_f64>::call, capi::Typed<overlap_f32>::call}; }
};

/// The families of one pair of kinds, named by their structs of double.
template <class A, class B, class Typed = NoTypedFunctions>
struct PairOfKinds {
  /// Contact from outside: they overlap; each nudge parts them, its opposite does not.
  static void touch(const A& a, const B& b, std::initializer_list<Nudge> outward) { check(a, b, outward, {1, 0, 1}); }
  /// Contact with no room: they overlap; each number named parts them when nudged either way.
  static void pinned(const A& a, const B& b, std::initializer_list<Nudge> nudges) { check(a, b, nudges, {1, 0, 0}); }
  /// They overlap, nudged or not.
  static void meet(const A& a, const B& b, std::initializer_list<Nudge> nudges) { check(a, b, nudges, {1, 1, 1}); }
  /// They are disjoint, nudged or not.
  static void miss(const A& a, const B& b, std::initializer_list<Nudge> nudges) { check(a, b, nudges, {0, 0, 0}); }

 private:
  template <class Struct>
  static Shape<double> flat(const Struct& s) {
    Shape<double> result{capi::KindOf<Struct>::kind, {}};
    std::memcpy(result.number.data(), &s, sizeof s);
    return result;
  }

  static void check(const A& a, const B& b, std::initializer_list<Nudge> nudges, const Answers& answers) {
    expect(Typed::functions(), flat(a), flat(b), nudges, answers);
  }
};

/// The same from the pair's two typed functions.
template <auto overlap_f64, auto overlap_f32>
using Pair = PairOfKinds<typename capi::Typed<overlap_f64>::A, typename capi::Typed<overlap_f64>::B,
                         TypedFunctions<overlap_f64, overlap_f32>>;

}  // namespace contact
