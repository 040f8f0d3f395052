// SPDX-License-Identifier: Apache-2.0
#include "workloads.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

#include "contacts.hpp"

namespace vesica::bench {
namespace {

constexpr std::size_t pool_size = 1 << 16;
constexpr std::size_t exact_pool_size = 1 << 12;
constexpr std::size_t slowest_kept = 8;

using Pair = std::pair<Numbers, Numbers>;

struct Kinds {
  std::int32_t a, b;
};

bool overlap(Kinds kinds, const Numbers& a, const Numbers& b) {
  return vesica_overlap_f64(kinds.a, a.data(), kinds.b, b.data()) == 1;
}

bool has_area(std::int32_t kind) { return kind != VESICA_POINT && kind != VESICA_SEGMENT; }

/// Points on points or segments meet with probability 0 wherever they are scattered.
bool meets_by_chance(Kinds kinds) { return kinds.a != VESICA_POINT || has_area(kinds.b); }

/// Points and AABBs: comparisons of stored numbers decide.
bool by_comparison(Kinds kinds) {
  const auto upright = [](std::int32_t kind) { return kind == VESICA_POINT || kind == VESICA_AABB; };
  return upright(kinds.a) && upright(kinds.b);
}

/// Half sizes from 1/4 to 1, evenly on a logarithmic scale: rectangles and ellipses of aspects up to 4.
double random_half_size(Random& random) { return std::exp2(random.between(-2, 0)); }

Numbers random_shape(Random& random, std::int32_t kind, double x, double y) {
  const double angle = random.between(0, 2 * std::numbers::pi);
  const double size0 = random_half_size(random), size1 = random_half_size(random);
  return shape_about(kind, x, y, std::cos(angle), std::sin(angle), size0, size1);
}

Numbers scattered_shape(Random& random, std::int32_t kind, double spread) {
  const double x = random.between(0, spread), y = random.between(0, spread);
  return random_shape(random, kind, x, y);
}

Numbers moved(Numbers numbers, std::int32_t kind, double x, double y) {
  numbers[0] += x;
  numbers[1] += y;
  if (kind == VESICA_SEGMENT || kind == VESICA_AABB || kind == VESICA_CAPSULE) {
    numbers[2] += x;
    numbers[3] += y;
  }
  return numbers;
}

double hit_rate(Kinds kinds, double spread, std::uint64_t seed) {
  constexpr int trials = 4096;
  Random random(seed);
  int hits = 0;
  for (int i = 0; i < trials; ++i) {
    const Numbers a = scattered_shape(random, kinds.a, spread);
    hits += overlap(kinds, a, scattered_shape(random, kinds.b, spread));
  }
  return static_cast<double>(hits) / trials;
}

/// The side of the square over which centres are scattered for the wanted share of overlaps.
double spread_for(Kinds kinds, double wanted_hit_rate, std::uint64_t seed) {
  double low = 0, high = 64;
  for (int i = 0; i < 24; ++i) {
    const double middle = (low + high) / 2;
    (hit_rate(kinds, middle, seed) > wanted_hit_rate ? low : high) = middle;
  }
  return (low + high) / 2;
}

Pool scattered(Kinds kinds, double wanted_hit_rate, std::uint64_t seed) {
  const double spread = spread_for(kinds, wanted_hit_rate, seed);
  Random random(seed);
  Pool pool;
  for (std::size_t i = 0; i < pool_size; ++i) {
    pool.a.push_back(scattered_shape(random, kinds.a, spread));
    pool.b.push_back(scattered_shape(random, kinds.b, spread));
  }
  return pool;
}

template <class MakePair>
Pool matched(std::size_t size, MakePair make_pair) {
  Pool pool;
  pool.matched = true;
  for (std::size_t i = 0; i < size; ++i) {
    const Pair pair = make_pair();
    pool.a.push_back(pair.first);
    pool.b.push_back(pair.second);
  }
  return pool;
}

/// A point and a point or segment on a lattice, with the wanted share exactly incident.
Pair lattice_pair(Random& random, std::int32_t kind_b, double wanted_hit_rate) {
  const auto coordinate = [&] { return 8 * random.integer(-0x1p20, 0x1p20); };
  const double x0 = coordinate(), y0 = coordinate(), x1 = coordinate(), y1 = coordinate();
  const double step = kind_b == VESICA_SEGMENT ? random.integer(0, 8) / 8 : 0;
  Numbers point{x0 + step * (x1 - x0), y0 + step * (y1 - y0)};
  if (!random.chance(wanted_hit_rate)) point[0] += random.integer(1, 0x1p20);
  const Numbers other = kind_b == VESICA_SEGMENT ? Numbers{x0, y0, x1, y1} : Numbers{x0, y0};
  return {point, other};
}

Pool overlapping_by(Kinds kinds, double wanted_hit_rate, std::uint64_t seed) {
  if (meets_by_chance(kinds)) return scattered(kinds, wanted_hit_rate, seed);
  Random random(seed);
  return matched(pool_size, [&] { return lattice_pair(random, kinds.b, wanted_hit_rate); });
}

/// Among 5,000 such shapes each overlaps about five others.
Pool clusters(Kinds kinds, std::uint64_t seed) {
  constexpr std::size_t count = 30;
  constexpr double width = 400, radius = 6;
  Random random(seed);
  std::array<std::pair<double, double>, count> centre;
  for (auto& [x, y] : centre) {
    x = random.between(0, width);
    y = random.between(0, width);
  }
  const auto shape = [&](std::int32_t kind) {
    const auto [x, y] = centre[static_cast<std::size_t>(random.between(0, count))];
    const double angle = random.between(0, 2 * std::numbers::pi),
                 from_centre = radius * std::sqrt(-std::log(1 - random.unit()));
    return random_shape(random, kind, x + from_centre * std::cos(angle), y + from_centre * std::sin(angle));
  };
  Pool pool;
  for (std::size_t i = 0; i < pool_size; ++i) {
    pool.a.push_back(shape(kinds.a));
    pool.b.push_back(shape(kinds.b));
  }
  return pool;
}

/// A shape, another about the same centre, and the direction in which the other moves away.
struct Departure {
  Numbers a, b;
  double x, y;
};

Departure random_departure(Random& random, Kinds kinds) {
  const double x = random.between(0, 1), y = random.between(0, 1);
  const double angle = random.between(0, 2 * std::numbers::pi);
  return {random_shape(random, kinds.a, x, y), random_shape(random, kinds.b, x, y), std::cos(angle), std::sin(angle)};
}

Numbers after(const Departure& departure, std::int32_t kind, double distance) {
  return moved(departure.b, kind, distance * departure.x, distance * departure.y);
}

/// Distances either side of the departure at which two convex shapes lose contact, `steps` bisections close.
std::pair<double, double> bracket_contact(const Departure& departure, Kinds kinds, int steps) {
  double together = 0, apart = 8;  // centres 8 apart: beyond the reach of half sizes up to 1
  for (int i = 0; i < steps; ++i) {
    const double middle = (together + apart) / 2;
    if (middle == together || middle == apart) break;
    (overlap(kinds, departure.a, after(departure, kinds.b, middle)) ? together : apart) = middle;
  }
  return {together, apart};
}

Pool near_contact(Kinds kinds, std::uint64_t seed) {
  constexpr double relative_gap = 1e-6;
  Random random(seed);
  return matched(pool_size, [&] {
    const Departure departure = random_departure(random, kinds);
    const double contact = bracket_contact(departure, kinds, 40).first;
    const double factor = random.chance(0.5) ? 1 - relative_gap : 1 + relative_gap;
    return Pair(departure.a, after(departure, kinds.b, contact * factor));
  });
}

Pool last_ulp(Kinds kinds, std::uint64_t seed) {
  Random random(seed);
  return matched(exact_pool_size, [&] {
    const Departure departure = random_departure(random, kinds);
    const auto [together, apart] = bracket_contact(departure, kinds, 2000);
    return Pair(departure.a, after(departure, kinds.b, random.chance(0.5) ? together : apart));
  });
}

/// Two neighbours of a lattice of unit squares, whose coordinates are multiples of 1 / parts.
Pool lattice(double parts, std::uint64_t seed) {
  Random random(seed);
  const auto square = [](double x, double y) { return Numbers{x, y, 1, 0, 0.5, 0.5}; };
  return matched(pool_size, [&] {
    const double x = std::floor(random.between(0, 1000 * parts)), y = std::floor(random.between(0, 1000 * parts));
    const double along = parts * (std::floor(random.between(0, 3)) - 1), across = random.chance(0.5) ? parts : -parts;
    const bool turned = random.chance(0.5);
    const double dx = turned ? across : along, dy = turned ? along : across;
    return Pair(square(x / parts, y / parts), square((x + dx) / parts, (y + dy) / parts));
  });
}

/// On the middle of the segment, which is the second shape; of a segment and an AABB the first.
Pool incident(Kinds kinds, std::uint64_t seed) {
  Random random(seed);
  const auto coordinate = [&] { return 8 * random.integer(-0x1p48, 0x1p48); };
  return matched(pool_size, [&] {
    const double x0 = coordinate(), y0 = coordinate(), x1 = coordinate(), y1 = coordinate();
    const Numbers segment{x0, y0, x1, y1};
    Numbers other{(x0 + x1) / 2, (y0 + y1) / 2, coordinate(), coordinate()};
    if (kinds.b != VESICA_AABB) return Pair(other, segment);
    for (const std::size_t i : {0, 1}) {
      if (other[i] > other[i + 2]) std::swap(other[i], other[i + 2]);
    }
    return Pair(segment, other);
  });
}

Pool few_digits(Kinds kinds, std::uint64_t seed) {
  Random random(seed);
  return matched(exact_pool_size, [&] { return short_contact(random, kinds.a, kinds.b); });
}

Pool tangent(Kinds kinds, std::uint64_t seed) {
  Random random(seed);
  return matched(exact_pool_size, [&] {
    if (kinds.a == VESICA_ELLIPSE) return ellipse_ellipse_contact(random);
    return kinds.b == VESICA_ELLIPSE ? rect_ellipse_contact(random) : rect_rect_contact(random);
  });
}

/// A rectangle or ellipse of finite, nonzero fields of any magnitude.
Numbers random_magnitudes(Random& random) {
  Numbers numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const int exponent = static_cast<int>(random.integer(-1074, 1023));
    const double magnitude = std::ldexp(1 + random.unit(), exponent);
    numbers[i] = i < 4 && random.chance(0.5) ? -magnitude : magnitude;
  }
  return numbers;
}

/// Nanoseconds of the quickest of three calls.
double time_of_call(Kinds kinds, const Pair& pair) {
  using Clock = std::chrono::steady_clock;
  double quickest = HUGE_VAL;
  for (int i = 0; i < 3; ++i) {
    const Clock::time_point start = Clock::now();
    overlap(kinds, pair.first, pair.second);
    quickest = std::min(quickest, std::chrono::duration<double, std::nano>(Clock::now() - start).count());
  }
  return quickest;
}

Pool slowest_exponents(Kinds kinds, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::pair<double, Pair>> timed;
  for (std::size_t i = 0; i < exact_pool_size; ++i) {
    const Pair pair{random_magnitudes(random), random_magnitudes(random)};
    timed.emplace_back(time_of_call(kinds, pair), pair);
  }
  std::ranges::sort(timed, [](const auto& p, const auto& q) { return p.first > q.first; });
  auto next = timed.begin();
  return matched(slowest_kept, [&] { return (next++)->second; });
}

}  // namespace

const char* name_of(Workload workload) {
  switch (workload) {
    case Workload::rare:
      return "rare";
    case Workload::sparse:
      return "sparse";
    case Workload::some:
      return "some";
    case Workload::mixed:
      return "mixed";
    case Workload::most:
      return "most";
    case Workload::clusters:
      return "clusters";
    case Workload::near:
      return "near";
    case Workload::pixels:
      return "pixels";
    case Workload::hundredths:
      return "hundredths";
    case Workload::incident:
      return "incident";
    case Workload::few_digits:
      return "few_digits";
    case Workload::tangent:
      return "tangent";
    case Workload::last_ulp:
      return "last_ulp";
    case Workload::exponents:
      return "exponents";
  }
  return "";
}

bool has_workload(std::int32_t kind_a, std::int32_t kind_b, Workload workload) {
  // Contacts are not made yet for shapes with a radius beside a core.
  const bool has_contacts = kind_b <= VESICA_ELLIPSE;
  switch (workload) {
    case Workload::rare:
    case Workload::sparse:
    case Workload::some:
    case Workload::mixed:
    case Workload::most:
    case Workload::clusters:
      return true;
    case Workload::near:
      return has_contacts && meets_by_chance({kind_a, kind_b});
    case Workload::last_ulp:
      return has_contacts && meets_by_chance({kind_a, kind_b}) && !by_comparison({kind_a, kind_b});
    case Workload::pixels:
    case Workload::hundredths:
      return kind_a == VESICA_RECT && kind_b == VESICA_RECT;
    case Workload::incident:
      return kind_b == VESICA_SEGMENT || (kind_a == VESICA_SEGMENT && kind_b == VESICA_AABB);
    case Workload::few_digits:
      return has_contacts && kind_b != VESICA_ELLIPSE && !by_comparison({kind_a, kind_b});
    case Workload::tangent:
    case Workload::exponents:
      return has_contacts && kind_a >= VESICA_RECT && kind_b >= VESICA_RECT;
  }
  return false;
}

Pool make_pool(std::int32_t kind_a, std::int32_t kind_b, Workload workload, std::uint64_t seed) {
  const Kinds kinds{kind_a, kind_b};
  switch (workload) {
    case Workload::rare:
      return overlapping_by(kinds, 0.01, seed);
    case Workload::sparse:
      return overlapping_by(kinds, 0.05, seed);
    case Workload::some:
      return overlapping_by(kinds, 0.2, seed);
    case Workload::mixed:
      return overlapping_by(kinds, 0.5, seed);
    case Workload::most:
      return overlapping_by(kinds, 0.9, seed);
    case Workload::clusters:
      return clusters(kinds, seed);
    case Workload::near:
      return near_contact(kinds, seed);
    case Workload::pixels:
      return lattice(1, seed);
    case Workload::hundredths:
      return lattice(100, seed);
    case Workload::incident:
      return incident(kinds, seed);
    case Workload::few_digits:
      return few_digits(kinds, seed);
    case Workload::tangent:
      return tangent(kinds, seed);
    case Workload::last_ulp:
      return last_ulp(kinds, seed);
    case Workload::exponents:
      return slowest_exponents(kinds, seed);
  }
  return {};
}

std::uint64_t seed_of_run() {
  const char* text = std::getenv("VESICA_SEED");
  return text ? std::strtoull(text, nullptr, 0) : 20250101u;
}

}  // namespace vesica::bench
