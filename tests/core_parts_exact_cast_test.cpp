// SPDX-License-Identifier: Apache-2.0
// Exact numbers of cast at the ends of what they are defined for: places of more digits than there is room for, ties,
// and pairs that a caller would have passed elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vesica/vesica.hpp>

namespace {

using namespace vesica;
using namespace vesica::detail::cast;
using exact::from_double;
using vesica::detail::crossings::Rough;

constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();

double next(double x) { return std::nextafter(x, infinity); }
double before(double x) { return std::nextafter(x, -infinity); }

double value(const Rough& x) { return std::ldexp(rounded(x.value), x.exponent); }

/// A polynomial of so high a degree that is one number.
template <int Degree>
Number<Degree> number(double x) {
  if constexpr (Degree == 1) {
    return from_double(x);
  } else {
    return number<Degree - 1>(x) * from_double(1.0);
  }
}

ExactPair pair_of(const auto& a, const auto& b, double vx, double vy) {
  return {body(a), body(b), Motion{vx, vy, infinity}};
}

TEST(ExactCastParts, LessRoot) {
  Rough out;
  const auto less = [&](double x, double y) { return less_root(number<3>(x), number<6>(y), out); };
  EXPECT_FALSE(less(-3, 4) || less(0, 4) || less(1, 4) || less(2, 4));
  EXPECT_TRUE(less(3, 4));
  EXPECT_EQ(value(out), 1);
  EXPECT_TRUE(less(3, 0));
  EXPECT_EQ(value(out), 3);
}

/// Bits above the highest that has room, below the lowest, and both.
TEST(ExactCastParts, Window) {
  const auto place = [](double x, double y, double& ratio) {
    const Number<2> a = from_double(x) * from_double(x), b = from_double(y) * from_double(y);
    Window window;
    window.hold(a);
    window.hold(b);
    if (!window.place()) return false;
    const Rough p(window.moved(a)), q(window.moved(b));
    ratio = std::ldexp(rounded(p.value) / rounded(q.value), p.exponent - q.exponent);
    return true;
  };
  double ratio = 0;
  for (const double unit : {1.0, 0x1p400, 0x1p600, 0x1p1000, 0x1p-400, 0x1p-600, 0x1p-1000}) {
    EXPECT_TRUE(place(3 * unit, unit, ratio)) << unit;
    EXPECT_EQ(ratio, 9);
  }
  EXPECT_TRUE(place(0x1p500, 0x1p-500, ratio));
  EXPECT_FALSE(place(0x1p500, 0x1p-545, ratio));
  EXPECT_FALSE(place(0x1p1000, 0x1p-100, ratio));
}

/// Wherever its lowest bit is, what has room is moved to where there is: no bit comes above the highest or below the
/// lowest.
TEST(ExactCastParts, MovedIntoTheWindow) {
  for (const std::int64_t span : {std::int64_t{1}, std::int64_t{1000}, Window::widest}) {
    for (std::int64_t low = -1400; low < 1400 - span; ++low) {
      const auto bit = [](std::int64_t at) { return Number<2>(from_double(1.0, static_cast<int>(at))); };
      const Number<2> first = bit(low), last = bit(low + span - 1);
      Window window;
      window.hold(first);
      window.hold(last);
      ASSERT_EQ(window.top() - window.low(), span);
      ASSERT_TRUE(window.place()) << low;
      Window moved;
      moved.hold(window.moved(first));
      moved.hold(window.moved(last));
      ASSERT_EQ(moved.top() - moved.low(), span);
      ASSERT_GE(moved.low(), Window::lowest) << low;
      ASSERT_LE(moved.top(), Window::highest) << low;
      ASSERT_EQ(moved.low() - low, std::int64_t{64} * window.limbs());
    }
  }
}

TEST(ExactCastParts, HoldsPlaces) {
  const auto holds = [](double x, double v, double least, double most) {
    return pair_of(Point<double>{0, 0}, Circle<double>{x, 0, 1}, v, 0).place_bits().have_room(least, most);
  };
  EXPECT_TRUE(holds(1, -1, 1, 1));
  EXPECT_TRUE(holds(1, -1, 0x1p-500, 0x1p500));
  // Above the highest bit, but in the window when it is moved.
  EXPECT_TRUE(holds(0x1p100, -0x1p200, 0x1p900, 0x1p1000));
  EXPECT_TRUE(holds(0x1p-900, -0x1p-900, 0x1p-400, 1));
  // Too wide at the later time, at the earlier, and at both.
  EXPECT_FALSE(holds(0x1p-1000, -0x1p40, 1, largest));
  EXPECT_FALSE(holds(0x1p1000, -1, 0x1p-1070, 1));
  EXPECT_FALSE(holds(1, -1, 0x1p-1070, largest) && holds(0x1p-1000, -0x1p40, 0x1p-1070, largest));
  EXPECT_FALSE(holds(0x1p-1000, -0x1p40, 0x1p-1070, largest));
}

/// An ellipse about the origin that a corner passes, and a box.
struct Passing {
  Body a, b;
  double vx, vy;
  ExactBody round = exact_body(a), box = exact_body(b);
  Number<1> x = from_double(vx), y = from_double(vy), dx = box.box.cx, dy = box.box.cy;
  ExactReach reach{round, x, y};
  Passage passage{dx, dy, x, y};
  SeenEllipse ellipse{round, reach, passage};
  SeenBox seen{box, x, y};

  Passing(const Ellipse<double>& e, const Rect<double>& r, double v_x, double v_y)
      : a(body(e)), b(body(r)), vx(v_x), vy(v_y) {}
  WideTime corner(double at_x, double at_y) const { return ellipse.meets_corner(number<2>(at_x), number<2>(at_y)); }
  WideTime time(const Number<2>& w) const { return wide_time(seen, ellipse, w); }
  WideTime time() const { return time(x * dy - y * dx); }
};

TEST(ExactCastParts, CornersThatMeetAnEllipse) {
  const Passing p({0, 0, 1, 0, 2, 1}, {8, 0, 1, 0, 1, 1}, -1, 0);
  const WideTime met = p.corner(5, 0);
  EXPECT_TRUE(met.certain);
  EXPECT_EQ(value(met.time), 3);
  EXPECT_FALSE(p.corner(5, 2).certain) << "it passes beside";
  EXPECT_FALSE(p.corner(5, 1).certain) << "it grazes";
  EXPECT_FALSE(p.corner(-5, 0).certain) << "it has passed";
  EXPECT_FALSE(p.corner(0, 0.5).certain) << "it is beside the centre";
  EXPECT_FALSE(p.corner(1, 0).certain) << "it is inside";
  EXPECT_FALSE(p.corner(2, 0).certain) << "it is there";
}

TEST(ExactCastParts, WideTimesOfABoxAndAnEllipse) {
  const Ellipse<double> e{0, 0, 1, 0, 2, 1};
  // By a face, by a corner; and where it has passed, by a corner and by a face.
  const Passing face(e, {8, 0, 1, 0, 1, 1}, -1, 0), corner(e, {8, 1.5, 1, 0, 1, 1}, -1, -0x1p-10),
      passed(e, {-8, -1.75, 1, 0, 1, 1}, -1, -0x1p-10), inside(e, {1, 0, 1, 0, 1, 1}, -1, 0x1p-10);
  EXPECT_TRUE(face.time().certain);
  EXPECT_EQ(value(face.time().time), 5);
  EXPECT_TRUE(corner.time().certain);
  EXPECT_NEAR(value(corner.time().time), 5.26, 0.1);
  EXPECT_FALSE(passed.time().certain);
  EXPECT_FALSE(inside.time().certain);
  EXPECT_FALSE(wide_time(pair_of(e, Ellipse<double>{8, 0, 1, 0, 2, 1}, -1, 0)).certain);
  EXPECT_FALSE(wide_time(pair_of(e, Circle<double>{8, 0, 2}, -1, 0)).certain);
}

/// The line passes between a face and a corner but for 2^-60 to 2^-110: an exact sign tells which it is. Only the line
/// is moved, not the ellipse, so that the times of the two differ.
TEST(ExactCastParts, WideTimesBesideATie) {
  const Passing p({0, 0, 3, 4, 1, 0.5}, {8, 3, 1, 0, 1, 1}, -2, -1);
  // The box's two kinks: the normal, the jump there, and how far off it the other one counts.
  struct Kink {
    double nx, ny, own, other;
  };
  for (const Kink& k : {Kink{0, 1, 1, 2}, Kink{1, 0, 2, -1}}) {
    const auto support = p.ellipse.support(number<1>(k.nx), number<1>(k.ny));
    const Rough beside = Rough(support.beside) / root(Rough(support.squared));
    const auto part = [&](double x) { return number<2>(std::ldexp(x, beside.exponent)); };
    for (const double end : {k.own - k.other, -k.own - k.other}) {
      const auto ask = [&](double step) {
        const WideTime found =
            p.time(part(beside.value.high) + part(beside.value.low) + number<2>(step) + number<2>(end));
        return found.certain ? value(found.time) : -1;
      };
      const double far_before = ask(-0x1p-60), far_behind = ask(0x1p-60);
      EXPECT_EQ(ask(-0x1p-100), far_before) << end;
      EXPECT_EQ(ask(0x1p-100), far_behind) << end;
      // Where `beside` ends is below 2^-100: in between it changes once.
      double last = far_before;
      for (const double step : {-0x1p-104, -0x1p-106, -0x1p-110, 0.0, 0x1p-110, 0x1p-106, 0x1p-104}) {
        const double t = ask(step);
        EXPECT_TRUE(t == last || t == far_behind) << end << ' ' << step;
        last = t;
      }
      EXPECT_NE(far_before, far_behind) << end;
    }
  }
}

/// From the least double to beyond the largest. A place of more digits than there is room for is an error, where the
/// time is so near a double that whether there is contact before it must be asked.
TEST(ExactCastParts, FloorsOfTimes) {
  const auto floor = [](const auto& a, const auto& b, double vx, double vy) {
    const ExactPair pair = pair_of(a, b, vx, vy);
    const WideTime found = wide_time(pair);
    EXPECT_TRUE(found.certain);
    double t;
    const std::int32_t error = floor_of_time(pair, found.time, t);
    EXPECT_TRUE(error == 0 || error == error_range);
    return error == 0 ? t : -1;
  };
  const Aabb<double> box{-2, -1, 0, 1};
  EXPECT_EQ(floor(box, Point<double>{5, 0}, -1, 0), 5);
  EXPECT_EQ(floor(box, Point<double>{5, 0}, -0.75, 0), 5 / 0.75 - 0x1p-50) << "rounded down";
  EXPECT_EQ(floor(box, Point<double>{0x1p1000, 0}, -0x1p-19, 0), 0x1p1019);
  EXPECT_EQ(floor(box, Point<double>{0x1p1000, 0}, -0x1p-23, 0), 0x1p1023);
  EXPECT_EQ(floor(box, Point<double>{0x1p1000, 0}, -0x1p-30, 0), infinity);
  EXPECT_EQ(floor(box, Point<double>{0x1p-1000, 0}, -0x1p10, 0), 0x1p-1010);
  EXPECT_EQ(floor(box, Point<double>{0x1p-1000, 0}, -0x1p73, 0), 0x1p-1073);
  EXPECT_EQ(floor(box, Point<double>{0x1p-1000, 0}, -0x1.8p73, 0), 0x1p-1074) << "4/3 of it";
  EXPECT_EQ(floor(box, Point<double>{0x1p-1000, 0}, -0x1.8p74, 0), 0) << "2/3 of the least";
  // The time is a double, and the place at it spans 2^1000 to 2^-1076.
  const Aabb<double> far{-0x1p1000, -1, 0, 1};
  EXPECT_EQ(floor(far, Point<double>{0x1p1000, 0}, -0x1p1002, 0), 0.25);
  EXPECT_EQ(floor(far, Point<double>{0x1p1000, 0}, -0x1p1002, 0x1p-1074), -1);
  // The place at the time has room, and that at the next has not: it is not asked for.
  const Aabb<double> thin{-0x1p-1030, -0x1p990, 0, 0x1p990};
  EXPECT_EQ(floor(thin, Point<double>{0x1p-1030, 0x1p900}, -0x1p-1030, 0), 1);
  EXPECT_EQ(floor(thin, Point<double>{0x1p-1030, 0x1p989}, -0x1p-1030, 0), 1);
}

/// A search ends where it is answered with an error, and where there is nothing to be found up to the largest number.
TEST(ExactCastParts, SearchesThatFindNothing) {
  double out = 0;
  const auto searched = [&out](double from, std::int32_t there) {
    return search(
        1, [=](double t) { return t < from ? 0 : there; }, out);
  };
  EXPECT_EQ(searched(infinity, 1), error_range);
  EXPECT_EQ(searched(8, error_range), error_range);
  EXPECT_EQ(searched(8, 1), 0);
  EXPECT_EQ(out, 8);
}

/// Trials from any start and with any guess: contact of insides comes after t0, and the witness after that.
TEST(ExactCastParts, FloorByTrials) {
  const auto floor = [](double start, double t0, double guess = 0, Between witness = {largest, infinity}) {
    const auto ask = [t0](double t) { return Trial{true, t > t0}; };
    return TrialSearch(ask, Trial{true, false}).floor(start, witness, guess);
  };
  for (const double t0 : {0x1p-1074, 0x1p-1022, 0x1.8p-3, 1.0, before(2.0), 0x1.5555p100, before(0x1p1023)}) {
    for (const double start : {0x1p-1074, 1.0, next(t0), t0, largest}) EXPECT_EQ(floor(start, t0), t0) << start;
  }
  for (const double t0 : {0x1p-1074, 0x1.8p-3, before(2.0), 0x1.5555p100}) {
    for (const double guess : {0x1p-1074, 0x1p-900, t0, 16 * t0, 0x1p900, infinity}) EXPECT_EQ(floor(0, t0, guess), t0);
    EXPECT_EQ(floor(0, t0, 0, {t0, next(next(t0))}), t0);
    EXPECT_EQ(floor(0, t0, 0, {before(before(t0)), 2 * t0}), t0);
    EXPECT_EQ(floor(0, t0, 0, {1.5 * t0 + 0x1p-1073, 2 * t0 + 0x1p-1072}), t0);
    EXPECT_EQ(floor(0, t0, 0, {0x1p900, 0x1p901}), t0);
  }
  EXPECT_EQ(floor(0x1.8p1023, before(0x1.8p1023)), before(0x1.8p1023));
  EXPECT_EQ(floor(1, 0x1.8p1023), 0x1.8p1023);
  EXPECT_EQ(floor(1, largest), infinity);
}

/// Contact before all times that trials know: no other time is asked, and that by the fewest that halve the powers.
TEST(ExactCastParts, FloorBeforeAllTrials) {
  int asked = 0;
  const auto ask = [&asked](double t) {
    ++asked;
    EXPECT_GE(t, 0x1p-500);
    return Trial{true, true};
  };
  EXPECT_EQ(TrialSearch(ask, Trial{true, false}, 0x1p-500).floor(0, {largest, infinity}, 0), -1);
  EXPECT_EQ(asked, 12);
}

/// Trials that are known from some time on: the search ends where it asks one before that.
TEST(ExactCastParts, FloorWithoutTheFirstTrials) {
  const auto floor = [](double t0, double known) {
    const auto ask = [=](double t) { return Trial{t >= known, t > t0}; };
    return TrialSearch(ask, Trial{true, false}).floor(0, {largest, infinity}, 0);
  };
  EXPECT_EQ(floor(0x1p-450, 0x1p-400), -1);
  EXPECT_EQ(floor(0x1.8p-3, 0x1p-400), 0x1.8p-3);
  EXPECT_EQ(floor(largest, 0x1p-400), infinity);
  EXPECT_EQ(floor(0x1p-450, 0), 0x1p-450);
  EXPECT_EQ(floor(0, 0), 0);
}

/// At the time and after it there is room, and at the double before it, whose fraction is longer, there is none: the
/// search asks for it only if it begins there.
TEST(ExactCastParts, SearchBesideATimeWithoutRoom) {
  const Circle<double> disc{0x1p951, 0, 0x1p950};
  const ExactPair pair = pair_of(Point<double>{0, 0}, disc, -0x1p950, 0x1p-1034);
  ASSERT_TRUE(pair.holds_place(1) && pair.holds_place(next(1)) && !pair.holds_place(before(1)));
  EXPECT_EQ(repeat_search(pair, next(1), 1), 0);
  EXPECT_EQ(repeat_search(pair, before(1), 1), error_range);
}

/// Two ellipses whose contact rounds to a place of more digits than there is room for.
TEST(ExactCastParts, FloorOfEllipsesBeyondTheDigits) {
  const Circle<double> large{0, 0, 0x1p1000};
  const Ellipse<double> small{0x1p1001, 0, 1, 0, 0x1p-54, 0x1p-54};
  const auto floor = [&](double vy) {
    return EllipseTrials(pair_of(large, small, -0x1p1002, vy)).floor(next(0.25), 0);
  };
  EXPECT_EQ(floor(0), before(0.25));
  EXPECT_EQ(floor(0x1p-1074), -1);
  // At these ends there is room: whether there is contact by then is told, and the time, 5/16, is not.
  const Ellipse<double> farther{0x1.2p1001, 0, 1, 0, 0x1p-54, 0x1p-54};
  const ExactPair pair = pair_of(large, farther, -0x1p1002, 0x1p-1072);
  ASSERT_TRUE(pair.holds_place(0.25) && pair.holds_place(0.5) && !pair.holds_place(0.3125));
  ASSERT_GT(pair.witness_after(0.5), 0);
  ASSERT_EQ(EllipseTrials(pair).floor(next(0.3125), 0), -1);
  double t = 7;
  EXPECT_EQ(tried_floor(pair, 0.25, true, Start(0.3125), {}, t), 0);
  EXPECT_EQ(tried_floor(pair, 0.5, true, Start(0.3125), {}, t), error_range);
  EXPECT_EQ(tried_floor(pair, infinity, false, Start(0.3125), {}, t), error_range);
}

/// Contact so short that few digits tell of no double near it on which side of the witness that is.
TEST(ExactCastParts, TrialAfterTheBriefestContact) {
  const Ellipse<double> a{0, 0x1p-110, 1, 0, 1, 1}, b{8, 2, 0, 1, 1, 1};
  const ExactPair pair = pair_of(a, b, -1, 0);
  for (const double t : {before(8), 8.0, next(8)}) {
    EXPECT_EQ(pair.contact_at(t), t == 8 ? Contact::inside : Contact::none) << t;
    EllipseTrials trials(pair);
    EXPECT_EQ(trials.contact_before(t), t > 8 || pair.contact_before(t) == 1 ? 1 : 0) << t;
    EXPECT_EQ(EllipseTrials(pair).floor(t, 0), before(8)) << t;
  }
  // Between two doubles, and so near the second that its trial could be of a time before contact.
  const Ellipse<double> shifted{-0x1.fffffffffffffp-50, 0x1p-210, 1, 0, 1, 1};
  const ExactPair between_doubles = pair_of(shifted, b, -1, 0);
  ASSERT_LT(between_doubles.witness_after(next(8)), 0);
  for (const double t : {before(8), 8.0, next(8)}) {
    EXPECT_EQ(between_doubles.contact_at(t), Contact::none) << t;
    EXPECT_EQ(EllipseTrials(between_doubles).floor(t, 0), 8) << t;
  }
}

/// Times beside the witness, of which few digits do not tell on which side they are: after it no place is asked for,
/// which has more digits here than there is room for.
TEST(ExactCastParts, ContactBesideTheWitnessBeyondTheDigits) {
  const Circle<double> large{0, 0, 0x1p1000};
  const Ellipse<double> small{0x1.8p1000, 0, 0x1p1000, 0, 0x1p-54, 0x1p-54};
  for (const double vy : {-0x1p-1074, 0x1p-1074}) {
    const ExactPair pair = pair_of(large, small, -0x1p1001, vy);
    ASSERT_FALSE(pair.holds_place(0.75));
    EllipseTrials trials(pair);
    for (const double t : {0.25, before(0.75), 0.75, next(0.75), 1.0}) {
      EXPECT_EQ(trials.contact_before(t), pair.contact_before(t)) << t;
    }
  }
}

/// The cubic of two ellipses before they touch, where they do, of which its digits do not tell on which side that is,
/// and after it.
TEST(ExactCastParts, TrialAtTheTimeItself) {
  const Ellipse<double> a{0, 0, 1, 0, 1, 1}, b{8, 0, 0, 1, 1, 1};
  const ExactPair pair = pair_of(a, b, -1, 0);
  const LeadingContact contact(pair);
  const Trial no = contact.at(before(6)), at = contact.at(6), yes = contact.at(next(6));
  EXPECT_TRUE(no.known && !no.after && no.has_value && no.value.value > 0);
  EXPECT_FALSE(at.known);
  EXPECT_TRUE(yes.known && yes.after && yes.has_value && yes.value.value < 0);
  KnownCubic known;
  const Trial exactly = known.try_at(pair, 6);
  EXPECT_TRUE(exactly.known && !exactly.after && !exactly.has_value && known.has_discriminant);
  // One of 2^-90 beside one of 1: the first digits that are tried lose some of the others.
  const Circle<double> large{0, 0, 1}, small{1, 0, 0x1p-90};
  const Trial of_more = known.try_at(pair_of(large, small, 1, 0), 0x1p-90);
  EXPECT_TRUE(of_more.known && !of_more.after && !of_more.has_value);
}

/// A start in the middle of contact, where digits do not tell on which side of the witness it is.
TEST(ExactCastParts, TrialsFromTheWitness) {
  const Ellipse<double> a{0, 0, 1, 0, 1, 1}, b{8, 0, 0, 1, 1, 1};
  const ExactPair pair = pair_of(a, b, -1, 0);
  ASSERT_EQ(pair.witness_after(8), 0);
  EllipseTrials trials(pair);
  EXPECT_EQ(trials.floor(8, 0), 6);
  for (const double t : {0.0, 0x1p-1074, 6.0, next(6), 7.0, before(8), 8.0, next(8), largest}) {
    EXPECT_EQ(trials.contact_before(t), t > 6 ? 1 : 0) << t;
    EXPECT_EQ(EllipseTrials(pair).contact_before(t), t > 6 ? 1 : 0) << t;
  }
}

/// A disc that meets a thin ellipse flat on.
TEST(ExactCastParts, TimeOfAThinEllipseMetFlatOn) {
  const Ellipse<double> thin{0, 0, 0x1.8e0d53f198a59p-1, 0, 0x1.634ea5e9e2933p+2, 0x1.4p-270},
      disc{0x1.2911c0aa2a5a4p-4, 0x1.086c846440b3ep+3, 0x1.a19fe315b1be4p-1,
           0x1.817effc9499e2p-1, 0x1.26af17d2325dbp+0, 0x1.26af17d2325dbp+0};
  const ExactPair pair = pair_of(thin, disc, -0x1p-700, -0x1.e911739e24a04p-1);
  const double t = EllipseTrials(pair).floor(0, 0);
  EXPECT_EQ(pair.contact_before(t), 0);
  EXPECT_EQ(pair.contact_before(next(t)), 1);
}

/// The cubic at other times by how it differs from that at one: the same as from all digits, of long times too, and of
/// lengths so small that exact numbers are moved for places to have room.
TEST(ExactCastParts, TrialFromAKnownCubic) {
  const auto same = [](const Trial& x, const Trial& y) {
    return x.after == y.after && std::fabs(ratio(x.value, y.value) - 1) < 0x1p-50;
  };
  for (const double length : {1.0, 0x1p-1000}) {
    for (const double time : {1.0, 0x1p20}) {
      const Ellipse<double> a{0, 0, 1, 0, length, 2 * length}, b{8 * length, 0, 3, 4, 0.1 * length, 0.3 * length};
      const ExactPair pair = pair_of(a, b, -(1 - 0x1p-50) * length / time, 0);
      const LeadingContact contact(pair);
      KnownCubic from;
      ASSERT_TRUE(from.try_at(pair, (3 + 0x1p-40) * time).known && from.has_discriminant);
      for (const double t : {0.5, 1.0 + 0x1p-45, 2.5, 3 + 0x1p-40, 8.0}) {
        KnownCubic there;
        const Trial exactly = there.try_at(pair, t * time), trial = contact.at(t * time, from);
        ASSERT_TRUE(exactly.known && trial.known) << t;
        EXPECT_TRUE(exactly.has_value ? same(trial, exactly) : trial.after && exactly.after) << t;
      }
    }
  }
}

/// Where all leading digits of the cubic cancel, from the start on.
TEST(ExactCastParts, TrialBesideContactFromTheStart) {
  const Ellipse<double> a{-0x1.1414343f395eap+512, 0x1.b9779b312b7ebp-765, -0x1.b73500f6b3fb3p+761, 0x1p-211,
                          0x1.41d5e1ad87e23p-250,  0x1.12ee99daf1f1fp+177},
      b{-0x0p+0, -0x1.1414343f395dcp+459, 0x1.9022a51ce9306p-516, -0x1.6858e5be8610ep+389, 0x1.7272e9927b299p+520,
        0x1p+69};
  const ExactPair pair = pair_of(a, b, 0x0p+0, 0x1.9022a51ce930ap-524);
  const LeadingContact contact(pair);
  KnownCubic at_start;
  ASSERT_TRUE(at_start.try_at(pair, 0).known);
  const double last = 0x1.4433a2676cf56p+974;
  EXPECT_FALSE(contact.at(last).known || contact.at(0).known);
  const Trial no = contact.at(last, at_start), yes = contact.at(next(last), at_start);
  EXPECT_TRUE(no.known && !no.after && yes.known && yes.after);
  EXPECT_EQ(EllipseTrials(pair).floor(0, 0), last);
}

/// Digits of which so few are kept that a sqrt(x) + b sqrt(y) might be 0, and digits that tell.
TEST(ExactCastParts, SumOfRootsFromDigits) {
  using Few = Leading<exact::few_limbs>;
  const auto sign = [](double ax, double tiny, double bx) {
    const Few a(from_double(ax) + from_double(tiny)), b(from_double(bx)), one(from_double(1.0));
    return sum_of_roots(a, one, b, one);
  };
  EXPECT_EQ(sign(2, 0, -1), 1);
  EXPECT_EQ(sign(-2, 0, 1), -1);
  EXPECT_EQ(sign(1, 0, 1), 1);
  EXPECT_EQ(sign(1, 0x1p-100, -1), 1);
  EXPECT_EQ(sign(1, 0x1p-1000, -1), 0) << "the squares' difference is beyond their digits";
  const Few small = Few(from_double(0x1p900) + from_double(0x1p-900)) - Few(from_double(0x1p900));
  EXPECT_EQ(sum_of_roots(small, Few(from_double(1.0)), Few(from_double(-0x1p-900)), Few(from_double(1.0))), 0);
}

TEST(ExactCastParts, ContactBeyondExactNumbers) {
  const ExactPair pair = pair_of(Point<double>{0, 0}, Circle<double>{0x1p-1000, 0, 1}, -0x1p40, 0);
  EXPECT_EQ(exact_contact_at(pair, largest), static_cast<std::int32_t>(error_range));
  EXPECT_EQ(exact_contact_at(pair, 0x1p-40), 1);
  EXPECT_EQ(exact_contact_at(pair, 1), 0);
}

/// A line that grazes two ellipses, beside the time of which few digits do not tell.
TEST(ExactCastParts, ContactOfEllipsesThatGraze) {
  const Circle<double> a{0, 0, 1};
  const Ellipse<double> b{4, 2, 1, 0, 1, 1};
  const ExactPair pair = pair_of(a, b, -1, 0);
  ASSERT_TRUE(pair.line_grazes());
  for (const double t : {0x1p-1074, 1.0, before(4), 4.0, next(4), 8.0, largest}) {
    EXPECT_EQ(pair.contact_before(t), t > 4 ? 1 : 0) << t;
  }
}

/// A box whose time is not known, as it is in the ellipse from the start on: then the time is searched.
TEST(ExactCastParts, SearchedFloorOfABox) {
  const ExactPair pair = pair_of(Ellipse<double>{0, 0, 1, 0, 2, 1}, Rect<double>{1, 0, 1, 0, 1, 1}, -1, 0x1p-10);
  ASSERT_FALSE(known_time(pair).tells());
  double t = -1;
  EXPECT_EQ(exact_floor(pair, infinity, false, -1, {}, t), 1);
  EXPECT_EQ(t, 0);
}

}  // namespace
