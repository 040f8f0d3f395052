// SPDX-License-Identifier: Apache-2.0
// The area that two polygons of one ring share, in lanes of pairs: the sum of polygon/area.hpp, in its order, so that
// the bits are the same. Included by query_loop.hpp.
#pragma once

#include <limits>
#include <vesica/arithmetic/error_free.hpp>
#include <vesica/polygon/line.hpp>

#include "kernels/query_table.hpp"

namespace vesica {
namespace {

/// RingColumn's numbers, of polygon i and those after it, or of one repeated.
template <bool repeats>
class RingLanes {
 public:
  VESICA_INLINE RingLanes(const double* from, std::int32_t i) noexcept : from_(repeats ? from : from + i) {}

  VESICA_INLINE Doubles operator[](int k) const noexcept {
    if constexpr (repeats) return Doubles(from_[k * RingColumn::length]);
    return Doubles::load(from_ + k * RingColumn::length);
  }
  VESICA_INLINE Aabb<Doubles> box() const noexcept {
    const RingLanes& n = *this;
    return {n[RingColumn::min_x], n[RingColumn::min_y], n[RingColumn::max_x], n[RingColumn::max_y]};
  }
  VESICA_INLINE Doubles area() const noexcept { return (*this)[RingColumn::area]; }
  VESICA_INLINE Doubles open() const noexcept { return (*this)[RingColumn::open]; }
  VESICA_INLINE Doubles x(int k) const noexcept { return (*this)[RingColumn::x + k]; }
  VESICA_INLINE Doubles y(int k) const noexcept { return (*this)[RingColumn::y + k]; }
  VESICA_INLINE Doubles slope(int k) const noexcept { return (*this)[RingColumn::slope + k]; }

 private:
  const double* from_;
};

/// Is the greatest of coordinates of this range one that Scale of own_area.hpp leaves as it is?
VESICA_INLINE PairMask has_usual_scale(Doubles low, Doubles high) noexcept {
  const Doubles most = max(abs(low), abs(high)), zero(0.0);
  return either(most == zero, both(most >= Doubles(0x1p-150), most <= Doubles(0x1p150)));
}

/// The RingFacts. The area as measure() of own_area.hpp has it, in its order; NaN where that is not sure of it.
VESICA_KERNEL inline void find_ring_facts(double* columns, int sides, std::int32_t n) noexcept {
  const Doubles zero(0.0), nan(std::numeric_limits<double>::quiet_NaN());
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const RingLanes<false> ring(columns, i);
    const auto store = [&](int k, Doubles x) { x.store(columns + k * RingColumn::length + i); };
    Aabb<Doubles> box{ring.x(0), ring.y(0), ring.x(0), ring.y(0)};
    Doubles finite = zero;
    for (int k = 0; k < sides; ++k) {
      const Doubles x = ring.x(k), y = ring.y(k);
      box = {min(box.min_x, x), min(box.min_y, y), max(box.max_x, x), max(box.max_y, y)};
      finite = finite + ((x - x) + (y - y));
    }
    const Doubles width = box.max_x - box.min_x, level = Doubles(0.5) * box.min_y + Doubles(0.5) * box.max_y;
    detail::arithmetic::Pair<Doubles> doubled{zero, zero};
    Doubles widths = zero, open = zero;
    for (int k = 0; k < sides; ++k) {
      const Doubles dx = ring.x(k + 1) - ring.x(k), y = ring.y(k), next_y = ring.y(k + 1);
      const auto s = detail::arithmetic::two_sum(doubled.high, dx * ((y - level) + (next_y - level)));
      doubled = {s.high, doubled.low + s.low};
      widths = widths + abs(dx);
      const PairMask upright = dx == zero;
      const Doubles slope = select(upright, zero, (next_y - y) / dx);
      // Else the side would be left out for some pairs, or has no slope.
      const PairMask usable = both(abs(dx) > Doubles(0x1p-200) * width, abs(slope) <= Doubles(0x1p1000));
      open = select(either(upright, usable), open, nan);
      store(RingColumn::slope + k, slope);
    }
    for (int k = sides; k < RingColumn::sides; ++k) store(RingColumn::slope + k, zero);
    const Doubles area = Doubles(0.5) * abs(doubled.high + doubled.low);
    const Doubles error = Doubles(0x1p-50) * widths * (box.max_y - box.min_y);
    const PairMask usual = both(has_usual_scale(box.min_x, box.max_x), has_usual_scale(box.min_y, box.max_y));
    const PairMask usable = both(both(finite == zero, usual), area > error);
    store(RingColumn::min_x, box.min_x);
    store(RingColumn::min_y, box.min_y);
    store(RingColumn::max_x, box.max_x);
    store(RingColumn::max_y, box.max_y);
    store(RingColumn::area, select(usable, area, nan));
    store(RingColumn::open, open);
  }
}

/// Masks of the lanes in which a box is before another by its numbers, and in which both are equal.
struct BoxOrder {
  PairMask before, equal;

  VESICA_INLINE BoxOrder(const Aabb<Doubles>& a, const Aabb<Doubles>& b) noexcept
      : before(a.min_x < b.min_x), equal(a.min_x == b.min_x) {
    refine(a.min_y, b.min_y);
    refine(a.max_x, b.max_x);
    refine(a.max_y, b.max_y);
  }

 private:
  VESICA_INLINE void refine(Doubles a, Doubles b) noexcept {
    before = either(before, both(equal, a < b));
    equal = both(equal, a == b);
  }
};

/// Two polygons with the one first whose box is before the other's: exchanging them changes no bit.
template <bool repeats>
class RingPair {
 public:
  VESICA_INLINE RingPair(const double* a, const double* b, std::int32_t i, int sides) noexcept
      : a_(a, i), b_(b, i), sides_(sides), order_(a_.box(), b_.box()) {
    const Aabb<Doubles> p = a_.box(), q = b_.box();
    const Doubles min_x = max(p.min_x, q.min_x), min_y = max(p.min_y, q.min_y);
    const Doubles max_x = min(p.max_x, q.max_x), max_y = min(p.max_y, q.max_y);
    near_ = both(min_x < max_x, min_y < max_y);
    level_ = Doubles(0.5) * min_y + Doubles(0.5) * max_y;
    height_ = max(max(p.max_y, q.max_y) - level_, level_ - min(p.min_y, q.min_y));
  }

  /// Lanes of pairs whose boxes share more than an edge, if both polygons are usable.
  VESICA_INLINE PairMask near() const noexcept { return near_; }
  /// Lanes of pairs of usable polygons.
  VESICA_INLINE PairMask usable() const noexcept {
    const Doubles sum = a_.area() + b_.area();
    return sum == sum;
  }

  /// 0 where they share nothing, NaN where the boxes are equal, or the exact relation must decide.
  VESICA_INLINE Doubles shared_area() const noexcept {
    Line second[RingColumn::sides];
    for (int k = 0; k < sides_; ++k) second[k] = line(k, false);
    const Doubles low = either_number(a_.box().min_x, b_.box().min_x, false);
    const Doubles high = either_number(a_.box().max_x, b_.box().max_x, false);
    const Doubles top = either_number(a_.box().max_y, b_.box().max_y, false);
    detail::arithmetic::Pair<Doubles> total{Doubles(0.0), Doubles(0.0)};
    Doubles widths(0.0);
    for (int k = 0; k < sides_; ++k) {
      const Line e = line(k, true);
      // As Policy::keeps() of area.hpp.
      const PairMask kept = both(both(e.x0 < high, low < e.x1), lower_end(k) < top);
      Doubles sum[2] = {Doubles(0.0), Doubles(0.0)}, width[2] = {Doubles(0.0), Doubles(0.0)};
      for (int j = 0; j < sides_; ++j) {
        const auto t = detail::polygon::term(e, second[j]);
        sum[j % 2] = sum[j % 2] + t.area;
        width[j % 2] = width[j % 2] + t.width;
      }
      const Doubles zero(0.0), part = Doubles(0.5) * e.sign * (sum[0] + sum[1]);
      const auto s = detail::arithmetic::two_sum(total.high, select(kept, part, zero));
      total = {s.high, total.low + s.low};
      widths = widths + select(kept, width[0] + width[1], zero);
    }
    return settled(abs(total.high + total.low), Doubles(0x1p-46) * height_ * widths);
  }

 private:
  using Line = detail::polygon::Line<Doubles>;

  VESICA_INLINE Doubles either_number(Doubles a, Doubles b, bool first) const noexcept {
    return first ? select(order_.before, a, b) : select(order_.before, b, a);
  }
  /// Side k of the first polygon, or of the second; one without width adds nothing.
  VESICA_INLINE Line line(int k, bool first) const noexcept {
    const Doubles x = either_number(a_.x(k), b_.x(k), first), next_x = either_number(a_.x(k + 1), b_.x(k + 1), first);
    const Doubles y = either_number(a_.y(k), b_.y(k), first), next_y = either_number(a_.y(k + 1), b_.y(k + 1), first);
    const PairMask right = x < next_x;
    const Doubles one(1.0), sign = select(x == next_x, Doubles(0.0), select(right, one, -one));
    return {min(x, next_x), max(x, next_x), select(right, y, next_y) - level_,
            either_number(a_.slope(k), b_.slope(k), first), sign};
  }
  VESICA_INLINE Doubles lower_end(int k) const noexcept {
    return either_number(min(a_.y(k), a_.y(k + 1)), min(b_.y(k), b_.y(k + 1)), true);
  }
  /// As settled() of area.hpp.
  VESICA_INLINE Doubles settled(Doubles area, Doubles error) const noexcept {
    const Doubles least = min(a_.area(), b_.area()), nan(std::numeric_limits<double>::quiet_NaN());
    const PairMask some = area > error, all = least - area <= error;
    const Doubles known = select(some, select(all, least, area), select(all, nan, Doubles(0.0)));
    return select(order_.equal, nan, known) + (a_.open() + b_.open());
  }

  RingLanes<repeats> a_;
  RingLanes<false> b_;
  int sides_;
  BoxOrder order_;
  PairMask near_;
  Doubles level_, height_;
};

/// The RingAreas.
template <bool repeats>
VESICA_KERNEL void ring_areas(const double* a, const double* b, int sides, std::int32_t n, double* out) noexcept {
  for (std::int32_t i = 0; i < n; i += Doubles::width) {
    const RingPair<repeats> pair(a, b, i, sides);
    const PairMask near = pair.near();
    Doubles area(0.0);
    if (bits(near) != 0) area = select(near, pair.shared_area(), area);
    select(pair.usable(), area, Doubles(std::numeric_limits<double>::quiet_NaN())).store(out + i);
  }
}

}  // namespace
}  // namespace vesica
