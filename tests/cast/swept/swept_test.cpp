// SPDX-License-Identifier: Apache-2.0
/// Hit, miss or start, and the time to the bit, against the oracle of this folder. VESICA_REPEAT=1000 asks a million
/// cases of each pair of kinds in each scalar type.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include "cast/swept/cases.hpp"
#include "cast/swept/contact.hpp"
#include "properties/pairs_of_kinds.hpp"

namespace {

using namespace cast_test;
using properties::Kinds;
using swept::Case;
using swept::Class;

Case exchanged(const Case& c) {
  Case other = c;
  other.pair = properties::swapped(c.pair);
  other.motion = {0 - c.motion.vx, 0 - c.motion.vy, c.motion.end};
  return other;
}

double next(Scalar scalar, double t) { return properties::at_ordinal(scalar, properties::ordinal(scalar, t) + 1); }
double previous(Scalar scalar, double t) { return properties::at_ordinal(scalar, properties::ordinal(scalar, t) - 1); }

bool has_no_area(int kind, const Numbers& n) {
  return kind != VESICA_POINT && kind != VESICA_SEGMENT && !properties::has_area(kind, n);
}

class Swept : public testing::TestWithParam<Kinds> {
 protected:
  Scalar scalar() const { return GetParam().scalar; }

  void expect(bool right, const char* what, const Case& c, const Answer& r) {
    if (right) return;
    // The first few suffice.
    if (++wrong_ <= 5)
      ADD_FAILURE() << what << ": " << r.code << ' ' << std::hexfloat << r.t << '\n' << describe(c.pair, c.motion);
  }

  /// An end at the time, and the numbers beside it.
  void check_ends(const Case& c, const Answer& r, const swept::Scene& scene, const swept::Contact& contact) {
    const auto until = [&](double end) {
      Case sooner = c;
      sooner.motion.end = end;
      ++asked_;
      return cast(scalar(), sooner.pair, sooner.motion);
    };
    if (r.t > 0) expect(until(previous(scalar(), r.t)).code == VESICA_CAST_MISS, "ends before the time", c, r);
    const Answer at = until(r.t), after = until(next(scalar(), r.t));
    const bool is_hit = contact.by(scene.time(r.t));
    expect(at.code == (is_hit ? VESICA_CAST_HIT : VESICA_CAST_MISS), "ends at the time", c, at);
    expect(after.code == VESICA_CAST_HIT && after.t == r.t, "ends after the time", c, after);
    exactly_at_a_number_ += is_hit;
  }

  void check(const Case& c, properties::Random& random) {
    const swept::Scene scene(c.pair, c.motion.vx, c.motion.vy);
    const std::unique_ptr<swept::Contact> contact = swept::contact(scene);
    const bool is_still = c.motion.vx == 0 && c.motion.vy == 0;
    const bool starts = contact->by(scene.time(0)),
               touches = starts || (!is_still && contact->by(scene.time(c.motion.end)));
    const Answer r = cast(scalar(), c.pair, c.motion);
    const Case other = exchanged(c);
    const Answer s = cast(scalar(), other.pair, other.motion);
    asked_ += 2;
    const int wanted = starts ? VESICA_CAST_START : touches ? VESICA_CAST_HIT : VESICA_CAST_MISS;
    ++answers_[static_cast<std::size_t>(wanted)];
    ++classes_[static_cast<std::size_t>(c.kind)];
    if (c.kind == Class::beside) ++beside_[static_cast<std::size_t>(wanted)];
    still_ += is_still;
    flat_ += has_no_area(c.pair.kind_a, c.pair.a) || has_no_area(c.pair.kind_b, c.pair.b);
    if (c.kind == Class::grazing || c.kind == Class::at_a_time) {
      expect(contact->by(scene.time(c.meeting)), "the oracle sees no contact where some was built", c, r);
    }
    expect(r.code == wanted, "answer", c, r);
    expect(s.code == wanted, "answer", other, s);
    if (wanted != VESICA_CAST_HIT || r.code != wanted || s.code != wanted) return;
    expect(r.t == s.t, "time of the exchanged pair", other, s);
    expect(r.t <= c.motion.end && contact->begins_between(scene.time(r.t), scene.time(next(scalar(), r.t))), "time", c,
           r);
    if (random.chance(0.2)) check_ends(c, r, scene, *contact);
  }

  std::int64_t asked_ = 0, wrong_ = 0, still_ = 0, flat_ = 0, exactly_at_a_number_ = 0;
  std::array<std::int64_t, 3> answers_{}, beside_{};
  std::array<std::int64_t, 5> classes_{};
};

TEST_P(Swept, AnswersAndTimes) {
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  const Kinds k = GetParam();
  const int pair = 2 * (properties::kinds_with_form * k.a + k.b) + (k.scalar == Scalar::f32);
  properties::Random random(properties::seed() + 71 + static_cast<std::uint64_t>(pair));
  const std::int64_t count = std::int64_t{1000} * properties::repeat();
  for (std::int64_t i = 0; i < count; ++i) {
    const bool in_order = random.chance(0.5);
    check(swept::draw(in_order ? k.a : k.b, in_order ? k.b : k.a, scalar(), random), random);
  }
  EXPECT_EQ(wrong_, 0);
  const auto print = [](long long x, const char* what) { std::printf("%lld %s, ", x, what); };
  std::printf("%s: ", to_string(k).c_str());
  print(count, "cases");
  print(asked_, "casts");
  print(answers_[VESICA_CAST_MISS], "misses");
  print(answers_[VESICA_CAST_HIT], "hits");
  print(answers_[VESICA_CAST_START], "starts");
  print(classes_[static_cast<std::size_t>(Class::grazing)], "built grazing");
  print(classes_[static_cast<std::size_t>(Class::beside)], "beside");
  print(classes_[static_cast<std::size_t>(Class::at_a_time)], "built for a time");
  print(classes_[static_cast<std::size_t>(Class::beside_a_time)], "beside");
  print(still_, "at rest");
  print(flat_, "degenerate");
  print(exactly_at_a_number_, "ends at a contact");
  std::printf("%lld wrong\n", static_cast<long long>(wrong_));
  if (!properties::draws_all()) return;
  for (const std::int64_t n : answers_) EXPECT_GT(n, 0);
  EXPECT_GT(beside_[VESICA_CAST_MISS], 0);
  EXPECT_GT(beside_[VESICA_CAST_HIT], 0);
}

INSTANTIATE_TEST_SUITE_P(Cast, Swept, testing::ValuesIn(properties::all_pairs_of_kinds(properties::kinds_with_form)),
                         properties::test_name);

}  // namespace
