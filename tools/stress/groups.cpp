// SPDX-License-Identifier: Apache-2.0
#include "stress/groups.hpp"

#include <vesica.h>

#include <cmath>
#include <limits>
#include <optional>

#include "area/hard_pairs.hpp"
#include "boundary_distance/nested_pairs.hpp"
#include "properties/exact_changes.hpp"
#include "properties/generators.hpp"
#include "properties/shape_maker.hpp"
#include "stress/built_pairs.hpp"
#include "stress/call.hpp"

namespace stress {
namespace {

using properties::Random;
using properties::Role;

constexpr int reach = 64, neighbours = 12, near_places = 8, attempts = 12;

/// SplitMix64: one seed from two numbers.
std::uint64_t mixed(std::uint64_t seed, std::uint64_t number) {
  std::uint64_t x = seed * 0x9E3779B97F4A7C15u + number + 1;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
  return x ^ (x >> 31);
}

struct Limits {
  int least_exponent, most_exponent, tiny_exponent, huge_exponent;
  double far;
};
constexpr Limits limits_f64{-1074, 1023, -1060, 990, 1e15}, limits_f32{-149, 127, -140, 118, 1e7};
const Limits& limits(Scalar scalar) { return scalar == Scalar::f32 ? limits_f32 : limits_f64; }

/// A number of any magnitude.
double odd_number(Scalar scalar, Random& random) {
  const Limits& l = limits(scalar);
  const double mantissa = random.chance(0.3) ? 1 : 1 + random.unit();
  return properties::nearest(scalar,
                             random.sign() * std::ldexp(mantissa, random.integer(l.least_exponent, l.most_exponent)));
}

Numbers odd_shape(Scalar scalar, int kind, Random& random) {
  Numbers n{};
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (!random.chance(0.05)) n[static_cast<std::size_t>(i)] = odd_number(scalar, random);
  }
  return properties::nearest_shape(scalar, kind, n);
}

Pair odd_pair(Scalar scalar, int kind_a, int kind_b, Random& random) {
  Pair pair{kind_a, kind_b, odd_shape(scalar, kind_a, random), odd_shape(scalar, kind_b, random)};
  // Odd places are far apart, so often the second shape takes coordinates of the first.
  for (const std::size_t i : {0U, 1U}) {
    if (random.chance(0.6)) pair.b[i] = pair.a[i];
  }
  pair.b = properties::nearest_shape(scalar, kind_b, pair.b);
  return pair;
}

/// One size of the shape a lot less than it is.
Numbers thinned(int kind, Numbers n, Random& random) {
  const double by = std::pow(10.0, -random.between(0, 12));
  if (kind == VESICA_AABB) {
    const std::size_t i = random.chance(0.5) ? 0U : 1U;
    n[i + 2] = n[i] + (n[i + 2] - n[i]) * by;
  } else if (kind == VESICA_CAPSULE) {
    n[4] *= by;
  } else if (kind >= VESICA_RECT) {
    n[random.chance(0.5) ? 4U : 5U] *= by;
  }
  return n;
}

/// Far smaller than it is, where it is: to a shape of another size about a dot.
Numbers shrunk(Scalar scalar, int kind, Numbers n, Random& random) {
  const double by = std::ldexp(1, -random.integer(20, scalar == Scalar::f32 ? 120 : 700));
  if (properties::role(kind, 2) == Role::x) {
    for (const std::size_t i : {0U, 1U}) n[i + 2] = n[i] + (n[i + 2] - n[i]) * by;
  }
  for (int i = 0; i < properties::field_count(kind); ++i) {
    if (is_size(properties::role(kind, i))) n[static_cast<std::size_t>(i)] *= by;
  }
  return properties::nearest_shape(scalar, kind, n);
}

Pair shifted(Pair p, double x, double y) {
  p.a = properties::moved(p.kind_a, p.a, {x, y});
  p.b = properties::moved(p.kind_b, p.b, {x, y});
  return p;
}

/// The hard and the nested pairs are drawn of these kinds.
bool areal(int kind) { return kind >= VESICA_CIRCLE && !is_inflated(kind); }

Pair drawn(Scalar scalar, int kind_a, int kind_b, Random& random) {
  using properties::Workload;
  constexpr Workload workloads[] = {Workload::random, Workload::random,     Workload::touching, Workload::degenerate,
                                    Workload::grid,   Workload::thin,       Workload::far,      Workload::tiny,
                                    Workload::huge,   Workload::axis_length};
  if (areal(kind_a) && areal(kind_b) && random.chance(0.15)) {
    const auto which =
        hard::all_cases[static_cast<std::size_t>(random.below(static_cast<int>(hard::all_cases.size())))];
    return hard::draw(which, kind_a, kind_b, random.chance(0.5) ? 2 : 12, random);
  }
  if (areal(kind_a) && random.chance(0.1)) {
    const auto style = nested_pairs::all_styles[random.below(static_cast<int>(std::size(nested_pairs::all_styles)))];
    if (const auto pair = nested_pairs::draw(style, kind_a, kind_b, random)) return *pair;
  }
  return properties::draw(workloads[random.below(static_cast<int>(std::size(workloads)))], kind_a, kind_b, scalar,
                          random);
}

Pair altered(Scalar scalar, Pair p, Random& random) {
  const Limits& l = limits(scalar);
  if (random.chance(0.15)) p.a = thinned(p.kind_a, p.a, random);
  if (random.chance(0.15)) p.b = thinned(p.kind_b, p.b, random);
  if (random.chance(0.03)) p.a = shrunk(scalar, p.kind_a, p.a, random);
  if (random.chance(0.03)) p.b = shrunk(scalar, p.kind_b, p.b, random);
  if (random.chance(0.05)) p.a = properties::collapsed(p.kind_a, p.a, random);
  if (random.chance(0.05)) p.b = properties::collapsed(p.kind_b, p.b, random);
  if (random.chance(0.1)) {
    const double way = std::pow(l.far, random.unit());
    const double x = way * random.between(-1, 1);
    const double y = way * random.between(-1, 1);
    p = shifted(p, x, y);
  }
  if (random.chance(0.1)) {
    const int exponent = random.integer(l.tiny_exponent, l.huge_exponent);
    const bool axes = random.chance(0.3);
    p.a = properties::scaled(p.kind_a, p.a, exponent, axes);
    p.b = properties::scaled(p.kind_b, p.b, exponent, axes);
  }
  return p;
}

/// The query that is bisected: overlap, or the relation.
std::int32_t answer(Query query, Scalar scalar, const Pair& p) { return ask(query, scalar, p).code; }

struct Place {
  bool in_b;
  int field;
};

double& number_at(Pair& p, const Place& place) {
  return (place.in_b ? p.b : p.a)[static_cast<std::size_t>(place.field)];
}

bool still_valid(const Pair& p, const Place& place) {
  return place.in_b ? properties::valid(p.kind_b, p.b) : properties::valid(p.kind_a, p.a);
}

/// Another number for a place, which may well change the answer.
double candidate(Pair p, const Place& place, Scalar scalar, bool odd, Random& random) {
  const double old = number_at(p, place);
  const Role role = properties::role(place.in_b ? p.kind_b : p.kind_a, place.field);
  if (odd) return is_size(role) ? std::fabs(odd_number(scalar, random)) : odd_number(scalar, random);
  if (is_size(role) || role == Role::axis) {
    const double power = std::ldexp(1, random.integer(-6, 6));
    const double x = power * (old == 0 ? 1 : old) * random.between(1, 2);
    return properties::nearest(scalar, role == Role::axis ? x * random.sign() : x);
  }
  const bool other = random.chance(0.5);
  const int kind = other ? p.kind_b : p.kind_a;
  double step = (other ? p.b : p.a)[static_cast<std::size_t>(random.below(properties::field_count(kind)))];
  if (random.chance(0.5)) step -= old;
  step = std::ldexp(step, random.integer(-4, 3));
  return properties::nearest(scalar, old + random.sign() * step);
}

/// The last place, from the old number's, at which the answer is still the old one.
std::int64_t bisected(Query query, Scalar scalar, Pair p, const Place& place, double other) {
  const std::int32_t before = answer(query, scalar, p);
  std::int64_t same = properties::ordinal(scalar, number_at(p, place)), different = properties::ordinal(scalar, other);
  while (same + 1 < different || different + 1 < same) {
    const std::int64_t middle = same / 2 + different / 2 + (same % 2 + different % 2) / 2;
    number_at(p, place) = properties::at_ordinal(scalar, middle);
    (answer(query, scalar, p) == before ? same : different) = middle;
  }
  return same;
}

Pair exchanged_mirrored_turned(Pair p, Random& random) {
  properties::Shape a{p.kind_a, p.a}, b{p.kind_b, p.b};
  if (random.chance(0.25)) a = properties::mirrored(a), b = properties::mirrored(b);
  for (int quarter = random.chance(0.25) ? random.integer(1, 3) : 0; quarter > 0; --quarter) {
    a = properties::turned(a), b = properties::turned(b);
  }
  return {a.kind, b.kind, a.numbers, b.numbers};
}

/// Neighbours of the contact; those that are no shapes are left out.
void append_neighbours(Scalar scalar, Pair p, const Place& place, std::int64_t contact, Random& random, Group& group) {
  for (int i = 0; i < neighbours; ++i) {
    // Some go further: distances and depths from a last place up to the size of the shapes.
    const std::int64_t far = std::int64_t{1} << random.integer(6, scalar == Scalar::f32 ? 22 : 51);
    const std::int64_t away = i < 3              ? i - 1
                              : i >= near_places ? (random.chance(0.5) ? far : -far)
                                                 : random.integer(-reach, reach);
    number_at(p, place) = properties::at_ordinal(scalar, contact + away);
    if (still_valid(p, place)) group.pairs.push_back(exchanged_mirrored_turned(p, random));
  }
}

void append_contact(Scalar scalar, const Pair& base, bool odd, Random& random, Group& group) {
  const Query query = random.chance(0.5) ? Query::overlap : Query::relation;
  const std::int32_t before = answer(query, scalar, base);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const bool in_b = random.chance(0.5);
    const Place place{in_b, random.below(properties::field_count(in_b ? base.kind_b : base.kind_a))};
    Pair changed = base;
    const double other = candidate(base, place, scalar, odd, random);
    number_at(changed, place) = other;
    if (!still_valid(changed, place) || answer(query, scalar, changed) == before) continue;
    append_neighbours(scalar, base, place, bisected(query, scalar, base, place, other), random, group);
    return;
  }
}

bool is_valid(const Pair& pair) {
  return properties::valid(pair.kind_a, pair.a) && properties::valid(pair.kind_b, pair.b);
}

Group built_group(Drawn from, Random& random) {
  Group group{Scalar::f64, {}};
  for (int i = 0; i < (from == Drawn::ties ? 8 : 1); ++i) {
    const Pair pair = from == Drawn::ties ? draw_tie_pair(random) : draw_needle_pair(random);
    if (is_valid(pair)) group.pairs.push_back(exchanged_mirrored_turned(pair, random));
  }
  if (from == Drawn::needles && !group.pairs.empty()) {
    append_contact(Scalar::f64, Pair(group.pairs.front()), false, random, group);
  }
  return group;
}

}  // namespace

Group draw_group(std::uint64_t seed, std::uint64_t number, Drawn from) {
  Random random(mixed(seed, number));
  if (from != Drawn::all) return built_group(from, random);
  Group group{random.chance(0.5) ? Scalar::f32 : Scalar::f64, {}};
  const int kind_a = random.below(properties::kinds), kind_b = random.below(properties::kinds);
  const bool odd = random.below(8) == 0;
  Pair base = odd ? odd_pair(group.scalar, kind_a, kind_b, random)
                  : altered(group.scalar, drawn(group.scalar, kind_a, kind_b, random), random);
  base.a = properties::nearest_shape(group.scalar, kind_a, base.a);
  base.b = properties::nearest_shape(group.scalar, kind_b, base.b);
  group.pairs.push_back(base);
  append_contact(group.scalar, base, odd, random, group);
  return group;
}

Pair broken(const Pair& pair, std::uint64_t random_bits) {
  Random random(random_bits);
  Pair p = pair;
  const bool in_b = random.chance(0.5);
  const int kind = in_b ? p.kind_b : p.kind_a;
  Numbers& n = in_b ? p.b : p.a;
  const int field = random.below(properties::field_count(kind));
  double& x = n[static_cast<std::size_t>(field)];
  const int how = random.below(4);
  if (how == 0 && properties::role(kind, 2) == Role::axis) {
    n[2] = 0, n[3] = random.chance(0.5) ? -0.0 : 0.0;
  } else if (how == 1 && kind == VESICA_AABB && n[0] < n[2]) {
    std::swap(n[0], n[2]);
  } else if (how == 2 && is_size(properties::role(kind, field)) && x > 0) {
    x = -x;
  } else {
    const double infinity = std::numeric_limits<double>::infinity();
    x = random.chance(0.5) ? std::numeric_limits<double>::quiet_NaN() : random.sign() * infinity;
  }
  return p;
}

}  // namespace stress
