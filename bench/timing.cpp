// SPDX-License-Identifier: Apache-2.0
#include "timing.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pair.hpp"
#include "peers/peer.hpp"
#include "row.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// Exact calls take microseconds, the worst a tenth of a millisecond: passes stay below the time after which a busy
/// machine would interrupt most of them.
std::size_t pass_length(Workload workload) {
  if (workload == Workload::exponents) return 4;
  return is_exact(workload) ? 64 : pairs_per_pass;
}

/// Nanoseconds a test of one pass. The answer is consumed so that the pass cannot be dropped.
template <class Pass>
double time_of(std::size_t tests, Pass pass) {
  const Clock::time_point start = Clock::now();
  std::int64_t hits = pass();
  benchmark::DoNotOptimize(hits);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / static_cast<double>(tests);
}

/// The one row whose pool is in memory, and what its peers hold of it.
class Loaded {
 public:
  void load(Row& row) {
    if (row_ == &row) return;
    if (row_) row_->passes->unload();
    row_ = &row;
    pool_ = make_pool(row.kind_a, row.kind_b, row.workload, seed_of_run());
    row.passes->load(pool_);
    random_ = Random(seed_of_run());
    peer_ = nullptr;
    peer_pairs_.reset();
    if (row.yardstick_asked == 0 && row.has_yardstick) check_yardstick();
  }

  void load(Row& row, const Peer& peer) {
    load(row);
    if (peer_ == &peer) return;
    peer_ = &peer;
    peer_pairs_.emplace(peer, row, pool_);
  }

  /// Both sides on the same fresh pairs, each copied into the same hot buffers just before; who goes first alternates.
  /// So both meet the same machine, and neither has the other's caches or branch history as an advantage.
  Sample sample() {
    const std::size_t tests = pass_length(row_->workload);
    const Random start = random_;
    Sample sample{};
    library_first_ = !library_first_;
    for (const bool library : {library_first_, !library_first_}) {
      random_ = start;
      row_->passes->draw(random_, tests);
      if (library) {
        sample.library = time_of(tests, [&] { return count_hits(tests); });
      } else if (row_->has_yardstick) {
        sample.yardstick = time_of(tests, [&] { return row_->passes->yardstick_hits(); });
      }
    }
    row_->samples.push_back(sample);
    return sample;
  }

  PeerPairs& peer_pairs() { return *peer_pairs_; }
  Random& random() { return random_; }

 private:
  std::int64_t count_hits(std::size_t tests) {
    const std::int64_t hits = row_->passes->library_hits();
    row_->hits += hits;
    row_->tests += static_cast<std::int64_t>(tests);
    return hits;
  }

  void check_yardstick() {
    for (int pass = 0; pass < 400; ++pass) {
      row_->passes->draw(random_, pairs_per_pass);
      row_->yardstick_wrong += row_->passes->disagreements();
      row_->yardstick_asked += static_cast<std::int64_t>(pairs_per_pass);
    }
  }

  Row* row_ = nullptr;
  Pool pool_;
  Random random_{0};
  bool library_first_ = false;
  const Peer* peer_ = nullptr;
  std::optional<PeerPairs> peer_pairs_;
};

Loaded& loaded() {
  static Loaded only;
  return only;
}

void report(benchmark::State& state, std::size_t tests_per_iteration) {
  const auto tests = state.iterations() * static_cast<std::int64_t>(tests_per_iteration);
  state.SetItemsProcessed(tests);
  state.counters["per_test"] =
      benchmark::Counter(static_cast<double>(tests), benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void run_side(benchmark::State& state, Row& row, double Sample::*side) {
  loaded().load(row);
  const std::size_t tests = pass_length(row.workload);
  for ([[maybe_unused]] auto _ : state) {
    state.SetIterationTime(loaded().sample().*side * static_cast<double>(tests) * 1e-9);
  }
  report(state, tests);
  state.counters["hit_rate"] = static_cast<double>(row.hits) / static_cast<double>(row.tests);
}

PeerResult& result_of(Row& row, const Peer& peer) {
  const auto found = std::ranges::find(row.peers, peer.name, &PeerResult::name);
  return found != row.peers.end() ? *found : row.peers.emplace_back(PeerResult{.name = peer.name, .nanoseconds = {}});
}

void run_peer(benchmark::State& state, Row& row, const Peer& peer) {
  loaded().load(row, peer);
  PeerPairs& pairs = loaded().peer_pairs();
  PeerResult& result = result_of(row, peer);
  result.wrong = pairs.wrong();
  result.asked = pairs.size();
  for ([[maybe_unused]] auto _ : state) {
    pairs.draw(loaded().random());
    const double nanoseconds = time_of(PeerPairs::tests_per_pass, [&] { return pairs.hits(); });
    result.nanoseconds.push_back(nanoseconds);
    state.SetIterationTime(nanoseconds * PeerPairs::tests_per_pass * 1e-9);
  }
  report(state, PeerPairs::tests_per_pass);
  state.counters["wrong"] = static_cast<double>(result.wrong);
}

template <class Function>
void add(const std::string& name, Function function) {
  benchmark::RegisterBenchmark(name.c_str(), function)->UseManualTime();
}

}  // namespace

void register_benchmarks() {
  for (Row& row : rows()) {
    add(row.name() + "/vesica", [&row](benchmark::State& state) { run_side(state, row, &Sample::library); });
    if (row.has_yardstick) {
      add(row.name() + "/textbook", [&row](benchmark::State& state) { run_side(state, row, &Sample::yardstick); });
    }
    for (const Peer& peer : peers()) {
      if (!can_answer(peer, row)) continue;
      add(row.name() + "/" + peer.name, [&](benchmark::State& state) { run_peer(state, row, peer); });
    }
  }
}

}  // namespace vesica::bench
