// SPDX-License-Identifier: Apache-2.0
// How well times of contact are known from leading digits. One that is known less well is found by a slower way and is
// still right, and one that is known better has an error narrower than its proof, or a better proof, which is a reason
// to write other numbers here. The motions are the same everywhere, and nothing is fused.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vesica/cast.hpp>

#include "cast/motions.hpp"
#include "properties/generators.hpp"
#include "properties/pair.hpp"
#include "properties/shape_maker.hpp"

namespace {

namespace core = vesica::detail::cast;
using core::Body;
using core::ExactPair;
using core::WideTime;
using vesica::Kind;
using vesica::detail::crossings::Rough;

/// Fixed: the numbers below are of these motions.
constexpr std::uint64_t seed = 3;
constexpr int of_each_workload = 240;

Body body(int kind, const properties::Numbers& numbers) {
  Body b{static_cast<Kind>(kind), {}};
  for (std::size_t i = 0; i < 6; ++i) b.number[i] = numbers[i];
  return b;
}

/// Up to 200.
int bits_of(const Rough& x) {
  const double size = std::fabs(rounded(x.value));
  if (size == 0) return 0;
  return x.error == 0 ? 200 : std::clamp(std::ilogb(size) - std::ilogb(x.error), 0, 200);
}

/// Of some pairs whose line meets: how many there are; those of which each way tells the time, and the bits to which it
/// is known in all.
struct Known {
  std::array<int, 3> met{};  ///< pairs, those that graze, bits of the witness
  std::array<int, 2> usual{}, thin{};
  std::array<int, 2> exactly{};     ///< trials from exact coefficients: after contact, with a value
  std::array<int, 2> room{};        ///< for places at these times, and at all times between two
  std::array<int, 2> from_start{};  ///< trials by the cubic's difference from that at the start: known, with a value
  std::array<int, 4> trials{};      ///< of times about contact: known, after, with a value; bits by which that changed
  bool operator==(const Known&) const = default;
};
std::ostream& operator<<(std::ostream& out, const Known& k) {
  const auto print = [&out](const auto& numbers) {
    out << '{';
    for (std::size_t i = 0; i < numbers.size(); ++i) out << (i == 0 ? "" : ", ") << numbers[i];
    out << "}, ";
  };
  print(k.met);
  for (const auto& n : {k.usual, k.thin, k.exactly, k.room, k.from_start}) print(n);
  print(k.trials);
  return out;
}

void add(const WideTime& found, std::array<int, 2>& to) {
  to[0] += found.tells();
  to[1] += found.certain ? bits_of(found.time) : 0;
}

void ask_room(const ExactPair& pair, double t, Known& known) {
  if (!(t > 0x1p-900 && t < 0x1p900)) return;
  const core::PlaceBits places = pair.place_bits();
  for (const double part : {0x1p-90, 0x1p-30, 1.0, 0x1p30, 0x1p90}) {
    known.room[0] += places.have_room(t * part);
    known.room[1] += places.have_room(t, t * (part + 1));
  }
}

/// Trials at the time and a little before and after it.
void ask_trials(const ExactPair& pair, double t, Known& known) {
  const core::LeadingContact contact(pair);
  core::KnownCubic at_start;
  at_start.try_at(pair, 0);
  if (!(t > 0x1p-1000 && t < 0x1p1000)) return;
  int last = 0;
  for (const double part : {0.5, 1 - 0x1p-10, 1 - 0x1p-40, 1 + 0x1p-40, 1 + 0x1p-10, 2.0}) {
    const core::Trial trial = contact.at(t * part);
    known.trials[0] += trial.known;
    known.trials[1] += trial.after;
    known.trials[2] += trial.has_value;
    if (trial.has_value) {
      const int exponent = trial.value.exponent + std::ilogb(std::fabs(trial.value.value) + 0x1p-1000);
      if (last != 0) known.trials[3] += std::abs(exponent - last);
      last = exponent;
    }
    const core::Trial from_start = contact.at(t * part, at_start);
    known.from_start[0] += from_start.known;
    known.from_start[1] += from_start.has_value;
    if (pair.holds_place(t * part)) {
      core::KnownCubic cubic;
      const core::Trial again = cubic.try_at(pair, t * part);
      known.exactly[0] += again.after;
      known.exactly[1] += again.has_value;
    }
  }
}

void ask(const Body& a, const Body& b, const core::Motion& motion, Known& known) {
  const ExactPair pair(a, b, motion);
  if (pair.contact_at(0) != core::Contact::none) return;
  const core::LineMeeting line = core::exact_line(pair, motion.end);
  if (!line.meets || pair.line_misses()) return;
  ++known.met[0];
  known.met[1] += pair.line_grazes();
  known.met[2] += bits_of(pair.rough_witness());
  const WideTime usual = core::known_time(pair);
  add(usual, known.usual);
  const bool of_ellipses = !pair.line_grazes() && pair.of_ellipses();
  const double t = of_ellipses ? core::EllipseTrials(pair).floor(0, 0) : core::between(usual.time).least;
  ask_room(pair, t, known);
  if (!of_ellipses) return;
  add(core::wide_time_of_thin(pair, core::ByExtent(pair)), known.thin);
  ask_trials(pair, t, known);
}

/// All but in contact: from a contact the first shape, at 0, is moved away by 2^-10 to 2^-110, and the second moves
/// towards it again, or along the tangent; at any magnitude.
void ask_beside_contact(int kind_a, int kind_b, properties::Random& random, Known& known) {
  auto [pair, x, y] = properties::touching(kind_a, kind_b, random);
  const double away = std::ldexp(1, -random.integer(10, 110)), along = random.chance(0.5) ? 0 : random.integer(-9, 9);
  const double towards = random.chance(0.125) ? 0 : 1;
  const int of_lengths = random.integer(-400, 400), of_motion = random.integer(-200, 200);
  const properties::Vector to_zero{-pair.a[0], -pair.a[1]};
  pair.b = properties::moved(kind_b, pair.b, to_zero);
  pair.a = properties::moved(kind_a, properties::moved(kind_a, pair.a, to_zero), {-x * away, -y * away});
  pair.a = properties::scaled(kind_a, pair.a, of_lengths, random.chance(0.5));
  pair.b = properties::scaled(kind_b, pair.b, of_lengths, random.chance(0.5));
  const double vx = -towards * x - along * y, vy = -towards * y + along * x;
  ask(body(kind_a, pair.a), body(kind_b, pair.b), {std::ldexp(vx, of_motion), std::ldexp(vy, of_motion), 0x1p1000},
      known);
}

Known known(int kind_a, int kind_b) {
  properties::Random random(seed);
  Known result;
  for (int i = 0; i < of_each_workload; ++i) ask_beside_contact(kind_a, kind_b, random, result);
  for (const properties::Workload workload : properties::all_workloads) {
    for (int i = 0; i < of_each_workload; ++i) {
      const properties::Pair p = properties::draw(workload, kind_a, kind_b, properties::Scalar::f64, random);
      const cast_test::Motion m = cast_test::draw_motion(p, properties::Scalar::f64, random);
      if (!(std::fabs(m.vx) + std::fabs(m.vy) > 0)) continue;
      ask(body(p.kind_a, p.a), body(p.kind_b, p.b), {m.vx, m.vy, m.end}, result);
    }
  }
  return result;
}

struct Expected {
  const char* name;
  Kind a, b;
  Known known;
};

class PrecisionOfTimes : public testing::TestWithParam<Expected> {};

TEST_P(PrecisionOfTimes, IsAsTheErrorsSay) {
  const Expected& e = GetParam();
  EXPECT_EQ(known(static_cast<int>(e.a), static_cast<int>(e.b)), e.known);
}

constexpr Expected all_expected[] = {
    {"rect_aabb",
     Kind::rect,
     Kind::aabb,
     {{926, 28, 89289}, {926, 89788}, {0, 0}, {0, 0}, {4569, 4569}, {0, 0}, {0, 0, 0, 0}}},
    {"rect_rect",
     Kind::rect,
     Kind::rect,
     {{931, 15, 89965}, {931, 90296}, {0, 0}, {0, 0}, {4549, 4554}, {0, 0}, {0, 0, 0, 0}}},
    {"segment_ellipse",
     Kind::segment,
     Kind::ellipse,
     {{845, 27, 80554}, {845, 81433}, {0, 0}, {0, 0}, {4107, 4107}, {0, 0}, {0, 0, 0, 0}}},
    {"rect_circle",
     Kind::rect,
     Kind::circle,
     {{965, 22, 92321}, {965, 92799}, {0, 0}, {0, 0}, {4752, 4754}, {0, 0}, {0, 0, 0, 0}}},
    {"rect_ellipse",
     Kind::rect,
     Kind::ellipse,
     {{992, 8, 94707}, {992, 95511}, {0, 0}, {0, 0}, {4827, 4834}, {0, 0}, {0, 0, 0, 0}}},
    {"circle_circle",
     Kind::circle,
     Kind::circle,
     {{1032, 16, 97883},
      {1032, 99573},
      {78, 9382},
      {2579, 4679},
      {5074, 5074},
      {5292, 5292},
      {5322, 2579, 5322, 85056}}},
    {"ellipse_circle",
     Kind::ellipse,
     Kind::circle,
     {{1013, 9, 96046},
      {258, 24778},
      {89, 10481},
      {2276, 4362},
      {4972, 4974},
      {4826, 4826},
      {4854, 2273, 4854, 83039}}},
    {"ellipse_ellipse",
     Kind::ellipse,
     Kind::ellipse,
     {{1046, 5, 99288}, {259, 24915}, {83, 9816}, {2324, 4511}, {5137, 5144}, {4980, 4980}, {5004, 2324, 5004, 84849}}},
};

INSTANTIATE_TEST_SUITE_P(Kinds, PrecisionOfTimes, testing::ValuesIn(all_expected),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
