// SPDX-License-Identifier: Apache-2.0
/// Index and join of rectangles: phases in ns a shape of both sides, and peers' time over the library's in the same run.
///
///     vesica_bench_join [n] [repeats] [workload]...
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "index/workloads.hpp"
#include "join/peers.hpp"

namespace {

using namespace vesica::bench;

/// A workload of this bench's own: n^2 pairs, so of a few thousand shapes at most.
constexpr const char* identical = "identical";
constexpr std::int64_t most_identical = 3000;

struct Memory {
  explicit Memory(std::int64_t bytes)
      : size((bytes + 63) / 64 * 64), data(std::aligned_alloc(64, static_cast<std::size_t>(size))) {}
  ~Memory() { std::free(data); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  std::int64_t size;
  void* data;
};

std::vector<RectRecord> draw(const std::string& workload, std::int64_t n, std::uint64_t seed) {
  if (workload == identical)
    return std::vector<RectRecord>(static_cast<std::size_t>(n), RectRecord{0, 0, 0.8, 0.6, 2, 1});
  const auto records = index_tests::rects<double>(workload, n, seed);
  std::vector<RectRecord> shapes(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const double* r = &records.numbers[6 * i];
    shapes[i] = {r[0], r[1], r[2], r[3], r[4], r[5]};
  }
  return shapes;
}

vesica_shapes_f64 view(const std::vector<RectRecord>& shapes) {
  vesica_shapes_f64 out;
  vesica_shapes_from_records_f64(VESICA_RECT, static_cast<std::int64_t>(shapes.size()), shapes.data(),
                                 sizeof(RectRecord), &out);
  return out;
}

/// Seconds: the build's steps, candidates alone, and the whole join.
struct Times {
  double step[5] = {}, candidates = 0, join = 0;
  std::int64_t pairs = 0, candidate_count = 0, bytes = 0;
  double build() const { return step[0] + step[1] + step[2] + step[3] + step[4]; }
  double total() const { return build() + join; }
};

void build(const vesica_shapes_f64& set, const Memory& index, const Memory& scratch, Times& times) {
  for (std::int32_t step = 0; step < 5; ++step) {
    const double begin = seconds();
    times.bytes = vesica_index_step_f64(step, 0, 1, &set, 1, index.data, index.size, scratch.data, scratch.size);
    times.step[step] += seconds() - begin;
  }
}

Times run(const vesica_shapes_f64& a, const vesica_shapes_f64& b, const Memory& index_a, const Memory& index_b,
          const Memory& scratch, const Memory& join_scratch, std::vector<std::int64_t>& out) {
  Times times;
  build(a, index_a, scratch, times);
  build(b, index_b, scratch, times);
  double begin = seconds();
  times.candidate_count = vesica_join_f64(VESICA_JOIN_BOUNDS, index_a.data, nullptr, 0, index_b.data, nullptr, 0, 0, 1,
                                          join_scratch.data, join_scratch.size, nullptr, nullptr, 0, nullptr);
  times.candidates = seconds() - begin;
  begin = seconds();
  std::int64_t state[4] = {0, 0, 0, 0};
  const auto capacity = static_cast<std::int64_t>(out.size() / 2);
  while (state[0] != -1) {
    times.pairs +=
        vesica_join_f64(VESICA_JOIN_OVERLAP, index_a.data, &a, 1, index_b.data, &b, 1, 0, 1, join_scratch.data,
                        join_scratch.size, out.data(), out.data() + capacity, capacity, state);
  }
  times.join = seconds() - begin;
  return times;
}

void report(const std::string& workload, std::int64_t n, int repeats, bool with_peers) {
  if (workload == identical) n = std::min(n, most_identical);
  const auto shapes_a = draw(workload, n, 1), shapes_b = draw(workload, n, 2);
  const auto a = view(shapes_a), b = view(shapes_b);
  const Memory index_a(vesica_index_size(n)), index_b(vesica_index_size(n)), scratch(vesica_index_scratch(n));
  const Memory join_scratch(vesica_join_scratch());
  std::vector<std::int64_t> out(2 << 20);  // all pairs of two blocks
  Times best;
  for (int i = 0; i < repeats; ++i) {
    const Times t = run(a, b, index_a, index_b, scratch, join_scratch, out);
    if (i == 0 || t.total() < best.total()) best = t;
  }
  const double each = 1e9 / (2.0 * static_cast<double>(n));
  std::printf(
      "%-16s %7.1f ns/shape, %.1f ns/pair: plan %.1f bin %.1f place %.1f finish %.1f rest %.1f | candidates %.1f "
      "decide %.1f (%.1f "
      "ns each) | "
      "%lld candidates %lld pairs, %.2f B/shape",
      workload.c_str(), best.total() * each,
      best.total() * 1e9 / static_cast<double>(std::max<std::int64_t>(1, best.pairs)), best.step[0] * each,
      best.step[1] * each, best.step[2] * each, best.step[3] * each, best.step[4] * each, best.candidates * each,
      (best.join - best.candidates) * each,
      (best.join - best.candidates) * 1e9 / static_cast<double>(std::max<std::int64_t>(1, best.candidate_count)),
      static_cast<long long>(best.candidate_count), static_cast<long long>(best.pairs),
      static_cast<double>(best.bytes) / static_cast<double>(n));
  for (const Peer& peer : peers()) {
    if (!with_peers) break;
    const PeerJoin p = peer.join(shapes_a, shapes_b);
    std::printf(" | %s x%.1f (build x%.1f)", peer.name.c_str(), (p.build + p.join) / best.total(),
                2 * p.build / best.build());
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// Windows one at a time about shapes of the set, and the library's ratio to peers.
void report_windows(std::int64_t n, double side, int queries) {
  const auto shapes = draw("uniform", n, 1);
  const auto set = view(shapes);
  const Memory index(vesica_index_size(n)), scratch(vesica_index_scratch(n));
  vesica_index_build_f64(&set, 1, index.data, index.size, scratch.data, scratch.size);
  std::vector<BoxRecord> windows;
  for (int i = 0; i < queries; ++i) {
    const RectRecord& r = shapes[static_cast<std::size_t>(i) * 7919 % shapes.size()];
    windows.push_back({r.cx - side / 2, r.cy - side / 2, r.cx + side / 2, r.cy + side / 2});
  }
  std::vector<std::int64_t> out(4096);
  std::int64_t hits = 0;
  const double begin = seconds();
  for (const BoxRecord& w : windows) {
    vesica_shapes_f64 one;
    vesica_shapes_from_records_f64(VESICA_AABB, 1, &w, 0, &one);
    std::int64_t state[4] = {0, 0, 0, 0};
    while (state[0] != -1) hits += vesica_index_select_f64(index.data, nullptr, 0, &one, out.data(), 4096, state);
  }
  const double taken = seconds() - begin;
  std::printf("windows of %.1f hits: %.0f ns", static_cast<double>(hits) / queries, taken * 1e9 / queries);
  for (const Peer& peer : peers()) {
    std::int64_t found = 0;
    std::printf(" | %s x%.1f", peer.name.c_str(), peer.windows(shapes, windows, found) / taken);
  }
  std::printf("\n");
}

}  // namespace

int main(int argc, char** argv) {
  const std::int64_t n = argc > 1 ? static_cast<std::int64_t>(std::atof(argv[1])) : 1000000;
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 9;
  std::vector<std::string> names(argv + std::min(argc, 3), argv + argc);
  const bool all = names.empty();
  // Nearly all pairs of the whole range overlap: no join for a bench.
  if (all)
    std::ranges::copy_if(index_tests::rect_workloads(), std::back_inserter(names),
                         [](const auto& name) { return name != "whole_range"; });
  if (all) names.emplace_back(identical);
  std::printf("%s, %lld shapes a side, least of %d; peers' time over the library's\n", vesica_isa_name(),
              static_cast<long long>(n), repeats);
  for (const std::string& name : names) report(name, n, repeats, std::getenv("VESICA_BENCH_ALONE") == nullptr);
  if (all) {
    report_windows(n, 0, 100000);
    report_windows(n, 2, 100000);
    report_windows(n, 1.5 * std::sqrt(1000.0), 10000);
  }
}
