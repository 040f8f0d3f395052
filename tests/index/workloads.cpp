// SPDX-License-Identifier: Apache-2.0
#include "index/workloads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace index_tests {

namespace {

struct Random {
  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  /// Uniform in its logarithm, from 1 / ratio to ratio.
  double scale(double ratio) { return std::pow(ratio, 2 * unit() - 1); }
};

struct Rect {
  double cx, cy, ux, uy, hx, hy;
};

Rect turned(Random& random, double x, double y, double scale) {
  const double turn = 6.283185307179586 * random.unit();
  return {
      x, y, std::cos(turn), std::sin(turn), scale * (0.2 + 0.4 * random.unit()), scale * (0.2 + 0.4 * random.unit())};
}

/// The side of a square in which n shapes of about unit size have about one partner each.
double side_for(std::int64_t n) { return 1.5 * std::sqrt(static_cast<double>(n)); }

using Draw = Rect (*)(Random&, std::int64_t i, std::int64_t n, double side);

Rect uniform(Random& r, std::int64_t, std::int64_t, double side) {
  return turned(r, side * r.unit(), side * r.unit(), 1);
}
Rect clustered(Random& r, std::int64_t, std::int64_t, double side) {
  const auto cluster = static_cast<double>(static_cast<int>(30 * r.unit() * r.unit()));
  const double x = std::sin(cluster * 12.9898) * 0.5 + 0.5, y = std::sin(cluster * 78.233) * 0.5 + 0.5;
  const double spread = 0.02 * side * std::sqrt(-2 * std::log(1 - r.unit())), turn = 6.283185307179586 * r.unit();
  return turned(r, side * x + spread * std::cos(turn), side * y + spread * std::sin(turn), 0.4);
}
Rect decades_3(Random& r, std::int64_t, std::int64_t, double side) {
  return turned(r, side * r.unit(), side * r.unit(), r.scale(31.6) * 0.3);
}
Rect decades_6(Random& r, std::int64_t, std::int64_t, double side) {
  return turned(r, side * r.unit(), side * r.unit(), r.scale(1000) * 0.03);
}
Rect two_scales(Random& r, std::int64_t i, std::int64_t, double side) {
  const double scale = i % 2 == 0 ? 1 : 1e-5;
  return turned(r, side * (0.5 + scale * (r.unit() - 0.5)), side * (0.5 + scale * (r.unit() - 0.5)), scale);
}
Rect three_scales(Random& r, std::int64_t i, std::int64_t, double side) {
  const double scale = i % 3 == 0 ? 1 : i % 3 == 1 ? 1e-4 : 1e-8;
  return turned(r, side * (0.7 + scale * (r.unit() - 0.5)), side * (0.3 + scale * (r.unit() - 0.5)), scale);
}
Rect one_giant(Random& r, std::int64_t i, std::int64_t n, double side) {
  if (i == n / 3) return {side / 2, side / 2, 0.8, 0.6, side, side};
  return uniform(r, i, n, side);
}
Rect needles(Random& r, std::int64_t i, std::int64_t n, double side) {
  if (i % 50 != 1) return uniform(r, i, n, side);
  const double x = side * r.unit(), y = side * r.unit();
  return i % 100 == 1 ? Rect{side * 0.5, y, 1, 0, 0.4 * side, 0.01} : Rect{x, side * 0.5, 1, 0, 0.01, 0.4 * side};
}
Rect pareto_needles(Random& r, std::int64_t, std::int64_t, double side) {
  const double length = 0.5 / (1 - r.unit() * (1 - 1 / side));
  const bool wide = (r.next() & 1) != 0;
  return {side * r.unit(), side * r.unit(), wide ? 1.0 : 0.0, wide ? 0.0 : 1.0, length * 0.5, 0.01};
}
Rect line(Random& r, std::int64_t, std::int64_t n, double side) {
  return turned(r, side / 3, static_cast<double>(n) * 1.2 * r.unit(), 1);
}
Rect apart(Random& r, std::int64_t i, std::int64_t, double side) {
  if (i % 2 != 0) return {0.25 * side + 0.01 * side * r.unit(), side * r.unit(), 1, 0, 0.17 * side, 1e-9};
  return {0.75 * side + 0.2 * side * r.unit(), 0.5 * side, 0, 1, 0.4 * side, 1e-9};
}
Rect lattice(Random&, std::int64_t i, std::int64_t n, double) {
  const auto width = static_cast<std::int64_t>(std::sqrt(static_cast<double>(n)));
  const std::int64_t place = i * 7919 % n;  // shuffled: n has no factor 7919 in these tests
  return {static_cast<double>(place % width), static_cast<double>(place / width), 1, 0, 0.5, 0.5};
}
Rect diagonal(Random& r, std::int64_t, std::int64_t n, double) {
  const double side = std::sqrt(static_cast<double>(n));
  return {side * r.unit(), side * r.unit(), 0.8, 0.6, 2 * (0.5 + r.unit()), 1e-6};
}
Rect points(Random& r, std::int64_t, std::int64_t, double) {
  return {std::floor(60 * r.unit()), std::floor(60 * r.unit()), 1, 0, 0, 0};
}
/// Contacts in places that are no multiples of any grid, up to a unit in the last place.
Rect near_ties(Random& r, std::int64_t, std::int64_t, double) {
  const double step = 1.0 / 3;
  const double x = std::floor(60 * r.unit()) * step, y = std::floor(60 * r.unit()) * step;
  return {x, y, 1, 0, std::nextafter(step / 2, r.unit() < 0.5 ? 0.0 : 1.0), step / 2};
}
/// Magnitudes over all of the range: subnormal to 2^1023; frames of the most unlike exponents.
Rect whole_range(Random& r, std::int64_t, std::int64_t, double) {
  const double e = std::floor(2090 * r.unit()) - 1070;
  const auto signed_unit = [&r] { return (r.next() & 1) != 0 ? 0.5 + 0.5 * r.unit() : -0.5 - 0.5 * r.unit(); };
  const auto size = [&](double below) { return std::ldexp(r.unit(), static_cast<int>(std::max(e - below, -1074.0))); };
  return {std::ldexp(signed_unit(), static_cast<int>(e)),
          std::ldexp(signed_unit(), static_cast<int>(e)),
          1,
          0.5,
          size(-1 + 3 * r.unit()),
          size(6 * r.unit())};
}

struct Workload {
  const char* name;
  Draw draw;
};
constexpr Workload workloads[] = {{"uniform", uniform},
                                  {"clustered", clustered},
                                  {"decades_3", decades_3},
                                  {"decades_6", decades_6},
                                  {"two_scales", two_scales},
                                  {"three_scales", three_scales},
                                  {"one_giant", one_giant},
                                  {"needles", needles},
                                  {"pareto_needles", pareto_needles},
                                  {"line", line},
                                  {"apart", apart},
                                  {"lattice", lattice},
                                  {"diagonal", diagonal},
                                  {"points", points},
                                  {"near_ties", near_ties},
                                  {"whole_range", whole_range}};

std::vector<Rect> draw(const std::string& name, std::int64_t n, std::uint64_t seed) {
  std::vector<Rect> shapes;
  Random random{seed * 7919 + 13};
  for (const Workload& w : workloads) {
    if (w.name != name) continue;
    for (std::int64_t i = 0; i < n; ++i) shapes.push_back(w.draw(random, i, n, side_for(n)));
  }
  return shapes;
}

template <class T>
void append(std::vector<T>& numbers, std::initializer_list<double> values) {
  // Numbers that are finite as doubles stay finite as floats.
  for (const double x : values) {
    const auto most = static_cast<double>(std::numeric_limits<T>::max());
    numbers.push_back(static_cast<T>(std::clamp(x, -most, most)));
  }
}

template <class T>
void append_as(std::int32_t kind, const Rect& r, std::vector<T>& numbers) {
  switch (kind) {
    case VESICA_POINT:
      return append(numbers, {r.cx, r.cy});
    case VESICA_SEGMENT:
      return append(numbers, {r.cx - r.ux * r.hx, r.cy - r.uy * r.hx, r.cx + r.ux * r.hx, r.cy + r.uy * r.hx});
    case VESICA_CIRCLE:
      return append(numbers, {r.cx, r.cy, r.hx});
    case VESICA_AABB:
      return append(numbers, {r.cx - r.hx, r.cy - r.hy, r.cx + r.hx, r.cy + r.hy});
    default: {
      // A float's axis must not become zero.
      const double ux = std::fabs(r.ux) + std::fabs(r.uy) < 1e-30 ? 1 : r.ux;
      return append(numbers, {r.cx, r.cy, ux, r.uy, r.hx, r.hy});
    }
  }
}

}  // namespace

template <class T>
std::int64_t Records<T>::count() const {
  constexpr std::int64_t fields[] = {2, 4, 3, 4, 6, 6};
  return static_cast<std::int64_t>(numbers.size()) / fields[kind];
}

const std::vector<std::string>& rect_workloads() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Workload& w : workloads) all.emplace_back(w.name);
    return all;
  }();
  return names;
}

template <class T>
Records<T> rects(const std::string& workload, std::int64_t n, std::uint64_t seed) {
  Records<T> records{VESICA_RECT, {}};
  for (const Rect& r : draw(workload, n, seed)) append_as(VESICA_RECT, r, records.numbers);
  return records;
}

template <class T>
Laid<T> mixed(const std::string& workload, std::int64_t n, std::uint64_t seed, std::int64_t invalid_every) {
  const std::vector<Rect> shapes = draw(workload, n, seed);
  Laid<T> laid;
  for (std::int32_t kind = 0; kind < 6; ++kind) {
    Records<T> records{kind, {}};
    for (std::int64_t i = kind; i < n; i += 6) {
      append_as(kind, shapes[static_cast<std::size_t>(i)], records.numbers);
      if (invalid_every != 0 && i % invalid_every == 0) records.numbers.back() = std::numeric_limits<T>::quiet_NaN();
    }
    laid.push_back(std::move(records));
  }
  return laid;
}

template struct Records<float>;
template struct Records<double>;
template Records<float> rects(const std::string&, std::int64_t, std::uint64_t);
template Records<double> rects(const std::string&, std::int64_t, std::uint64_t);
template Laid<float> mixed(const std::string&, std::int64_t, std::uint64_t, std::int64_t);
template Laid<double> mixed(const std::string&, std::int64_t, std::uint64_t, std::int64_t);

}  // namespace index_tests
