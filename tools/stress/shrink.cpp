// SPDX-License-Identifier: Apache-2.0
#include "stress/shrink.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

#include "properties/shape_maker.hpp"

namespace stress {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto most_time = std::chrono::seconds(4);

/// How long a number is to read: its digits count most, then its exponent.
int cost(double x) {
  if (x == 0) return std::signbit(x) ? 1 : 0;
  if (!std::isfinite(x)) return 1;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%a", x);
  const std::string number(text.data());
  const auto point = number.find('.'), power = number.find('p');
  const int digits = point == std::string::npos ? 0 : static_cast<int>(power - point - 1);
  const int exponent = std::ilogb(x);
  return 2 + 4 * digits + (x < 0) + (exponent == 0 ? 0 : 1 + static_cast<int>(std::log2(std::abs(exponent) + 1)));
}

int cost(const Pair& p, const Motion& m) {
  int sum = cost(m.vx) + cost(m.vy) + cost(m.end);
  for (int i = 0; i < properties::field_count(p.kind_a); ++i) sum += cost(p.a[static_cast<std::size_t>(i)]);
  for (int i = 0; i < properties::field_count(p.kind_b); ++i) sum += cost(p.b[static_cast<std::size_t>(i)]);
  return sum;
}

/// x with its mantissa cut to `bits` bits after the first.
double cut(double x, int bits) {
  int exponent;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(std::trunc(std::ldexp(fraction, bits + 1)), exponent - bits - 1);
}

/// Simpler numbers, the simplest first.
std::vector<double> simpler(double x) {
  std::vector<double> result{0, 1, -1, -x};
  if (!std::isfinite(x) || x == 0) return result;
  const int exponent = std::ilogb(x);
  for (const int other : {0, exponent / 2, exponent - exponent / 8, exponent - (exponent > 0 ? 1 : -1)}) {
    result.push_back(std::ldexp(x, other - exponent));
  }
  for (const int bits : {0, 1, 2, 3, 4, 6, 8, 12, 16, 20, 24, 28, 32, 36, 40, 44, 48, 50, 51}) {
    result.push_back(cut(x, bits));
    result.push_back(cut(x, bits) + std::copysign(std::ldexp(1, exponent - bits), x));
  }
  return result;
}

class Shrinking {
 public:
  Shrinking(const Case& c, const std::function<bool(const Case&)>& fails)
      : best_(c), cost_(cost(c.pair, c.motion)), fails_(fails), end_(Clock::now() + most_time) {}

  Case run() {
    while (step() && Clock::now() < end_) {
    }
    return best_;
  }

 private:
  bool try_pair(const Pair& p) {
    Case c = best_;
    c.pair = p;
    return try_case(c);
  }

  bool try_case(const Case& c) {
    const Pair& p = c.pair;
    const int price = cost(p, c.motion);
    if (price >= cost_ || Clock::now() >= end_) return false;
    for (const Numbers* n : {&p.a, &p.b}) {
      for (const double x : *n) {
        if (std::isfinite(x) && !properties::representable(best_.scalar, x)) return false;
      }
    }
    for (const double x : {c.motion.vx, c.motion.vy, c.motion.end}) {
      if (std::isfinite(x) && !properties::representable(best_.scalar, x)) return false;
    }
    if (!fails_(c)) return false;
    best_ = c;
    cost_ = price;
    return true;
  }

  bool try_numbers(bool of_b) {
    bool any = false;
    const int kind = of_b ? best_.pair.kind_b : best_.pair.kind_a;
    for (int i = 0; i < properties::field_count(kind); ++i) {
      const auto k = static_cast<std::size_t>(i);
      for (const double x : simpler((of_b ? best_.pair.b : best_.pair.a)[k])) {
        Pair p = best_.pair;
        (of_b ? p.b : p.a)[k] = x;
        if (try_pair(p)) {
          any = true;
          break;
        }
      }
    }
    return any;
  }

  bool try_motion() {
    bool any = false;
    for (double Motion::*const part : {&Motion::vx, &Motion::vy, &Motion::end}) {
      for (const double x : simpler(best_.motion.*part)) {
        Case c = best_;
        c.motion.*part = x;
        if (!std::isfinite(x) || (part == &Motion::end && std::signbit(x)) || !try_case(c)) continue;
        any = true;
        break;
      }
    }
    return any;
  }

  bool try_together() {
    const Pair& p = best_.pair;
    bool any = false;
    for (const properties::Vector by : {properties::Vector{-p.a[0], -p.a[1]}, {-p.a[0], 0}, {0, -p.a[1]}}) {
      const Pair moved{p.kind_a, p.kind_b, properties::moved(p.kind_a, p.a, by), properties::moved(p.kind_b, p.b, by)};
      any = any || try_pair(moved);
    }
    for (const double x : {p.a[0], p.a[1], p.a[2], p.b[0], p.b[2], p.b[4]}) {
      if (x == 0 || !std::isfinite(x) || any) continue;
      const int by = -std::ilogb(x);
      any = try_pair({p.kind_a, p.kind_b, properties::scaled(p.kind_a, p.a, by, false),
                      properties::scaled(p.kind_b, p.b, by, false)});
    }
    return any;
  }

  bool step() {
    const bool together = try_together(), a = try_numbers(false);
    const bool b = !of_one_shape(best_.query) && try_numbers(true);
    const bool motion = of_motion(best_.query) && try_motion();
    return together || a || b || motion;
  }

  Case best_;
  int cost_;
  const std::function<bool(const Case&)>& fails_;
  Clock::time_point end_;
};

}  // namespace

Case shrunk(const Case& c, const std::function<bool(const Case&)>& fails) { return Shrinking(c, fails).run(); }

}  // namespace stress
