// SPDX-License-Identifier: Apache-2.0
#include "methods/pools.hpp"

#include <algorithm>
#include <cmath>

namespace vesica::bench::methods {
namespace {

struct Place {
  double x, y;
};

/// Which of a shape's numbers are coordinates of points; its sizes are all others but an axis.
std::size_t coordinates(std::int32_t kind) { return kind == VESICA_SEGMENT || kind == VESICA_AABB ? 4 : 2; }

bool has_axis(std::int32_t kind) { return kind >= VESICA_RECT; }

Place centre(std::int32_t kind, const Numbers& numbers) {
  if (coordinates(kind) == 2) return {numbers[0], numbers[1]};
  return {(numbers[0] + numbers[2]) / 2, (numbers[1] + numbers[3]) / 2};
}

Numbers moved(std::int32_t kind, Numbers numbers, double x, double y) {
  for (std::size_t i = 0; i < coordinates(kind); ++i) numbers[i] += i % 2 == 0 ? x : y;
  return numbers;
}

Numbers with_lengths_times(std::int32_t kind, Numbers numbers, double factor) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!has_axis(kind) || (i != 2 && i != 3)) numbers[i] *= factor;
  }
  return numbers;
}

/// The size across an axis, where there is one, divided by the aspect.
Numbers thinned(std::int32_t kind, Numbers numbers, double aspect) {
  if (has_axis(kind)) numbers[5] = numbers[4] / aspect;
  if (kind == VESICA_AABB) numbers[3] = numbers[1] + (numbers[2] - numbers[0]) / aspect;
  return numbers;
}

Numbers with_common_axis(std::int32_t kind, Numbers numbers) {
  if (has_axis(kind)) {
    numbers[2] = 0.8;
    numbers[3] = 0.6;
  }
  return numbers;
}

/// A pair whose second shape moves along the line of centres.
struct Line {
  Kinds kinds;
  Numbers a, b;
  Place from, step;  ///< the first one's centre; to the second one's

  Numbers at(double t) const {
    const Place now = centre(kinds.b, b);
    return moved(kinds.b, b, from.x + t * step.x - now.x, from.y + t * step.y - now.y);
  }

  bool overlap(double t) const {
    const Numbers there = at(t);
    return vesica_overlap_f64(kinds.a, a.data(), kinds.b, there.data()) == 1;
  }

  /// The place of contact, as near as doubles get. They overlap at 0: every kind of shape holds its centre.
  double contact() const {
    double together = 0, apart = 1;
    while (overlap(apart)) apart *= 2;
    for (int i = 0; i < 60; ++i) {
      const double middle = (together + apart) / 2;
      (overlap(middle) ? together : apart) = middle;
    }
    return together;
  }
};

Line line_of_centres(const Kinds& kinds, const Numbers& a, const Numbers& b) {
  const Place from = centre(kinds.a, a), to = centre(kinds.b, b);
  const Place step = from.x == to.x && from.y == to.y ? Place{1, 0} : Place{to.x - from.x, to.y - from.y};
  return {kinds, a, b, from, step};
}

template <class Change>
Pool changed(Pool pool, const Kinds& kinds, Change change) {
  for (Numbers& numbers : pool.a) numbers = change(kinds.a, numbers);
  for (Numbers& numbers : pool.b) numbers = change(kinds.b, numbers);
  return pool;
}

/// Every second shape at the distance of contact times a factor drawn for it.
template <class Factor>
Pool about_contact(Pool pool, const Kinds& kinds, Factor factor) {
  pool.matched = true;
  for (std::size_t i = 0; i < pool.a.size(); ++i) {
    const Line line = line_of_centres(kinds, pool.a[i], pool.b[i]);
    pool.b[i] = line.at(line.contact() * factor());
  }
  return pool;
}

}  // namespace

const char* name_of(Trial trial) {
  constexpr std::array names{"random", "near 1e-6", "near 1e-12", "last place", "thin", "far", "tiny", "huge"};
  return names[static_cast<std::size_t>(trial)];
}

Pool make_pool(const Kinds& kinds, Trial trial, std::uint64_t seed, std::size_t size) {
  Random random(seed);
  Pool pool = bench::make_pool(kinds.a, kinds.b, Workload::mixed, seed);
  pool.a.resize(std::min(size, pool.a.size()));
  pool.b.resize(std::min(size, pool.b.size()));
  if (kinds.axes == Axes::parallel) pool = changed(pool, kinds, with_common_axis);
  const auto at_gap = [&](double gap) {
    return about_contact(pool, kinds, [&] { return random.chance(0.5) ? 1 - gap : 1 + gap; });
  };
  const auto times = [&](double factor) {
    return changed(pool, kinds,
                   [&](std::int32_t kind, const Numbers& s) { return with_lengths_times(kind, s, factor); });
  };
  switch (trial) {
    case Trial::random:
      return pool;
    case Trial::near_6:
      return at_gap(1e-6);
    case Trial::near_12:
      return at_gap(1e-12);
    case Trial::contact:
      return about_contact(pool, kinds, [&] { return random.chance(0.5) ? 1 : 1 + 0x1p-52; });
    case Trial::thin:
      return about_contact(changed(pool, kinds,
                                   [&](std::int32_t kind, const Numbers& s) {
                                     return thinned(kind, s, std::pow(10, random.between(2, 6)));
                                   }),
                           kinds, [&] { return random.between(0.5, 1.5); });
    case Trial::far:
      return changed(pool, kinds, [](std::int32_t kind, const Numbers& s) { return moved(kind, s, 1e12, -7e11); });
    case Trial::tiny:
      return times(0x1p-1060);
    case Trial::huge:
      return times(0x1p1000);
  }
  return {};
}

}  // namespace vesica::bench::methods
