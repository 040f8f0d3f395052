// SPDX-License-Identifier: Apache-2.0
// Constants and calls at run time have the same bits: square roots, bounds and constructors. At run time the
// numbers are read from volatile memory, so that no compiler knows them.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <type_traits>
#include <vesica/bounds.hpp>
#include <vesica/construct.hpp>

namespace {

using namespace vesica;

int faults = 0;

template <class T>
using Bits = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;

template <class T>
bool same(T a, T b) {
  return std::bit_cast<Bits<T>>(a) == std::bit_cast<Bits<T>>(b) || (a != a && b != b);
}

void expect(bool holds, const char* what, double x) {
  if (holds) return;
  if (++faults <= 20) std::printf("%s of %a is another at run time\n", what, x);
}

template <class T>
T unknown(T x) {
  volatile T there = x;
  return there;
}

/// splitmix64
struct Draws {
  std::uint64_t state;
  constexpr std::uint64_t next() {
    std::uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
  }
  /// A number from 2^-e to 2^e, of either sign or not negative.
  constexpr double number(int e, bool is_signed) {
    const std::uint64_t r = next(),
                        exponent = 1023 - static_cast<std::uint64_t>(e) + next() % (2u * static_cast<unsigned>(e) + 1);
    return std::bit_cast<double>((is_signed ? r & 0x8000000000000000u : 0) | exponent << 52 | r >> 12);
  }
};

/// Roots.

constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();

template <class T>
void expect_root(T x) {
  expect(same(detail::square_root(x), std::sqrt(unknown(x))), "the root", static_cast<double>(x));
}

template <class T>
void expect_roots_about(T x) {
  expect_root(x);
  expect_root(std::nextafter(x, T(0)));
  expect_root(std::nextafter(x, std::numeric_limits<T>::infinity()));
}

template <class T>
void expect_roots() {
  using Limits = std::numeric_limits<T>;
  for (const T x : {T(0), -T(0), T(-1), -Limits::denorm_min(), Limits::infinity(), Limits::quiet_NaN()}) expect_root(x);
  expect_roots_about(Limits::max());
  for (T x = Limits::denorm_min(); x <= Limits::max() / 2; x *= 2) expect_roots_about(x);
  Draws draws{1};
  for (int i = 0; i < 200'000; ++i) {
    const auto bits = static_cast<Bits<T>>(draws.next());
    expect_root(std::bit_cast<T>(bits));
    expect_root(std::bit_cast<T>(static_cast<Bits<T>>(bits >> (bits % (8 * sizeof(T))))));  // also the subnormal ones
    // Beside the squares of numbers with half the digits and one more: next to a tie, or exact.
    const T root = static_cast<T>((bits >> (sizeof(T) == 8 ? 36 : 19)) | 1);
    expect_roots_about(root * root);
    expect_roots_about(root * (root + 1));
  }
}

constexpr std::array roots_of{
    0.0,     -0.0, 2.0,      0x1p-1074, 0x1.8p-1073,          0x1p-1022,          0x1.fffffffffffffp-1023, 0.1,
    largest, 1e-3, 0x1p1023, infinity,  0x1.fffffffffffffp-1, 0x1.0000000000001p0};
constexpr auto constant_roots = [] {
  auto all = roots_of;
  for (double& x : all) x = lane::sqrt(x);
  return all;
}();
static_assert(constant_roots[2] == 0x1.6a09e667f3bcdp0 && constant_roots[3] == 0x1p-537);

void expect_constant_roots() {
  for (std::size_t i = 0; i < roots_of.size(); ++i) {
    expect(same(constant_roots[i], std::sqrt(unknown(roots_of[i]))), "the constant root", roots_of[i]);
  }
}

/// Bounds and constructors, of every shape that six numbers make.

template <class T>
using Numbers = std::array<T, 6>;

template <class T>
struct Results {
  std::array<int, 8> codes;
  std::array<Aabb<T>, 7> boxes;
  Ellipse<T> ellipse;
};

template <class T>
constexpr Results<T> results(const Numbers<T>& n) {
  const T width = lane::abs(n[4]), height = lane::abs(n[5]);
  Results<T> r{};
  r.codes[0] = bounds(Point<T>{n[0], n[1]}, r.boxes[0]);
  r.codes[1] = bounds(Segment<T>{n[0], n[1], n[2], n[3]}, r.boxes[1]);
  r.codes[2] = bounds(Circle<T>{n[0], n[1], width}, r.boxes[2]);
  r.codes[3] = aabb_from_corners(n[0], n[1], n[2], n[3], r.boxes[3]);
  r.codes[4] = bounds(r.boxes[3], r.boxes[4]);
  r.codes[5] = bounds(Rect<T>{n[0], n[1], n[2], n[3], width, height}, r.boxes[5]);
  r.codes[6] = bounds(Ellipse<T>{n[0], n[1], n[2], n[3], width, height}, r.boxes[6]);
  r.codes[7] = ellipse_from_radius_vector(n[0], n[1], n[2], n[3], width, r.ellipse);
  return r;
}

template <class T>
bool same(const Aabb<T>& a, const Aabb<T>& b) {
  return same(a.min_x, b.min_x) && same(a.min_y, b.min_y) && same(a.max_x, b.max_x) && same(a.max_y, b.max_y);
}
template <class T>
bool same(const Ellipse<T>& a, const Ellipse<T>& b) {
  return same(a.cx, b.cx) && same(a.cy, b.cy) && same(a.ux, b.ux) && same(a.uy, b.uy) && same(a.a, b.a) &&
         same(a.b, b.b);
}

constexpr int drawn = 36;

template <class T>
constexpr auto inputs = [] {
  constexpr T most = std::numeric_limits<T>::max(), least = std::numeric_limits<T>::denorm_min(), none = T(0);
  std::array<Numbers<T>, drawn + 9> all{
      Numbers<T>{0, 0, 3, 4, 2, 1},
      {most, -most, most, 1, 1, least},
      {none, -none, none, -none, least, least},  // of unlike zeros C leaves the lesser open
      {most / 2, most / 4, least, 0, most, 1},
      {1, 1, 0, 0, 1, 1},                // an axis of length 0
      {most, most, 0.6f, 0.8f, 0, 0},    // a point
      {most, -most, 0.6f, 0.8f, 0, 1},   // beyond the finite numbers
      {0, 0, most / 2, most / 2, 1, 1},  // to the largest one, and beyond it
      {least, -least, least, most, least, most}};
  Draws draws{2};
  for (int i = 0; i < drawn; ++i) {
    const int e = i % 4 == 0 ? 2 : i % 4 == 1 ? 30 : sizeof(T) == 4 ? 100 : i % 4 == 2 ? 300 : 1000;
    for (T& x : all[static_cast<std::size_t>(9 + i)]) x = static_cast<T>(draws.number(e, true));
  }
  return all;
}();

template <class T>
constexpr auto constants = [] {
  std::array<Results<T>, inputs<T>.size()> all{};
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = results(inputs<T>[i]);
  return all;
}();

template <class T>
void expect_shapes() {
  int boxes = 0, errors = 0;
  for (std::size_t i = 0; i < inputs<T>.size(); ++i) {
    Numbers<T> numbers{};
    for (std::size_t k = 0; k < 6; ++k) numbers[k] = unknown(inputs<T>[i][k]);
    const Results<T> now = results(numbers), &then = constants<T>[i];
    const auto at = static_cast<double>(i);
    for (std::size_t k = 0; k < 8; ++k) {
      expect(now.codes[k] == then.codes[k], "the code of a set of numbers", at);
      ++(now.codes[k] == 0 ? boxes : errors);
    }
    for (std::size_t k = 0; k < 7; ++k) expect(same(now.boxes[k], then.boxes[k]), "a box of a set of numbers", at);
    expect(same(now.ellipse, then.ellipse), "the ellipse of a set of numbers", at);
  }
  expect(boxes >= 200 && errors >= 10, "the number of boxes", boxes);
}

}  // namespace

int main() {
  expect_roots<double>();
  expect_roots<float>();
  expect_constant_roots();
  expect_shapes<double>();
  expect_shapes<float>();
  return faults == 0 ? 0 : 1;
}
