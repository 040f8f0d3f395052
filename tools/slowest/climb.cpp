// SPDX-License-Identifier: Apache-2.0
#include "slowest/climb.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <vector>

#include "cast/motions.hpp"
#include "properties/generators.hpp"
#include "slowest/measure.hpp"
#include "stress/call.hpp"
#include "stress/change.hpp"

namespace slowest {
namespace {

using properties::Random;
using properties::Scalar;
using stress::Case;
using stress::Query;

class Climb {
 public:
  Climb(Query query, int kind_a, int kind_b, std::uint64_t seed, const std::vector<Case>& known)
      : query_(query), kind_a_(kind_a), kind_b_(kind_b), random_(seed) {
    for (const Case& c : known) {
      if (c.query == query && c.scalar == Scalar::f64 && c.pair.kind_a == kind_a && c.pair.kind_b == kind_b) {
        known_.push_back(c);
      }
    }
  }

  /// A few climbers at a time; the cheapest begins anew when it has not risen for long.
  Slowest run(double seconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
    for (Climber& c : climbers_) c = begun();
    while (std::chrono::steady_clock::now() < end) {
      for (Climber& c : climbers_) step(c);
    }
    return {slowest_.input, slowest_.cost, calls_};
  }

 private:
  struct Climber {
    Case input{};
    double cost = 0;
    int patience = 0;
  };
  static constexpr int patience = 3000, calls = 3, more_calls = 25;

  double cost_of(const Case& c, int repeats) {
    ++calls_;
    return microseconds(c, repeats);
  }

  Climber begun() {
    if (!known_.empty()) {
      const Case& c = known_[static_cast<std::size_t>(random_.below(static_cast<int>(known_.size())))];
      return {c, cost_of(c, more_calls), 0};
    }
    Climber best;
    for (int i = 0; i < 200; ++i) {
      constexpr auto count = static_cast<int>(properties::all_workloads.size());
      auto workload = properties::all_workloads[static_cast<std::size_t>(random_.below(count))];
      if (workload == properties::Workload::near_contact) workload = properties::Workload::mixed_scale;
      Case c{query_, Scalar::f64,
             stress::changed(properties::draw(workload, kind_a_, kind_b_, Scalar::f64, random_), random_)};
      if (of_motion(query_)) c.motion = cast_test::draw_motion(c.pair, Scalar::f64, random_);
      if (query_ == Query::within) c.distance = stress::draw_distance(Scalar::f64, c.pair, random_);
      const double cost = cost_of(c, calls);
      if (cost > best.cost) best = {c, cost, 0};
    }
    best.cost = cost_of(best.input, more_calls);
    return best;
  }

  void step(Climber& c) {
    const Case p = stress::changed(c.input, random_);
    const double cost = cost_of(p, calls);
    if (cost < c.cost * 0.99) {
      if (++c.patience > patience) c = begun();
      return;
    }
    const double confirmed = cost_of(p, more_calls);
    if (confirmed < c.cost * 0.99) return;
    c = {p, confirmed, confirmed > c.cost * 1.01 ? 0 : c.patience + 1};
    if (confirmed > slowest_.cost) slowest_ = c;
  }

  Query query_;
  int kind_a_, kind_b_;
  Random random_;
  std::vector<Case> known_;
  std::array<Climber, 4> climbers_;
  Climber slowest_;
  std::uint64_t calls_ = 0;
};

}  // namespace

Slowest climb(Query query, int kind_a, int kind_b, double seconds, std::uint64_t seed,
              const std::vector<stress::Case>& known) {
  return Climb(query, kind_a, kind_b, seed, known).run(seconds);
}

}  // namespace slowest
