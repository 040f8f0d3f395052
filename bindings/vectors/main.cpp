// SPDX-License-Identifier: Apache-2.0
// Writes the file of vectors that every host is run on; its head, below, says how to read it. Answers are the exact
// oracle's (tests/oracle), never the library's. Known ones are written here too, and must agree with it.
#include <vesica.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <vector>

#include "oracle/oracle.hpp"

namespace {

constexpr const char* head =
    "# SPDX-License-Identifier: Apache-2.0\n"
    "# What every host must answer. Written by bindings_vectors; a test keeps it so.\n"
    "#\n"
    "# A line has 16 words: what  expected  kind_a a0 .. a5  kind_b b0 .. b5\n"
    "#   what      f64 or f32: a scalar call in that type; many: an element of the one batch, in double\n"
    "#   expected  1, 0, or the error code; the batch has to answer 0 for an element with an error\n"
    "#   a0 .. b5  the bits of a double in hexadecimal, big end first; a float where what is f32. Unused: 0\n";

using Numbers = std::array<double, 6>;

struct Shape {
  int kind;
  Numbers numbers;
};

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double least = 0x1p-1074, least_float = 0x1p-149;

// Shapes about (10.25, -3.5), which is a point of each; a pair is made of one of the first and one of the second.
constexpr double x = 10.25, y = -3.5;
constexpr std::array<Shape, 6> first{{{VESICA_POINT, {x, y}},
                                      {VESICA_SEGMENT, {x - 1.5, y - 0.75, x + 1.5, y + 0.75}},
                                      {VESICA_CIRCLE, {x, y, 1.3}},
                                      {VESICA_AABB, {x - 1.75, y - 0.5, x + 1.75, y + 0.625}},
                                      {VESICA_RECT, {x, y, 0.8, 0.6, 2.1, 1.1}},
                                      {VESICA_ELLIPSE, {x, y, -0.6, 0.8, 1.7, 0.4}}}};
constexpr std::array<Shape, 6> second{{{VESICA_POINT, {x, y}},
                                       {VESICA_SEGMENT, {x - 0.5, y + 1.25, x + 0.5, y - 1.25}},
                                       {VESICA_CIRCLE, {x, y, 0.7}},
                                       {VESICA_AABB, {x - 0.375, y - 1.5, x + 0.25, y + 0.125}},
                                       {VESICA_RECT, {x, y, 0.28, 0.96, 0.9, 0.35}},
                                       {VESICA_ELLIPSE, {x, y, 0.96, 0.28, 2.2, 0.7}}}};

void print(const Shape& shape) {
  std::printf(" %d", shape.kind);
  for (const double number : shape.numbers) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof bits);
    std::printf(" %016llx", static_cast<unsigned long long>(bits));
  }
}

void line(const char* what, int expected, const Shape& a, const Shape& b) {
  std::printf("%s %d", what, expected);
  print(a);
  print(b);
  std::printf("\n");
}

bool overlap(const Shape& a, const Shape& b) {
  return oracle::overlap(a.kind, a.numbers.data(), b.kind, b.numbers.data());
}

/// A line for two valid shapes, in either order.
void answer(const char* what, const Shape& a, const Shape& b) { line(what, overlap(a, b), a, b); }

/// A line whose answer is known without the oracle.
void known(const char* what, int expected, const Shape& a, const Shape& b) {
  if (overlap(a, b) != (expected == 1)) {
    std::fprintf(stderr, "the oracle is wrong, or a known answer is\n");
    std::exit(1);
  }
  line(what, expected, a, b);
}

/// To the nearest T. Volatile, because g++ 12 at -O2 makes one vector of two neighbours' conversions to float and back,
/// and then leaves both out.
template <class T>
void round_to(double& number) {
  const volatile T rounded = static_cast<T>(number);
  number = static_cast<double>(rounded);
}

template <class T>
Shape rounded(Shape shape) {
  for (double& number : shape.numbers) round_to<T>(number);
  return shape;
}

/// The shape moved along x by t: its numbers plus t, rounded once.
template <class T>
Shape moved(Shape shape, T t) {
  const auto move = [t](double& number) {
    number += static_cast<double>(t);
    round_to<T>(number);
  };
  move(shape.numbers[0]);
  if (shape.kind == VESICA_SEGMENT || shape.kind == VESICA_AABB) move(shape.numbers[2]);
  return shape;
}

/// The last b to overlap a on its way along x, and the first that does not: neighbouring numbers.
template <class T>
std::array<Shape, 2> contact(const Shape& a, const Shape& b) {
  T hit = 0, miss = 16;
  for (;;) {
    const T middle = hit + (miss - hit) / 2;
    if (middle == hit || middle == miss) return {moved(b, hit), moved(b, miss)};
    (overlap(a, moved(b, middle)) ? hit : miss) = middle;
  }
}

/// Every pair of kinds, in both orders: at contact, just beyond, far.
template <class T>
void pairs(const char* what) {
  for (const Shape& exact_a : first) {
    for (const Shape& exact_b : second) {
      const Shape a = rounded<T>(exact_a), b = rounded<T>(exact_b);
      if (a.kind > b.kind) continue;
      const auto [touching, apart] = contact<T>(a, b);
      answer(what, a, touching);
      answer(what, apart, a);
      known(what, 0, a, moved(b, T{100}));
    }
  }
}

void known_answers(const char* what, double smallest) {
  known(what, 1, {VESICA_RECT, {0, 0, 1, 0, 2, 1}}, {VESICA_ELLIPSE, {3, 1, 1, 0, 1, 0.5}});
  known(what, 0, {VESICA_RECT, {0, 0, 1, 0, 2, 1}}, {VESICA_ELLIPSE, {3.125, 1, 1, 0, 1, 0.5}});
  known(what, 1, {VESICA_CIRCLE, {0, 0, 2}}, {VESICA_CIRCLE, {3, 4, 3}});
  known(what, 0, {VESICA_CIRCLE, {3, 4.0625, 3}}, {VESICA_CIRCLE, {0, 0, 2}});
  // An axis is a unit of length: (0, 2) and half extent 1 reach 2 upwards.
  known(what, 1, {VESICA_RECT, {0, 0, 0, 2, 1, 0}}, {VESICA_POINT, {0, 2}});
  known(what, 0, {VESICA_POINT, {0, 2.25}}, {VESICA_RECT, {0, 0, 0, 2, 1, 0}});
  // Zero sizes; the smallest numbers.
  known(what, 1, {VESICA_ELLIPSE, {1, 1, 1, 0, 0, 0}}, {VESICA_SEGMENT, {1, 1, 1, 1}});
  known(what, 1, {VESICA_CIRCLE, {0, 0, smallest}}, {VESICA_CIRCLE, {smallest * 2, 0, smallest}});
  known(what, 0, {VESICA_RECT, {0, 0, 1, 0, 0, 3}}, {VESICA_POINT, {smallest, 0}});
  known(what, 1, {VESICA_AABB, {-0x1p120, -0x1p120, 0x1p120, 0x1p120}}, {VESICA_CIRCLE, {0x1p121, 0, 0x1p120}});
}

void errors(const char* what) {
  const Shape point{VESICA_POINT, {0, 0}};
  line(what, VESICA_E_SHAPE, {VESICA_POINT, {nan, 0}}, point);
  line(what, VESICA_E_SHAPE, point, {VESICA_SEGMENT, {0, 0, 0, infinity}});
  line(what, VESICA_E_SHAPE, {VESICA_CIRCLE, {0, 0, -1}}, point);
  line(what, VESICA_E_SHAPE, point, {VESICA_AABB, {1, 0, -1, 0}});
  line(what, VESICA_E_SHAPE, {VESICA_RECT, {0, 0, 0, 0, 1, 1}}, point);
  line(what, VESICA_E_SHAPE, point, {VESICA_ELLIPSE, {0, 0, 1, 0, 1, -infinity}});
  line(what, VESICA_E_KIND, {VESICA_POLYLINE + 1, {}}, point);
  line(what, VESICA_E_KIND, point, {-1, {}});
}

/// Rectangles against ellipses all around them, at contact and just beyond in turn. 35 valid ones: more than any
/// instruction set takes at once, and not a multiple of that.
void batch() {
  constexpr std::array<std::array<double, 2>, 7> axes{
      {{1, 0}, {0.6, 0.8}, {-0.28, 0.96}, {-0.8, 0.6}, {0, -1}, {0.5, -1.2}, {1.5, 0.8}}};
  int n = 0;
  for (const auto& u : axes) {
    for (int i = 0; i < 5; ++i, ++n) {
      const Shape rect{VESICA_RECT, {0.1 * i, -0.3 * n, u[0], u[1], 0.5 + 0.1 * i, 0.25 * i}};
      const Shape ellipse{VESICA_ELLIPSE, {rect.numbers[0], rect.numbers[1], 0.96, -0.28, 0.2 * (5 - i), 0.7}};
      answer("many", rect, contact<double>(rect, ellipse)[n % 2 == 0 ? 0 : 1]);
    }
    if (n == 15)
      line("many", VESICA_E_SHAPE, {VESICA_RECT, {nan, 0, 1, 0, 1, 1}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 1, 1}});
  }
  line("many", VESICA_E_SHAPE, {VESICA_RECT, {0, 0, 1, 0, 1, 1}}, {VESICA_ELLIPSE, {0, 0, 1, 0, 1, -1}});
}

}  // namespace

int main() {
  std::printf("%s", head);
  pairs<double>("f64");
  known_answers("f64", least);
  errors("f64");
  pairs<float>("f32");
  known_answers("f32", least_float);
  errors("f32");
  batch();
  return 0;
}
