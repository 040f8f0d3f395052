// SPDX-License-Identifier: Apache-2.0
#include "properties/generators.hpp"

#include <vesica.h>

#include <cmath>

#include "properties/shape_maker.hpp"

namespace properties {
namespace {

/// Magnitudes of a workload, which depend on the scalar's range and precision.
struct Range {
  double aspect_digits;                        // thin: aspect ratios up to 10^this
  int short_needle_exponent, needle_exponent;  // thin: needles up to 2^these by 2^-these
  double far_digits;                           // far: distances up to 10^this
  int tiniest_exponent, tiny_exponent;         // tiny: 2^these
  int huge_exponent, hugest_exponent;          // huge: 2^these
  int axis_exponent;                           // axis_length: 2^-this to 2^this
  int smallest_exponent, largest_exponent;     // every finite number but 0
};
constexpr Range range_f64{12, 50, 990, 15, -1060, -300, 300, 1000, 400, -1074, 1023};
constexpr Range range_f32{6, 10, 120, 7, -140, -60, 60, 120, 50, -149, 127};

const Range& range(Scalar scalar) { return scalar == Scalar::f32 ? range_f32 : range_f64; }

Pair rounded(const Pair& pair, Scalar scalar) {
  return {pair.kind_a, pair.kind_b, nearest_shape(scalar, pair.kind_a, pair.a),
          nearest_shape(scalar, pair.kind_b, pair.b)};
}

/// Has the kind an area?
bool solid(int kind) { return kind != VESICA_POINT && kind != VESICA_SEGMENT; }

/// Moves b so that a random point of it meets a random point of a, both drawn somewhat beyond the shapes: then about
/// half of the pairs overlap, thin ones too.
Pair placed(Pair pair, Random& random) {
  const double reach = solid(pair.kind_a) && solid(pair.kind_b) ? 2.25 : 1.5;
  const Vector pa = random_point(pair.kind_a, pair.a, random, reach);
  const Vector pb = random_point(pair.kind_b, pair.b, random, reach);
  const bool points_apart = pair.kind_b == VESICA_POINT && pair.kind_a == VESICA_POINT && random.chance(0.5);
  const Vector gap = points_apart ? Vector{random.between(-1, 1), random.between(-1, 1)} : Vector{0, 0};
  pair.b = moved(pair.kind_b, pair.b, {pa.x - pb.x + gap.x, pa.y - pb.y + gap.y});
  return pair;
}

Pair moved_together(Pair pair, Vector by) {
  pair.a = moved(pair.kind_a, pair.a, by);
  pair.b = moved(pair.kind_b, pair.b, by);
  return pair;
}

Pair scaled_together(Pair pair, int exponent, Random& random) {
  pair.a = scaled(pair.kind_a, pair.a, exponent, random.chance(0.25));
  pair.b = scaled(pair.kind_b, pair.b, exponent, random.chance(0.25));
  return pair;
}

Proportions ordinary(Random& random) {
  const double longer = random.between(0.25, 2);
  return {longer, longer * random.between(0.1, 1), 1};
}

Pair random_pair(int kind_a, int kind_b, Random& random) {
  Pair pair{kind_a, kind_b, shape_at_origin(kind_a, random, ordinary(random)),
            shape_at_origin(kind_b, random, ordinary(random))};
  pair = placed(pair, random);
  return moved_together(pair, {random.between(-10, 10), random.between(-10, 10)});
}

Pair grid_pair(int kind_a, int kind_b, Random& random) {
  const int reach = random.integer(1, 7);
  const Vector by{double(random.integer(-reach, reach)), double(random.integer(-reach, reach))};
  const Vector about{double(random.integer(-9, 9)), double(random.integer(-9, 9))};
  const Pair pair{kind_a, kind_b, integer_shape(kind_a, random), moved(kind_b, integer_shape(kind_b, random), by)};
  return moved_together(pair, about);
}

Pair degenerate_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  Pair pair = random.chance(0.5) ? grid_pair(kind_a, kind_b, random) : random_pair(kind_a, kind_b, random);
  if (random.chance(0.8)) pair.a = collapsed(kind_a, pair.a, random);
  if (random.chance(0.8)) pair.b = collapsed(kind_b, pair.b, random);
  pair = rounded(pair, scalar);
  if (random.chance(0.6)) {
    const Vector pa = special_point(kind_a, pair.a, random), pb = special_point(kind_b, pair.b, random);
    pair.b = moved(kind_b, pair.b, {pa.x - pb.x, pa.y - pb.y});
  }
  if (kind_a == kind_b && random.chance(0.15)) pair.b = pair.a;
  return pair;
}

/// Needles beyond the precision's reciprocal in aspect, half of them of magnitudes that no range guard turns away.
Proportions needle(Scalar scalar, Random& random) {
  const Range& r = range(scalar);
  const int exponent = random.integer(4, random.chance(0.5) ? r.short_needle_exponent : r.needle_exponent);
  const double longer = random.between(0.5, 1), shorter = random.between(0.5, 1);
  return {std::ldexp(longer, exponent), std::ldexp(shorter, -exponent), 1};
}

Proportions thin(Scalar scalar, Random& random) {
  if (random.chance(0.4)) return needle(scalar, random);
  const double longer = random.between(0.25, 2);
  return {longer, longer * std::pow(10.0, -random.between(0, range(scalar).aspect_digits)), 1};
}

/// The axis of a, each number of it up to one place off: thin shapes in parallel meet along all their length.
void align(Pair& pair, Scalar scalar, Random& random) {
  for (const std::size_t i : {2U, 3U}) {
    pair.b[i] = at_ordinal(scalar, ordinal(scalar, nearest(scalar, pair.a[i])) + random.integer(-1, 1));
  }
}

Pair thin_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  const Proportions a = thin(scalar, random);
  const Proportions b = random.chance(0.3) ? ordinary(random) : random.chance(0.5) ? a : thin(scalar, random);
  Pair pair{kind_a, kind_b, shape_at_origin(kind_a, random, a), shape_at_origin(kind_b, random, b)};
  const bool axes = has_axis(kind_a) && has_axis(kind_b);
  if (axes && random.chance(0.4)) align(pair, scalar, random);
  return placed(pair, random);
}

Pair far_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  const double x = random.sign() * std::pow(10.0, random.between(2, range(scalar).far_digits));
  const double y = random.sign() * std::pow(10.0, random.between(0, range(scalar).far_digits));
  return moved_together(random_pair(kind_a, kind_b, random), {x, y});
}

/// An ordinary, integer or touching pair times a power of two.
Pair scaled_pair(int kind_a, int kind_b, int low_exponent, int high_exponent, Random& random) {
  const int which = random.below(4);
  const Pair pair = which == 0   ? grid_pair(kind_a, kind_b, random)
                    : which == 1 ? touching(kind_a, kind_b, random).pair
                                 : random_pair(kind_a, kind_b, random);
  return scaled_together(pair, random.integer(low_exponent, high_exponent), random);
}

/// A contact, two of three times with one number moved one place, at any scale that keeps its integers.
Pair touching_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  constexpr int integer_bits = 20;
  const Range& r = range(scalar);
  Pair pair = touching(kind_a, kind_b, random).pair;
  if (random.chance(0.5)) {
    pair = scaled_together(pair, random.integer(r.tiniest_exponent, r.hugest_exponent - integer_bits), random);
  }
  if (random.chance(0.33)) return pair;
  const bool in_b = random.chance(0.5);
  Numbers& n = in_b ? pair.b : pair.a;
  double& x = n[static_cast<std::size_t>(random.below(field_count(in_b ? kind_b : kind_a)))];
  x = at_ordinal(scalar, ordinal(scalar, nearest(scalar, x)) + (random.chance(0.5) ? 1 : -1));
  return pair;
}

/// Any magnitude for any number; or lengths (axis times size) that mostly lie near a common one.
class MixedScale {
 public:
  MixedScale(Scalar scalar, Random& random) : range_(range(scalar)), random_(random) {
    coherent_ = random.chance(0.6);
    common_ = any_exponent();
  }

  Numbers shape(int kind) {
    Numbers n{};
    const int axis_exponent = any_exponent();
    for (int i = 0; i < field_count(kind); ++i) {
      const Role r = role(kind, i);
      int exponent = coherent_ && random_.chance(0.8) ? common_ + random_.integer(-2, 2) : any_exponent();
      if (r == Role::axis && coherent_) exponent = axis_exponent + (random_.chance(0.8) ? random_.integer(-1, 1) : 0);
      if (r == Role::size && coherent_) exponent -= axis_exponent;
      n[static_cast<std::size_t>(i)] = number(exponent);
    }
    return n;
  }

 private:
  int any_exponent() { return random_.integer(range_.smallest_exponent, range_.largest_exponent); }
  double number(int exponent) {
    if (random_.chance(0.05)) return 0;
    const double fraction = random_.chance(0.3) ? 1 : random_.between(1, 2);
    return random_.sign() * std::ldexp(fraction, exponent);
  }

  const Range& range_;
  Random& random_;
  bool coherent_;
  int common_;
};

Pair mixed_scale_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  MixedScale mixed(scalar, random);
  const Numbers a = mixed.shape(kind_a);
  return {kind_a, kind_b, a, mixed.shape(kind_b)};
}

Pair axis_length_pair(int kind_a, int kind_b, Scalar scalar, Random& random) {
  const auto proportions = [&] {
    Proportions p = ordinary(random);
    const int reach = random.chance(0.5) ? 4 : range(scalar).axis_exponent;
    const int exponent = random.integer(-reach, reach);
    p.axis_length = std::ldexp(random.between(1, 2), exponent);
    return p;
  };
  const Numbers a = shape_at_origin(kind_a, random, proportions());
  const Numbers b = shape_at_origin(kind_b, random, proportions());
  return placed({kind_a, kind_b, a, b}, random);
}

Pair unrounded(Workload workload, int kind_a, int kind_b, Scalar scalar, Random& random) {
  const Range& r = range(scalar);
  switch (workload) {
    case Workload::touching:
      return touching_pair(kind_a, kind_b, scalar, random);
    case Workload::degenerate:
      return degenerate_pair(kind_a, kind_b, scalar, random);
    case Workload::grid:
      return grid_pair(kind_a, kind_b, random);
    case Workload::thin:
      return thin_pair(kind_a, kind_b, scalar, random);
    case Workload::far:
      return far_pair(kind_a, kind_b, scalar, random);
    case Workload::tiny:
      return scaled_pair(kind_a, kind_b, r.tiniest_exponent, r.tiny_exponent, random);
    case Workload::huge:
      return scaled_pair(kind_a, kind_b, r.huge_exponent, r.hugest_exponent, random);
    case Workload::mixed_scale:
      return mixed_scale_pair(kind_a, kind_b, scalar, random);
    case Workload::axis_length:
      return axis_length_pair(kind_a, kind_b, scalar, random);
    default:
      return random_pair(kind_a, kind_b, random);
  }
}

/// One number of several, so that streams with equal seeds but other kinds do not run in step.
std::uint64_t mixed(std::uint64_t seed, int kind_a, int kind_b, Scalar scalar, Workload workload) {
  std::uint64_t h = seed;
  for (const int part : {kind_a, kind_b, static_cast<int>(scalar), static_cast<int>(workload)}) {
    h = (h ^ static_cast<std::uint64_t>(part + 1)) * 0x9e3779b97f4a7c15U;
    h ^= h >> 29;
  }
  return h;
}

}  // namespace

const char* name(Workload workload) {
  constexpr std::array<const char*, all_workloads.size()> names{"random", "near_contact", "touching",   "degenerate",
                                                                "grid",   "thin",         "far",        "tiny",
                                                                "huge",   "mixed_scale",  "axis_length"};
  return names.at(static_cast<std::size_t>(workload));
}

Pair draw(Workload workload, int kind_a, int kind_b, Scalar scalar, Random& random) {
  return rounded(unrounded(workload, kind_a, kind_b, scalar, random), scalar);
}

Stream::Stream(Workload workload, int kind_a, int kind_b, Scalar scalar, std::uint64_t seed, Decide decide)
    : workload_(workload),
      kind_a_(kind_a),
      kind_b_(kind_b),
      scalar_(scalar),
      random_(mixed(seed, kind_a, kind_b, scalar, workload)),
      decide_(decide) {}

Pair Stream::next() {
  if (workload_ != Workload::near_contact) return draw(workload_, kind_a_, kind_b_, scalar_, random_);
  if (next_pending_ == pending_.size()) {
    pending_ = near_contact(kind_a_, kind_b_, scalar_, random_, decide_);
    next_pending_ = 0;
  }
  return pending_[next_pending_++];
}

}  // namespace properties
