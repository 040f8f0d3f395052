// SPDX-License-Identifier: Apache-2.0
// answers_draw [SEED [GROUPS [KIND]]]: draws tests/answers/cases.txt. For each ordered pair of kinds, one of them KIND
// or above, and scalar type it draws some groups of the stress test. It writes four pairs of a group, each with a
// motion: the one that the group began with, two about its contact and one further away. A broken pair follows.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <tuple>

#include "cast/motions.hpp"
#include "stress/groups.hpp"

namespace {

using namespace stress;

/// One that only just hits or misses, where one can be found.
Motion motion_of(const Pair& pair, Scalar scalar, properties::Random& random) {
  const Motion m = cast_test::draw_motion(pair, scalar, random);
  const bool hits = cast_test::cast(scalar, pair, m).code > 0;
  if (!hits || random.chance(0.5)) return m;
  const auto grazing = cast_test::about_grazing({pair, m}, scalar, random, 1);
  for (const auto& g : grazing) {
    // Its motion alone: the pair is what the other queries are asked of.
    if (g.pair.a == pair.a && g.pair.b == pair.b) return g.motion;
  }
  return m;
}

void print(const Pair& pair, const Motion& motion) {
  const std::string text = notation({Query::cast, Scalar::f64, pair, motion});
  std::printf("%s\n", text.substr(text.find(' ') + 1).c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t seed = argc > 1 ? std::strtoull(argv[1], nullptr, 0) : 1;
  const int groups_of_each = argc > 2 ? std::atoi(argv[2]) : 6;
  const int least_kind = argc > 3 ? std::atoi(argv[3]) : 0;
  const int pairs = properties::kinds * properties::kinds - least_kind * least_kind;
  properties::Random random(seed);
  std::map<std::tuple<int, int, Scalar>, int> drawn;
  int complete = 0;
  std::printf("# Drawn by answers_draw %llu %d %d: two shapes, and how the second moves in casts.\n",
              static_cast<unsigned long long>(seed), groups_of_each, least_kind);
  for (std::uint64_t number = 0; complete < 2 * pairs; ++number) {
    const Group group = draw_group(seed, number);
    const std::size_t n = group.pairs.size();
    const Pair& base = group.pairs[0];
    if (n < 6 || std::max(base.kind_a, base.kind_b) < least_kind) continue;
    int& count = drawn[{base.kind_a, base.kind_b, group.scalar}];
    if (count == groups_of_each) continue;
    if (++count == groups_of_each) ++complete;
    for (const std::size_t i : {std::size_t{0}, std::size_t{2}, std::size_t{3}, n - 1}) {
      print(group.pairs[i], motion_of(group.pairs[i], group.scalar, random));
    }
    if (count == 1 && group.scalar == Scalar::f64) print(broken(base, number), {1, 2, 3});
  }
  return 0;
}
