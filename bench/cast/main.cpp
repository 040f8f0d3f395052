// SPDX-License-Identifier: Apache-2.0
/// Casts through the shared library, by kind and typed, and inlined from the header, beside textbook rays that are
/// inlined and check nothing, and beside Box2D; then a ray through an index of a million shapes. Each contestant meets
/// pairs that it has not seen, in the same buffers, and who goes first takes turns.
#include <vesica.h>

#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <vector>
#include <vesica/cast.hpp>

#include "cast/pairs.hpp"
#include "cast/peer.hpp"
#include "quantile.hpp"
#include "random.hpp"
#include "shapes.hpp"
#include "textbook/rays.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t pairs_per_pass = 256;
constexpr int passes = 300;

template <class Call>
double nanoseconds(const Call& call, std::int64_t& sum) {
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < pairs_per_pass; ++i) sum += call(i);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / pairs_per_pass;
}

std::int32_t library_cast(std::int32_t kind_a, std::int32_t kind_b, const Pair& p) {
  vesica_impact_f64 out;
  return vesica_cast_f64(kind_a, p.a.data(), kind_b, p.b.data(), p.vx, p.vy, 1, &out);
}

/// Any answer but VESICA_CAST_MISS counts as a hit. 0.005 is the distance that Box2D keeps.
std::int32_t library_impact(std::int32_t kind_a, std::int32_t kind_b, const Pair& p) {
  const vesica_turn_f64 still{0, 0, 0}, turn{p.vx, p.vy, p.angle};
  vesica_impact_f64 out;
  double gap;
  return vesica_impact_time_f64(kind_a, p.a.data(), &still, kind_b, p.b.data(), &turn, 0.005, &out, &gap);
}

struct Contest {
  std::string name;
  std::vector<double> library, other, ratio;
  std::int64_t hits = 0, wrong = 0;

  void print() const {
    const double all = static_cast<double>(pairs_per_pass) * passes;
    std::printf("%-42s %5.0f%% %9.0f", name.c_str(), 100 * static_cast<double>(hits) / all, median(library));
    if (other.empty()) {
      std::printf("\n");
    } else {
      std::printf(" %9.0f %7.2f %11.4f%%\n", median(other), median(ratio), 100 * static_cast<double>(wrong) / all);
    }
  }
};

/// load() makes the pairs of a pass ready for the other contestant, and other(i) asks it.
template <class Ours, class Load, class Other>
void contest(const std::string& name, std::int32_t kind_a, std::int32_t kind_b, const Aim& aim, const Ours& ours,
             bool has_other, const Load& load, const Other& other) {
  Contest c{name + ", " + aim.name, {}, {}, {}};
  Random random(1234);
  std::vector<Pair> pairs(pairs_per_pass);
  std::int64_t sum = 0;
  for (int pass = 0; pass < passes; ++pass) {
    double library = 0, theirs = 0;
    for (int k = 0; k < 2; ++k) {
      for (Pair& p : pairs) p = draw_pair(kind_a, kind_b, aim, random);
      if ((pass + k) % 2 == 0) {
        library = nanoseconds([&](std::size_t i) { return ours(kind_a, kind_b, pairs[i]); }, sum);
      } else if (has_other) {
        load(pairs);
        theirs = nanoseconds([&](std::size_t i) { return other(pairs[i], i); }, sum);
      }
    }
    if (has_other) load(pairs);
    for (std::size_t i = 0; i < pairs_per_pass; ++i) {
      const std::int32_t answer = ours(kind_a, kind_b, pairs[i]);
      c.hits += answer != VESICA_CAST_MISS;
      // Either answer is right of what is only near.
      if (has_other && answer != VESICA_CAST_NEAR) c.wrong += other(pairs[i], i) != (answer != VESICA_CAST_MISS);
    }
    c.library.push_back(library);
    if (!has_other) continue;
    c.other.push_back(theirs);
    c.ratio.push_back(library / theirs);
  }
  volatile std::int64_t used = sum;
  static_cast<void>(used);
  c.print();
}

/// A typed function of the library, and the header's cast() of the same shapes.
template <class A, class B, auto typed>
std::int32_t typed_cast(std::int32_t, std::int32_t, const Pair& p) {
  const A a = to_shape<A>(p.a);
  const B b = to_shape<B>(p.b);
  vesica_impact_f64 out;
  return typed(&a, &b, p.vx, p.vy, 1, &out);
}
template <class A, class B, template <class> class CoreA, template <class> class CoreB>
std::int32_t header_cast(std::int32_t, std::int32_t, const Pair& p) {
  Impact<double> out;
  return cast_or_error(std::bit_cast<CoreA<double>>(to_shape<A>(p.a)), std::bit_cast<CoreB<double>>(to_shape<B>(p.b)),
                       p.vx, p.vy, 1.0, out);
}

template <class A, class B, auto typed, template <class> class CoreA, template <class> class CoreB>
void rays(const Aim& aim) {
  const auto load = [](const std::vector<Pair>&) {};
  const auto other = [](const Pair& p, std::size_t) {
    return textbook::ray(to_shape<A>(p.a), to_shape<B>(p.b), p.vx, p.vy, 1) <= 1;
  };
  const std::string name = std::string(vesica_kind_name(kind_of<A>)) + '_' + vesica_kind_name(kind_of<B>);
  contest(name + " / textbook", kind_of<A>, kind_of<B>, aim, library_cast, true, load, other);
  contest(name + " typed", kind_of<A>, kind_of<B>, aim, typed_cast<A, B, typed>, true, load, other);
  contest(name + " header", kind_of<A>, kind_of<B>, aim, header_cast<A, B, CoreA, CoreB>, true, load, other);
}
#define VESICA_RAYS(a, A, b, B) rays<vesica_##a##_f64, vesica_##b##_f64, vesica_cast_##a##_##b##_f64, A, B>

template <class Ours>
void alone(std::int32_t kind_a, std::int32_t kind_b, const Aim& aim, const Ours& ours) {
  const std::string name = std::string(vesica_kind_name(kind_a)) + '_' + vesica_kind_name(kind_b);
  contest(
      name, kind_a, kind_b, aim, ours, false, [](const auto&) {}, [](const Pair&, std::size_t) { return false; });
}

void beside_box2d([[maybe_unused]] const Aim& aim) {
#ifdef VESICA_HAS_BOX2D
  Box2dCasts box2d;
  const auto load = [&](const std::vector<Pair>& pairs) {
    box2d.clear();
    for (const Pair& p : pairs) {
      box2d.add(to_shape<vesica_rect_f64>(p.a), to_shape<vesica_rect_f64>(p.b), p.vx, p.vy, p.angle);
    }
  };
  const auto shape_cast = [&](const Pair&, std::size_t i) { return box2d.shape_cast(i); };
  const auto time_of_impact = [&](const Pair&, std::size_t i) { return box2d.time_of_impact(i); };
  if (aim.spin > 0) {
    contest("rect_rect / b2TimeOfImpact", VESICA_RECT, VESICA_RECT, aim, library_impact, true, load, time_of_impact);
  } else {
    contest("rect_rect / b2ShapeCast", VESICA_RECT, VESICA_RECT, aim, library_cast, true, load, shape_cast);
    contest("rect_rect / b2TimeOfImpact", VESICA_RECT, VESICA_RECT, aim, library_cast, true, load, time_of_impact);
  }
#endif
}

/// A million circles that cover a tenth of a square, and their index.
class Circles {
 public:
  static constexpr std::int64_t n = 1'000'000;

  explicit Circles(Random& random) : random_(random) {
    for (auto& c : circles_) c = {random_.between(0, 1000), random_.between(0, 1000), random_.between(0.01, 0.3)};
    vesica_shapes_from_records_f64(VESICA_CIRCLE, n, circles_.data(), sizeof circles_[0], &set_);
    const std::int64_t size = vesica_index_size(n), scratch_size = vesica_index_scratch(n);
    index_ = bytes(size);
    const Bytes scratch = bytes(scratch_size);
    vesica_index_build_f64(&set_, 1, index_.get(), size, scratch.get(), scratch_size);
  }

  void first_of_rays() {
    std::vector<double> times;
    std::int64_t hits = 0;
    constexpr int rays = 20000;
    for (int i = 0; i < rays; ++i) {
      const double point[2] = {random_.between(0, 1000), random_.between(0, 1000)}, angle = random_angle();
      vesica_shapes_f64 one;
      vesica_shapes_from_records_f64(VESICA_POINT, 1, point, 0, &one);
      vesica_impact_f64 out;
      const Clock::time_point start = Clock::now();
      const std::int64_t first =
          vesica_index_cast_first_f64(index_.get(), &set_, 1, &one, std::cos(angle), std::sin(angle), infinity, &out);
      times.push_back(since(start));
      hits += first < n;
    }
    std::printf("\none ray at %lld circles by an index: %.2f us (median of %d), %.0f%% hit\n",
                static_cast<long long>(n), median(times) * 1e-3, rays, 100.0 * static_cast<double>(hits) / rays);
  }

  /// All shapes that a rectangle touches on its way, beside one call for each if they were known before.
  void all_on_ways() {
    std::vector<double> times, ratios;
    std::int64_t met = 0;
    constexpr int ways = 2000;
    std::vector<std::int64_t> out(10000);
    for (int i = 0; i < ways; ++i) {
      const double turn = random_angle(), angle = random_angle(), vx = std::cos(angle), vy = std::sin(angle);
      const double rect[6] = {
          random_.between(0, 1000), random_.between(0, 1000), std::cos(turn), std::sin(turn), 1, 0.5};
      vesica_shapes_f64 one;
      vesica_shapes_from_records_f64(VESICA_RECT, 1, rect, 0, &one);
      std::int64_t state[4] = {};
      const Clock::time_point start = Clock::now();
      const std::int64_t found = vesica_index_cast_f64(index_.get(), &set_, 1, &one, vx, vy, 100, out.data(),
                                                       static_cast<std::int64_t>(out.size()), state);
      const double by_index = since(start);
      if (found <= 0) continue;
      vesica_impact_f64 impact;
      const Clock::time_point again = Clock::now();
      for (std::int64_t k = 0; k < found; ++k) {
        const double* const circle = &circles_[static_cast<std::size_t>(out[static_cast<std::size_t>(k)])].cx;
        vesica_cast_f64(VESICA_CIRCLE, circle, VESICA_RECT, rect, vx, vy, 100, &impact);
      }
      ratios.push_back(by_index / since(again));
      times.push_back(by_index / static_cast<double>(found));
      met += found;
    }
    std::printf(
        "all that a rectangle meets on a way of 100: %.0f ns for each of %.0f (medians of %d), %.2f times as long "
        "as vesica_cast_f64 of these alone\n",
        median(times), static_cast<double>(met) / static_cast<double>(times.size()), ways, median(ratios));
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Free {
    void operator()(unsigned char* p) const { std::free(p); }
  };
  using Bytes = std::unique_ptr<unsigned char[], Free>;
  static Bytes bytes(std::int64_t size) {
    return Bytes(static_cast<unsigned char*>(std::aligned_alloc(64, static_cast<std::size_t>((size + 63) / 64 * 64))));
  }
  static double since(Clock::time_point start) {
    return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
  }
  double random_angle() { return random_.between(0, 6.283185307); }

  Random& random_;
  std::vector<vesica_circle_f64> circles_ = std::vector<vesica_circle_f64>(static_cast<std::size_t>(n));
  vesica_shapes_f64 set_;
  Bytes index_;
};

void through_an_index() {
  Random random(99);
  Circles circles(random);
  circles.first_of_rays();
  circles.all_on_ways();
}

}  // namespace
}  // namespace vesica::bench

int main() {
  using namespace vesica::bench;
  std::printf(
      "Nanoseconds a call by kind through the shared library, medians over passes on fresh pairs; ratio: the median "
      "over\n"
      "passes of the library's time to the other's; wrong: answers of the other that are not right.\n\n"
      "%-42s %6s %9s %9s %7s %12s\n",
      "pair / other, workload", "hits", "vesica", "other", "ratio", "wrong");
  for (const Aim& aim : {tenth, half}) {
    VESICA_RAYS(circle, vesica::Circle, point, vesica::Point)(aim);
    VESICA_RAYS(aabb, vesica::Aabb, point, vesica::Point)(aim);
    VESICA_RAYS(rect, vesica::Rect, point, vesica::Point)(aim);
    VESICA_RAYS(ellipse, vesica::Ellipse, point, vesica::Point)(aim);
  }
  for (const Aim& aim : {tenth_of_discs, half_of_discs}) {
    VESICA_RAYS(circle, vesica::Circle, circle, vesica::Circle)(aim);
  }
  for (const Aim& aim : {any, towards}) {
    beside_box2d(aim);
    alone(VESICA_RECT, VESICA_ELLIPSE, aim, library_cast);
    alone(VESICA_ELLIPSE, VESICA_ELLIPSE, aim, library_cast);
  }
  alone(VESICA_RECT, VESICA_ELLIPSE, sure, library_cast);
  alone(VESICA_ELLIPSE, VESICA_ELLIPSE, sure, library_cast);
  for (const Aim& aim :
       {Aim{"1e-3 inside", 0, -1e-3}, Aim{"1e-3 outside", 0, 1e-3}, Aim{"1e-9 inside", 0, -1e-9},
        Aim{"1e-9 outside", 0, 1e-9}, Aim{"1e-15 inside", 0, -1e-15}, Aim{"1e-15 outside", 0, 1e-15}}) {
    beside_box2d(aim);
  }
  std::printf("\nvesica_impact_time: b turns too, within 0.005\n");
  for (const Aim& aim : {Aim{"few hits, to 1 rad", 0, 0, 1}, Aim{"few hits, to 6.3 rad", 0, 0, 6.3},
                         Aim{"few hits, to 40 rad", 0, 0, 40}, Aim{"aimed, to 1 rad", 2.2, 0, 1},
                         Aim{"aimed, to 6.3 rad", 2.2, 0, 6.3}, Aim{"aimed, to 40 rad", 2.2, 0, 40}}) {
    beside_box2d(aim);
    alone(VESICA_RECT, VESICA_ELLIPSE, aim, library_impact);
    alone(VESICA_ELLIPSE, VESICA_ELLIPSE, aim, library_impact);
  }
  through_an_index();
}
