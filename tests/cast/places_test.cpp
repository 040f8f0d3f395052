// SPDX-License-Identifier: Apache-2.0
// Whether exact numbers have room for the places at all times that the search for a time tries, told from where bits
// are.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vesica/cast.hpp>

#include "properties/generators.hpp"

namespace {

namespace core = vesica::detail::cast;
using properties::Random;
using vesica::detail::arithmetic::search_up;

constexpr double least_double = std::numeric_limits<double>::denorm_min(), largest = std::numeric_limits<double>::max();

double any(Random& random, int least, int most) { return std::ldexp(1 + random.unit(), random.integer(least, most)); }

/// A point that moves towards a disc.
core::PlaceBits any_places(Random& random) {
  const core::Body point{vesica::Kind::point, {}};
  const core::Body disc{vesica::Kind::circle, {any(random, -1000, 1000), 0, 1}};
  return core::ExactPair(point, disc, {any(random, -1074, 1000), 0, largest}).place_bits();
}

bool have_all_room(const core::PlaceBits& places, double start, double t, double witness) {
  bool all = true;
  double after = 0;
  search_up(
      start,
      [&](double at) {
        if (at > 0 && at <= witness) all = all && places.have_room(at);
        return at > t;
      },
      after);
  return all;
}

TEST(PlacesOfTrials, HaveRoomWhereThatIsTold) {
  Random random(properties::seed());
  int told = 0, lacking = 0;
  for (int i = 0; i < 4000 * properties::repeat(); ++i) {
    const core::PlaceBits places = any_places(random);
    const double t = any(random, -1074, 1022);
    const double start =
        random.chance(0.5) ? any(random, -1074, 1022) : std::fmax(least_double, t * any(random, -3, 2));
    const double witness = random.chance(0.5) ? largest : t * any(random, 0, 100);
    const bool tells = core::have_room_for_trials(places, start, t, witness);
    const bool all = have_all_room(places, start, t, witness);
    EXPECT_TRUE(all || !tells) << std::hexfloat << start << ' ' << t << ' ' << witness << ", draw " << i;
    told += tells ? 1 : 0;
    lacking += all ? 0 : 1;
  }
  EXPECT_GT(told, 200 * properties::repeat());
  EXPECT_GT(lacking, 200 * properties::repeat());
}

}  // namespace
