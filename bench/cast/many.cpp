// SPDX-License-Identifier: Apache-2.0
/// vesica_cast_many beside a loop of single calls by kind, on arrays of records. Both meet pairs that they have not
/// seen, in the same buffers, and who goes first takes turns.
#include <vesica.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "cast/pairs.hpp"
#include "quantile.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t pairs_per_pass = 1024;
constexpr int passes = 40;

struct F64 {
  using T = double;
  using Shapes = vesica_shapes_f64;
  using Impact = vesica_impact_f64;
  static constexpr const char* name = "f64";
  static constexpr auto cast = vesica_cast_f64;
  static constexpr auto many = vesica_cast_many_f64;
  static constexpr auto from_records = vesica_shapes_from_records_f64;
};
struct F32 {
  using T = float;
  using Shapes = vesica_shapes_f32;
  using Impact = vesica_impact_f32;
  static constexpr const char* name = "f32";
  static constexpr auto cast = vesica_cast_f32;
  static constexpr auto many = vesica_cast_many_f32;
  static constexpr auto from_records = vesica_shapes_from_records_f32;
};

/// Pairs as records of as many numbers as the kinds have, velocities as records of two, and answers as columns.
template <class Face>
class Arrays {
 public:
  using T = typename Face::T;

  Arrays(std::int32_t kind_a, std::int32_t kind_b)
      : kind_a_(kind_a), kind_b_(kind_b), a_(pairs_per_pass * fields(kind_a)), b_(pairs_per_pass * fields(kind_b)) {}

  void draw(const Aim& aim, Random& random) {
    for (std::size_t i = 0; i < pairs_per_pass; ++i) {
      const Pair p = draw_pair(kind_a_, kind_b_, aim, random);
      write(p.a, a_, i * fields(kind_a_), fields(kind_a_));
      write(p.b, b_, i * fields(kind_b_), fields(kind_b_));
      v_[i] = {static_cast<T>(p.vx), static_cast<T>(p.vy)};
    }
  }
  std::int64_t ask_many() {
    typename Face::Shapes a, b;
    Face::from_records(kind_a_, pairs_per_pass, a_.data(), static_cast<std::ptrdiff_t>(fields(kind_a_) * sizeof(T)),
                       &a);
    Face::from_records(kind_b_, pairs_per_pass, b_.data(), static_cast<std::ptrdiff_t>(fields(kind_b_) * sizeof(T)),
                       &b);
    return Face::many(&a, &b, &v_[0][0], &v_[0][1], sizeof v_[0], 1, out_[0].data(), out_[1].data(), out_[2].data(),
                      out_[3].data(), out_[4].data());
  }
  std::int64_t ask_single() {
    std::int64_t hits = 0;
    for (std::size_t i = 0; i < pairs_per_pass; ++i) {
      typename Face::Impact out;
      hits += Face::cast(kind_a_, &a_[i * fields(kind_a_)], kind_b_, &b_[i * fields(kind_b_)], v_[i][0], v_[i][1], 1,
                         &out) > 0;
      const T numbers[] = {out.t, out.x, out.y, out.nx, out.ny};
      for (std::size_t k = 0; k < 5; ++k) out_[k][i] = numbers[k];
    }
    return hits;
  }

 private:
  std::int32_t kind_a_, kind_b_;
  std::vector<T> a_, b_;
  std::array<std::array<T, 2>, pairs_per_pass> v_;
  std::array<std::array<T, pairs_per_pass>, 5> out_;

  static std::size_t fields(std::int32_t kind) { return static_cast<std::size_t>(vesica_field_count(kind)); }
  static void write(const Numbers& from, std::vector<T>& to, std::size_t begin, std::size_t n) {
    for (std::size_t k = 0; k < n; ++k) to[begin + k] = static_cast<T>(from[k]);
  }
};

template <class Call>
double nanoseconds(const Call& call, std::int64_t& sum) {
  const Clock::time_point start = Clock::now();
  sum += call();
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / pairs_per_pass;
}

/// Only of pairs whose names have the part `wanted`.
template <class Face>
void contest(std::int32_t kind_a, std::int32_t kind_b, const Aim& aim, const std::string& wanted) {
  static Random random(4321);
  const std::string name =
      std::string(vesica_kind_name(kind_a)) + '_' + vesica_kind_name(kind_b) + ' ' + Face::name + ", " + aim.name;
  if (name.find(wanted) == std::string::npos) return;
  Arrays<Face> arrays(kind_a, kind_b);
  std::vector<double> many, single, ratio;
  std::int64_t hits = 0, others = 0;
  for (int pass = 0; pass < passes; ++pass) {
    double of_many = 0, of_single = 0;
    for (int k = 0; k < 2; ++k) {
      arrays.draw(aim, random);
      if ((pass + k) % 2 == 0) {
        of_many = nanoseconds([&] { return arrays.ask_many(); }, hits);
      } else {
        of_single = nanoseconds([&] { return arrays.ask_single(); }, others);
      }
    }
    many.push_back(of_many);
    single.push_back(of_single);
    ratio.push_back(of_single / of_many);
  }
  std::printf("%-42s %5.0f%% %9.1f %9.1f %7.2f\n", name.c_str(),
              100 * static_cast<double>(hits + others) / (2.0 * static_cast<double>(pairs_per_pass) * passes),
              median(many), median(single), median(ratio));
}

/// Shapes with a core and a radius beside circles in their place.
template <class Face>
void beside_circles(std::int32_t kind_a, std::int32_t kind_b, const Aim& aim, const std::string& wanted) {
  static Random random(8765);
  const std::string name = std::string(vesica_kind_name(kind_a)) + '_' + vesica_kind_name(kind_b) + ' ' + Face::name +
                           ", " + aim.name + ", circles";
  if (name.find(wanted) == std::string::npos) return;
  const auto circle_for = [](std::int32_t kind) {
    return kind == VESICA_CAPSULE || kind == VESICA_ROUND_RECT ? VESICA_CIRCLE : kind;
  };
  // A rounded rectangle is a larger target than a circle: at this spread about as many are hit.
  const bool larger = kind_a == VESICA_ROUND_RECT || kind_b == VESICA_ROUND_RECT;
  const Aim wider{aim.name, 1.6 * aim.spread, 0};
  Arrays<Face> ours(kind_a, kind_b), circles(circle_for(kind_a), circle_for(kind_b));
  std::vector<double> times[2], ratios[2];
  std::int64_t hits = 0, others = 0;
  for (int pass = 0; pass < passes; ++pass) {
    for (const bool single : {false, true}) {
      const auto time_of = [&](Arrays<Face>& arrays, std::int64_t& sum) {
        arrays.draw(larger && &arrays == &ours ? wider : aim, random);
        return nanoseconds([&] { return single ? arrays.ask_single() : arrays.ask_many(); }, sum);
      };
      double of_ours = 0, of_circles = 0;
      if (pass % 2 == 0) of_ours = time_of(ours, hits);
      of_circles = time_of(circles, others);
      if (pass % 2 != 0) of_ours = time_of(ours, hits);
      times[single].push_back(of_ours);
      ratios[single].push_back(of_ours / of_circles);
    }
  }
  const double all = 2.0 * static_cast<double>(pairs_per_pass) * passes / 100;
  std::printf("%-42s %5.0f%% %8.0f%% %9.1f %7.2f %9.1f %7.2f\n", name.c_str(), static_cast<double>(hits) / all,
              static_cast<double>(others) / all, median(times[0]), median(ratios[0]), median(times[1]),
              median(ratios[1]));
}

bool is_round(std::int32_t kind) { return kind == VESICA_CIRCLE || kind == VESICA_ELLIPSE; }

/// A pair of kinds in one order; of a box and a round shape in both, for the point of contact is found otherwise.
bool is_asked(std::int32_t a, std::int32_t b) {
  if (a == VESICA_POINT) return is_round(b);
  return b == VESICA_POINT || a <= b || is_round(a) != is_round(b);
}

}  // namespace
}  // namespace vesica::bench

/// [part of a row's name]
int main(int argc, char** argv) {
  using namespace vesica::bench;
  std::printf(
      "Nanoseconds a pair, medians over passes on %d fresh pairs; ratio: the median over passes of the time of\n"
      "single calls to that of the array.\n\n%-42s %6s %9s %9s %7s\n",
      static_cast<int>(pairs_per_pass), "pair, workload", "hits", "array", "single", "ratio");
  const std::string wanted = argc > 1 ? argv[1] : "";
  constexpr std::int32_t kinds[] = {VESICA_POINT, VESICA_SEGMENT, VESICA_CIRCLE,
                                    VESICA_AABB,  VESICA_RECT,    VESICA_ELLIPSE};
  for (const std::int32_t b : kinds) {
    for (const std::int32_t a : kinds) {
      if (!is_asked(a, b)) continue;
      const bool ray = b == VESICA_POINT;
      for (const Aim& aim : {ray ? tenth : tenth_of_discs, ray ? half : half_of_discs, sure}) {
        contest<F64>(a, b, aim, wanted);
        contest<F32>(a, b, aim, wanted);
      }
    }
  }
  std::printf(
      "\nShapes with a radius and a core beside circles in their place, in one run: the median over passes of the "
      "ratio\n"
      "of their times, of arrays and of single calls.\n\n%-42s %6s %9s %9s %7s %9s %7s\n",
      "pair, workload", "hits", "circles'", "array", "ratio", "single", "ratio");
  constexpr std::array<std::int32_t, 2> pairs[] = {
      {VESICA_CAPSULE, VESICA_POINT},        {VESICA_POINT, VESICA_CAPSULE},   {VESICA_CIRCLE, VESICA_CAPSULE},
      {VESICA_CAPSULE, VESICA_CAPSULE},      {VESICA_RECT, VESICA_CAPSULE},    {VESICA_ELLIPSE, VESICA_CAPSULE},
      {VESICA_ROUND_RECT, VESICA_POINT},     {VESICA_ROUND_RECT, VESICA_AABB}, {VESICA_ROUND_RECT, VESICA_CAPSULE},
      {VESICA_ROUND_RECT, VESICA_ROUND_RECT}};
  for (const auto& [a, b] : pairs) {
    const bool ray = b == VESICA_POINT;
    for (const Aim& aim : {never, ray ? tenth : tenth_of_discs, ray ? half : half_of_discs, sure}) {
      beside_circles<F64>(a, b, aim, wanted);
      beside_circles<F32>(a, b, aim, wanted);
    }
  }
}
