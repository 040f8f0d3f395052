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
  constexpr std::int64_t k = 10;
  const auto boxes = boxes_of(draw("uniform", n, 1));
  vesica_shapes_f64 view;
  vesica_shapes_from_records_f64(VESICA_AABB, n, boxes.data(), sizeof(BoxRecord), &view);
  const Operand set({view});
  Times times;
  build(set, Scratch(n), times);
  std::vector<PointRecord> points;
  for (const RectRecord& r : draw("uniform", n, 2)) points.push_back({r.cx, r.cy});
  points.resize(20000);
  double sum = 0;
  const double taken = quickest(repeats, [&] {
    sum = 0;
    for (const PointRecord& p : points) {
      vesica_shapes_f64 one;
      vesica_shapes_from_records_f64(VESICA_POINT, 1, &p, 0, &one);
      std::int64_t items[k];
      double distance[k];
      vesica_index_nearest_f64(set.index.data, set.sets.data(), 1, &one, k, INFINITY, items, distance);
      sum += distance[k - 1];
    }
  });
  const auto queries = static_cast<double>(points.size());
  std::printf("nearest %lld boxes, %.2f away: %.0f ns", static_cast<long long>(k), sum / queries,
              taken * 1e9 / queries);
  for (const Peer& peer : peers()) {
    if (peer.nearest == nullptr) continue;
    const PeerNearest p = peer.nearest(boxes, points, k, repeats);
    std::printf(" | %s x%.2f, %.2f away", peer.name.c_str(), p.seconds / taken, p.sum / queries);
  }
  std::printf("\n");
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
