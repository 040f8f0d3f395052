// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "properties/generators.hpp"

namespace properties {
namespace {

/// One number of a pair: the field-th of a, or of b.
struct Place {
  bool in_b;
  int field;
};

int kind_at(const Pair& pair, Place place) { return place.in_b ? pair.kind_b : pair.kind_a; }
double& number_at(Pair& pair, Place place) {
  return (place.in_b ? pair.b : pair.a)[static_cast<std::size_t>(place.field)];
}

Place random_place(const Pair& pair, Random& random) {
  const bool in_b = random.chance(0.5);
  return {in_b, random.below(field_count(in_b ? pair.kind_b : pair.kind_a))};
}

/// The pair with one number replaced; nothing when that is no shape.
std::optional<Pair> with(Pair pair, Place place, double number) {
  number_at(pair, place) = number;
  const bool ok = place.in_b ? valid(pair.kind_b, pair.b) : valid(pair.kind_a, pair.a);
  return ok ? std::optional(pair) : std::nullopt;
}

/// A number that may well change the answer: another position, a size a few times larger or smaller, a nearby or
/// opposite one.
double candidate(Pair pair, Place place, Scalar scalar, Random& random) {
  const double old = number_at(pair, place);
  const Role r = role(kind_at(pair, place), place.field);
  if (random.chance(0.1)) return 0;
  if (is_size(r) || r == Role::axis) {
    double x = std::ldexp(old == 0 ? 1 : old, random.integer(-6, 6));
    x *= random.between(1, 2);
    return nearest(scalar, r == Role::axis ? x * random.sign() : x);
  }
  Place other = random_place(pair, random);
  while (role(kind_at(pair, other), other.field) == Role::axis) other = random_place(pair, random);
  const int exponent = random.integer(-4, 3);
  const double step = std::ldexp(number_at(pair, other) - (random.chance(0.5) ? old : 0), exponent);
  return nearest(scalar, random.chance(0.2) ? number_at(pair, other) : old + step);
}

bool overlaps(const Pair& pair, Decide decide) {
  return decide(pair.kind_a, pair.a.data(), pair.kind_b, pair.b.data());
}

/// Places apart; signed, the difference of opposite places would overflow.
std::uint64_t distance(std::int64_t a, std::int64_t b) {
  return static_cast<std::uint64_t>(std::max(a, b)) - static_cast<std::uint64_t>(std::min(a, b));
}

/// The overlapping one of two neighbouring numbers between which the answer changes.
double bisect(const Pair& pair, Place place, Scalar scalar, double overlapping, double disjoint, Decide decide) {
  std::int64_t inside = ordinal(scalar, overlapping), outside = ordinal(scalar, disjoint);
  while (distance(inside, outside) > 1) {
    // Halves the interval; a middle that is no shape (an axis through zero) is stepped over.
    std::int64_t middle = inside / 2 + outside / 2 + (inside % 2 + outside % 2) / 2;
    std::optional<Pair> tried = with(pair, place, at_ordinal(scalar, middle));
    if (!tried) tried = with(pair, place, at_ordinal(scalar, ++middle));
    if (!tried || middle == inside || middle == outside) break;
    (overlaps(*tried, decide) ? inside : outside) = middle;
  }
  return at_ordinal(scalar, inside);
}

/// A pair whose given number stands at contact.
struct AtContact {
  Pair pair;
  Place place;
};

std::optional<AtContact> find_contact(const Pair& base, Scalar scalar, Random& random, Decide decide) {
  const bool overlapping = overlaps(base, decide);
  for (int attempt = 0; attempt < 12; ++attempt) {
    const Place place = random_place(base, random);
    const std::optional<Pair> other = with(base, place, candidate(base, place, scalar, random));
    if (!other || overlaps(*other, decide) == overlapping) continue;
    Pair from = overlapping ? base : *other, to = overlapping ? *other : base;
    const double x = bisect(base, place, scalar, number_at(from, place), number_at(to, place), decide);
    number_at(from, place) = x;
    return AtContact{from, place};
  }
  return std::nullopt;
}

void add_neighbours(std::vector<Pair>& pairs, Pair pair, Place place, Scalar scalar, int reach) {
  const std::int64_t middle = ordinal(scalar, number_at(pair, place));
  for (std::int64_t k = -reach; k <= reach; ++k) {
    const std::optional<Pair> neighbour = with(pair, place, at_ordinal(scalar, middle + k));
    if (neighbour) pairs.push_back(*neighbour);
  }
}

/// Magnitudes so far apart make the oracle's integers long, so few of the contacts are sought there.
Workload base_workload(Random& random_numbers) {
  using enum Workload;
  constexpr std::array common{random,      random, random, grid, degenerate, touching,
                              axis_length, thin,   far,    far,  tiny,       huge};
  return random_numbers.chance(0.03) ? mixed_scale : common[static_cast<std::size_t>(random_numbers.below(12))];
}

}  // namespace

std::vector<Pair> about_contact(const Pair& base, Scalar scalar, Random& random, Decide decide) {
  const std::optional<AtContact> contact = find_contact(base, scalar, random, decide);
  if (!contact) return {};
  std::vector<Pair> pairs;
  add_neighbours(pairs, contact->pair, contact->place, scalar, 4);
  for (int i = 0; i < 2; ++i) add_neighbours(pairs, contact->pair, random_place(contact->pair, random), scalar, 1);
  return pairs;
}

std::vector<Pair> near_contact(int kind_a, int kind_b, Scalar scalar, Random& random, Decide decide) {
  for (;;) {
    const Pair base = draw(base_workload(random), kind_a, kind_b, scalar, random);
    std::vector<Pair> pairs = about_contact(base, scalar, random, decide);
    if (!pairs.empty()) return pairs;
  }
}

}  // namespace properties
