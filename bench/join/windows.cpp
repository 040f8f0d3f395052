// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "join/measure.hpp"
#include "join/rows.hpp"

namespace vesica::bench {
namespace {

std::int64_t select_all(const Operand& set, const std::vector<BoxRecord>& windows) {
  std::vector<std::int64_t> out(4096);
  std::int64_t hits = 0;
  for (const BoxRecord& w : windows) {
    vesica_shapes_f64 one;
    vesica_shapes_from_records_f64(VESICA_AABB, 1, &w, 0, &one);
    std::int64_t state[4] = {0, 0, 0, 0};
    while (state[0] != -1) hits += vesica_index_select_f64(set.index.data, nullptr, 0, &one, out.data(), 4096, state);
  }
  return hits;
}

void report_size(const std::vector<RectRecord>& shapes, const Operand& set, double side, int queries, int repeats) {
  std::vector<BoxRecord> windows;
  for (int i = 0; i < queries; ++i) {
    const RectRecord& r = shapes[static_cast<std::size_t>(i) * 7919 % shapes.size()];
    windows.push_back({r.cx - side / 2, r.cy - side / 2, r.cx + side / 2, r.cy + side / 2});
  }
  std::int64_t hits = 0;
  const double taken = quickest(repeats, [&] { hits = select_all(set, windows); });
  std::printf("windows of %.1f hits: %.0f ns", static_cast<double>(hits) / queries, taken * 1e9 / queries);
  for (const Peer& peer : peers())
    std::printf(" | %s x%.1f", peer.name.c_str(), peer.windows(shapes, windows, repeats) / taken);
  std::printf("\n");
}

std::vector<BoxRecord> boxes_of(const std::vector<RectRecord>& shapes) {
  std::vector<BoxRecord> boxes;
  for (const RectRecord& r : shapes) boxes.push_back(box_of(r));
  return boxes;
}

constexpr std::int64_t nearest_queries = 20000;

/// The k nearest of a set to points, each asked once: one by one, and as a join.
template <class OfPeer>
void report_nearest_of(const char* name, const Operand& set, const std::vector<PointRecord>& asked, std::int64_t k,
                       int repeats, OfPeer of_peer) {
  Times times;
  build(set, Scratch(set.items), times);
  const auto length = static_cast<std::size_t>(k);
  double sum = 0;
  const PointRecord* next = asked.data();
  std::vector<std::int64_t> items(length * nearest_queries);
  std::vector<double> distance(items.size());
  const double taken = quickest(repeats, [&] {
    sum = 0;
    for (std::int64_t i = 0; i < nearest_queries; ++i, ++next) {
      vesica_shapes_f64 one;
      vesica_shapes_from_records_f64(VESICA_POINT, 1, next, 0, &one);
      vesica_index_nearest_f64(set.index.data, set.sets.data(), 1, &one, k, INFINITY, items.data(), distance.data());
      sum += distance[length - 1];
    }
  });
  next = asked.data();
  const double joined = quickest(repeats, [&] {
    vesica_shapes_f64 all;
    vesica_shapes_from_records_f64(VESICA_POINT, nearest_queries, next, sizeof(PointRecord), &all);
    vesica_join_nearest_f64(&all, 1, set.index.data, set.sets.data(), 1, k, INFINITY, 0, 1, items.data(),
                            distance.data());
    next += nearest_queries;
  });
  std::printf("nearest %lld %s, %.2f away: %.0f ns, in a join %.0f ns", static_cast<long long>(k), name,
              sum / nearest_queries, taken * 1e9 / nearest_queries, joined * 1e9 / nearest_queries);
  for (const Peer& peer : peers()) {
    if (peer.nearest == nullptr) continue;
    const PeerNearest p = of_peer(peer);
    std::printf(" | %s x%.2f, %.2f away", peer.name.c_str(), p.seconds / taken, p.sum / nearest_queries);
  }
  std::printf("\n");
}

}  // namespace

void report_windows(std::int64_t n, int repeats) {
  const auto shapes = draw("uniform", n, 1);
  const Operand set({view(shapes)});
  Times times;
  build(set, Scratch(n), times);
  report_size(shapes, set, 0, 100000, repeats);
  report_size(shapes, set, 2, 100000, repeats);
  report_size(shapes, set, 1.5 * std::sqrt(1000.0), 10000, repeats);
}

void report_nearest(std::int64_t n, int repeats) {
  const auto boxes = boxes_of(draw("uniform", n, 1));
  std::vector<PointRecord> centres, asked;
  for (const BoxRecord& b : boxes) centres.push_back({(b.min_x + b.max_x) / 2, (b.min_y + b.max_y) / 2});
  for (const RectRecord& r : draw("uniform", repeats * nearest_queries, 2)) {
    // As many shapes lie as densely in any square: asked are points of the larger one.
    const double scale = std::sqrt(static_cast<double>(n) / (repeats * nearest_queries));
    asked.push_back({r.cx * scale, r.cy * scale});
  }
  vesica_shapes_f64 points_view, boxes_view;
  vesica_shapes_from_records_f64(VESICA_POINT, n, centres.data(), sizeof(PointRecord), &points_view);
  vesica_shapes_from_records_f64(VESICA_AABB, n, boxes.data(), sizeof(BoxRecord), &boxes_view);
  for (const std::int64_t k : {1, 10}) {
    report_nearest_of("points", Operand({points_view}), asked, k, repeats,
                      [&](const Peer& peer) { return peer.nearest_points(centres, asked, unsigned(k), repeats); });
    report_nearest_of("boxes", Operand({boxes_view}), asked, k, repeats,
                      [&](const Peer& peer) { return peer.nearest(boxes, asked, unsigned(k), repeats); });
  }
}

void report_turning(std::int64_t n, int repeats) {
  constexpr int queries = 200, asked_of_all = 3;
  constexpr double tolerance = 1e-3;
  const auto shapes = draw("uniform", n, 1);
  auto moving = draw("uniform", n, 2);
  moving.resize(queries);
  const Operand set({view(shapes)});
  Times times;
  build(set, Scratch(n), times);
  vesica_impact_f64 impact;
  double gap, sum = 0;
  std::int64_t hits = 0;
  const auto turn_of = [](const RectRecord& r) { return vesica_turn_f64{20 * r.ux, 20 * r.uy, 2}; };
  const double taken = quickest(repeats, [&] {
    hits = 0;
    for (const RectRecord& r : moving) {
      vesica_shapes_f64 one;
      std::int32_t answer;
      vesica_shapes_from_records_f64(VESICA_RECT, 1, &r, 0, &one);
      const vesica_turn_f64 turn = turn_of(r);
      hits += vesica_index_impact_time_f64(set.index.data, set.sets.data(), 1, &one, &turn, tolerance, &impact, &gap,
                                           &answer) < n;
    }
  });
  const double all = quickest(1, [&] {
    for (int i = 0; i < asked_of_all; ++i) {
      const RectRecord& r = moving[static_cast<std::size_t>(i)];
      const vesica_turn_f64 rest{0, 0, 0}, turn = turn_of(r);
      for (const RectRecord& other : shapes) {
        if (vesica_impact_time_f64(VESICA_RECT, &other, &rest, VESICA_RECT, &r, &turn, tolerance, &impact, &gap) > 0)
          sum += impact.t;
      }
    }
  });
  std::printf("turning, %.0f%% hit: %.0f ns | each of all x%.0f%s\n", 100.0 * static_cast<double>(hits) / queries,
              taken * 1e9 / queries, all / asked_of_all / (taken / queries), sum < 0 ? "!" : "");
}

}  // namespace vesica::bench
