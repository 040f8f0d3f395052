// SPDX-License-Identifier: Apache-2.0
#include "index/plan.hpp"

#include "index/frame.hpp"

namespace vesica::index {

namespace {

inline constexpr double infinity = __builtin_inf();

constexpr double least(double a, double b) noexcept { return b < a ? b : a; }
constexpr double most(double a, double b) noexcept { return a < b ? b : a; }

/// The least e with |x| <= 2^e, or a little more; at least least_p - 20.
int exponent_above(double x) noexcept {
  const auto bits = __builtin_bit_cast(std::uint64_t, x) & ~(std::uint64_t{1} << 63);
  const int e = static_cast<int>(bits >> 52) - 1022;
  return e < least_p - 20 ? least_p - 20 : e;
}

/// Puts numbers that `first` holds for before the others; returns where the others begin. Without branches, which would
/// be mispredicted.
template <class First>
std::int64_t put_first(double* v, std::int64_t begin, std::int64_t end, First first) noexcept {
  std::int64_t others = begin;
  for (std::int64_t i = begin; i < end; ++i) {
    const double x = v[i];
    v[i] = v[others];
    v[others] = x;
    others += static_cast<std::int64_t>(first(x));
  }
  return others;
}

/// The k-th least of n numbers, which are put in another order. Its value does not depend on how ties are broken.
double nth(double* v, std::int64_t n, std::int64_t k) noexcept {
  std::int64_t begin = 0, end = n;
  while (end - begin > 1) {
    const double a = v[begin], b = v[begin + (end - begin) / 2], c = v[end - 1];
    const double pivot = most(least(a, b), least(most(a, b), c));
    const std::int64_t middle = put_first(v, begin, end, [pivot](double x) { return x < pivot; });
    if (k < middle) {
      end = middle;
    } else if (middle > begin) {
      begin = middle;
    } else {
      // None is less: those that are equal are taken out.
      begin = put_first(v, begin, end, [pivot](double x) { return x <= pivot; });
      if (k < begin) return pivot;
    }
  }
  return v[k];
}

/// A cut whose lowest bit is its axis.
double with_axis(double cut, int axis) noexcept {
  const auto bits = __builtin_bit_cast(std::uint64_t, cut);
  return __builtin_bit_cast(double, (bits & ~std::uint64_t{1}) | static_cast<std::uint64_t>(axis));
}

Frame frame_about(const double (&centre)[2], const double (&width)[2]) noexcept {
  Frame frame;
  for (int a = 0; a < 2; ++a) {
    // 2^16 columns are at least twice the width, and |k| is at most 2^49 and a little.
    const double w = width[a] * (1 + 0x1p-8);
    const int by_width = exponent_above(w) - 15, by_place = exponent_above(most(__builtin_fabs(centre[a]), w)) - 49;
    // The exponent of an infinite number is 1025: no p is above greatest_p.
    int p = by_width > by_place ? by_width : by_place;
    p = p < least_p ? least_p : p;
    frame.p[a] = p;
    frame.k[a] = static_cast<std::int64_t>(grid_floor(centre[a], power_of_two(-p))) - 32768;
  }
  return frame;
}

class Planner {
 public:
  Planner(Sample* sample, Sample* spare, const PlanRoom& room) noexcept : sample_(sample), spare_(spare), room_(room) {}

  void split(std::int64_t begin, std::int64_t end, std::uint32_t node, int depth, double (&low)[2],
             double (&high)[2]) noexcept {
    if (depth == room_.levels) {
      const std::uint32_t cell = node - ((std::uint32_t{1} << room_.levels) - 1);
      room_.frame[cell] = frame_of(begin, end, low, high);
      room_.cell[cell] = cell_of(room_.frame[cell]);
      return;
    }
    int axis;
    double cut;
    choose_cut(begin, end, low, high, axis, cut);
    cut = with_axis(cut, axis);
    room_.node[node] = cut;
    const std::int64_t middle = part(begin, end, axis, cut);
    const double was_low = low[axis], was_high = high[axis];
    high[axis] = most(was_low, least(was_high, cut));
    split(begin, middle, 2 * node + 1, depth + 1, low, high);
    high[axis] = was_high;
    low[axis] = least(was_high, most(was_low, cut));
    split(middle, end, 2 * node + 2, depth + 1, low, high);
    low[axis] = was_low;
  }

 private:
  /// More samples than this are represented by every few of them.
  static constexpr std::int64_t many = 2048, few = 512;

  /// The samples begin, begin + step, ..., `count` of them.
  struct Stretch {
    std::int64_t begin, length, count;
    std::int64_t at(std::int64_t i) const noexcept { return begin + i * length / count; }
  };
  static Stretch stretch(std::int64_t begin, std::int64_t end, std::int64_t at_most) noexcept {
    const std::int64_t n = end - begin;
    return {begin, n, n > many ? at_most : n};
  }

  /// Across the axis with the larger range of centres over mean extent, so that cells take the shapes' aspect; 5% of
  /// both extents let thin shapes count as thicker. At the median.
  void choose_cut(std::int64_t begin, std::int64_t end, const double (&low)[2], const double (&high)[2], int& axis,
                  double& cut) noexcept {
    if (end - begin < 2) {
      axis = high[1] - low[1] > high[0] - low[0];
      cut = low[axis] * 0.5 + high[axis] * 0.5;
      return;
    }
    double lowest[2] = {infinity, infinity}, highest[2] = {-infinity, -infinity}, extent[2] = {0, 0};
    const Stretch s = stretch(begin, end, few);
    for (std::int64_t i = 0; i < s.count; ++i) {
      const Sample& x = sample_[s.at(i)];
      for (int a = 0; a < 2; ++a) {
        lowest[a] = least(lowest[a], x.centre[a]);
        highest[a] = most(highest[a], x.centre[a]);
        extent[a] += x.extent[a] * (1.0 / static_cast<double>(s.count));
      }
    }
    const double both = extent[0] + extent[1];
    double worth[2];
    for (int a = 0; a < 2; ++a) {
      worth[a] = (highest[a] - lowest[a]) / (both > 0 ? extent[a] + 0.05 * both : 1);
    }
    axis = worth[1] > worth[0];
    for (std::int64_t i = 0; i < s.count; ++i) value_[i] = sample_[s.at(i)].centre[axis];
    cut = nth(value_, s.count, s.count / 2);
  }

  /// Stable, so that what is taken of every few is the same everywhere. Returns where the upper part begins.
  std::int64_t part(std::int64_t begin, std::int64_t end, int axis, double cut) noexcept {
    std::int64_t lower = begin, upper = 0;
    for (std::int64_t i = begin; i < end; ++i) {
      const Sample s = sample_[i];
      const bool below = s.centre[axis] < cut;
      sample_[lower] = s;
      spare_[upper] = s;
      lower += static_cast<std::int64_t>(below);
      upper += static_cast<std::int64_t>(!below);
    }
    for (std::int64_t i = 0; i < upper; ++i) sample_[lower + i] = spare_[i];
    return lower;
  }

  static double longer(const Sample& s) noexcept { return most(s.extent[0], s.extent[1]); }

  /// Copies one number of each sample that is not longer than a limit; returns how many.
  template <class Number>
  std::int64_t collect(const Stretch& s, double limit, Number number) noexcept {
    std::int64_t n = 0;
    for (std::int64_t i = 0; i < s.count; ++i) {
      const Sample& x = sample_[s.at(i)];
      if (longer(x) <= limit) value_[n++] = number(x);
    }
    return n;
  }

  /// Centre and width of the middle three quarters of centres, at most the cell's, at least twice the median extent.
  /// The full cell would not do: cells on the rim of a dense cluster reach far out.
  void estimate(const Stretch& s, double limit, double (&centre)[2], double (&width)[2]) noexcept {
    for (int a = 0; a < 2; ++a) {
      const std::int64_t n = collect(s, limit, [a](const Sample& x) { return x.centre[a]; });
      if (n < 4) continue;
      const double low = nth(value_, n, n / 8), high = nth(value_, n, n - 1 - n / 8);
      collect(s, limit, [a](const Sample& x) { return x.extent[a]; });
      const double extent = nth(value_, n, n / 2);
      width[a] = most(least(width[a], (high - low) * 1.75), 2 * extent);
      centre[a] = low * 0.5 + high * 0.5;
    }
  }

  Frame frame_of(std::int64_t begin, std::int64_t end, const double (&low)[2], const double (&high)[2]) noexcept {
    double centre[2], width[2];
    for (int a = 0; a < 2; ++a) {
      centre[a] = low[a] * 0.5 + high[a] * 0.5;
      width[a] = high[a] - low[a];
    }
    const Stretch s = stretch(begin, end, many);
    estimate(s, infinity, centre, width);
    if (s.count >= 8) {
      // Two scales in one cell: where one column is coarser than 1/16 of the smaller shapes, these alone count.
      const std::int64_t n = collect(s, infinity, [](const Sample& x) { return longer(x); });
      const double small = nth(value_, n, n / 8);
      if (small > 0 && most(width[0], width[1]) * 2 > small * 4096) estimate(s, 8 * small, centre, width);
    }
    return frame_about(centre, width);
  }

  Sample *sample_, *spare_;
  PlanRoom room_;
  double value_[many];
};

}  // namespace

Cell cell_of(const Frame& frame) noexcept {
  Cell cell;
  for (int a = 0; a < 2; ++a) {
    cell.scale[a] = power_of_two(-frame.p[a]);
    cell.k[a] = static_cast<double>(frame.k[a]);
  }
  return cell;
}

Frame frame_around(const double (&box)[4]) noexcept {
  double centre[2], width[2];
  for (int a = 0; a < 2; ++a) {
    centre[a] = box[a] * 0.5 + box[a + 2] * 0.5;
    width[a] = (box[a + 2] * 0.5 - box[a] * 0.5) * (1 + 0x1p-8);
    if (!(width[a] <= 0x1p1023)) return {{universal_k, universal_k}, {greatest_p, greatest_p}};
  }
  return frame_about(centre, width);
}

void make_plan(Sample* sample, Sample* spare, std::int64_t n, const PlanRoom& room) noexcept {
  double low[2] = {infinity, infinity}, high[2] = {-infinity, -infinity};
  for (std::int64_t i = 0; i < n; ++i) {
    for (int a = 0; a < 2; ++a) {
      low[a] = least(low[a], sample[i].centre[a]);
      high[a] = most(high[a], sample[i].centre[a]);
    }
  }
  if (n == 0) low[0] = low[1] = high[0] = high[1] = 0;
  Planner(sample, spare, room).split(0, n, 0, 0, low, high);
}

}  // namespace vesica::index
