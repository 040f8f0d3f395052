// SPDX-License-Identifier: Apache-2.0
/// Pairs by IoU and fusion of boxes, beside the loops that one writes without them, which ask every pair. Boxes lie in
/// groups of four on average, as several views find the same things. Loops know boxes along the axes by a formula, and
/// take IoUs of turned rectangles from the library. Each row has the median of some runs, each on fresh boxes.
#include <vesica.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "quantile.hpp"
#include "random.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double threshold = 0.5;

struct Boxes {
  std::int32_t kind;
  std::vector<double> numbers, scores;

  std::size_t fields() const { return kind == VESICA_AABB ? 4 : 6; }
  std::int64_t count() const { return static_cast<std::int64_t>(scores.size()); }
  const double* at(std::size_t i) const { return &numbers[i * fields()]; }
  vesica_shapes_f64 view() const {
    vesica_shapes_f64 shapes;
    const auto bytes = static_cast<std::ptrdiff_t>(fields() * sizeof(double));
    vesica_shapes_from_records_f64(kind, count(), numbers.data(), bytes, &shapes);
    return shapes;
  }
};

/// Two views of the same things.
void draw(std::int32_t kind, std::int64_t count, Random& random, Boxes& a, Boxes& b) {
  const auto things = static_cast<std::size_t>(count / 4);
  const double side = 1.5 * std::sqrt(static_cast<double>(things));
  std::vector<double> places(2 * things);
  for (double& x : places) x = random.between(0, side);
  for (Boxes* view : {&a, &b}) {
    *view = {kind, {}, {}};
    for (std::int64_t i = 0; i < count; ++i) {
      const auto thing = static_cast<std::size_t>(random.unit() * static_cast<double>(things));
      const double x = places[2 * thing] + random.between(-0.1, 0.1),
                   y = places[2 * thing + 1] + random.between(-0.1, 0.1);
      const double hx = random.between(0.4, 0.6), hy = random.between(0.4, 0.6), angle = random.between(-0.2, 0.2);
      if (kind == VESICA_AABB) {
        view->numbers.insert(view->numbers.end(), {x - hx, y - hy, x + hx, y + hy});
      } else {
        view->numbers.insert(view->numbers.end(), {x, y, std::cos(angle), std::sin(angle), hx, hy});
      }
      view->scores.push_back(random.unit());
    }
  }
}

double iou_of_boxes(const double* a, const double* b) {
  const double width = std::min(a[2], b[2]) - std::max(a[0], b[0]),
               height = std::min(a[3], b[3]) - std::max(a[1], b[1]);
  if (width <= 0 || height <= 0) return 0;
  const double shared = width * height;
  return shared / ((a[2] - a[0]) * (a[3] - a[1]) + (b[2] - b[0]) * (b[3] - b[1]) - shared);
}

double iou(std::int32_t kind, const double* a, const double* b) {
  if (kind == VESICA_AABB) return iou_of_boxes(a, b);
  double ratio = 0;
  vesica_iou_f64(kind, a, kind, b, &ratio);
  return ratio;
}

// ---- Pairs by IoU: how many there are. ----

class Memory {
 public:
  explicit Memory(std::int64_t bytes)
      : size_((bytes + 63) / 64 * 64), data_(std::aligned_alloc(64, static_cast<std::size_t>(size_))) {}
  ~Memory() { std::free(data_); }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  void* get() const { return data_; }
  std::int64_t size() const { return size_; }

 private:
  std::int64_t size_;
  void* data_;
};

void build(const vesica_shapes_f64& shapes, const Memory& index) {
  const Memory scratch(vesica_index_scratch(shapes.count));
  vesica_index_build_f64(&shapes, 1, index.get(), index.size(), scratch.get(), scratch.size());
}

std::int64_t pairs_by_index(const Boxes& a, const Boxes& b) {
  const vesica_shapes_f64 first = a.view(), second = b.view();
  const Memory index_a(vesica_index_size(first.count)), index_b(vesica_index_size(second.count)),
      scratch(vesica_join_scratch());
  build(first, index_a);
  build(second, index_b);
  constexpr std::int64_t room = 1 << 16;
  std::vector<std::int64_t> i(room), j(room);
  std::vector<double> values(room);
  std::int64_t state[4] = {0, 0, 0, 0}, pairs = 0;
  while (state[0] != -1) {
    pairs +=
        vesica_join_ratio_f64(VESICA_RATIO_OVER_UNION, threshold, index_a.get(), &first, 1, index_b.get(), &second, 1,
                              0, 1, scratch.get(), scratch.size(), i.data(), j.data(), values.data(), room, state);
  }
  return pairs;
}

std::int64_t pairs_by_matrix(const Boxes& a, const Boxes& b) {
  const vesica_shapes_f64 first = a.view(), second = b.view();
  std::vector<double> matrix(static_cast<std::size_t>(first.count * second.count));
  vesica_iou_matrix_f64(&first, &second, matrix.data(), static_cast<std::ptrdiff_t>(second.count));
  return std::count_if(matrix.begin(), matrix.end(), [](double x) { return x >= threshold; });
}

std::int64_t pairs_by_loop(const Boxes& a, const Boxes& b) {
  std::int64_t pairs = 0;
  for (std::size_t i = 0; i < a.scores.size(); ++i) {
    for (std::size_t j = 0; j < b.scores.size(); ++j) pairs += iou(a.kind, a.at(i), b.at(j)) >= threshold;
  }
  return pairs;
}

// ---- Fusion: how many clusters there are. ----

std::int64_t clusters_by_library(const Boxes& a, const Boxes&) {
  const vesica_shapes_f64 shapes = a.view();
  const Memory scratch(vesica_fuse_scratch(shapes.count));
  std::vector<double> fused(a.numbers.size()), scores(a.scores.size());
  std::vector<std::int64_t> clusters(a.scores.size());
  std::int64_t count = 0;
  vesica_fuse_f64(&shapes, a.scores.data(), nullptr, nullptr, threshold, VESICA_FUSED_MEAN, scratch.get(),
                  scratch.size(), fused.data(), scores.data(), clusters.data(), &count);
  return count;
}

/// The mean of boxes along the axes; of turned rectangles the numbers are averaged as they are, which suits small
/// differences of their angles.
std::int64_t clusters_by_loop(const Boxes& a, const Boxes&) {
  std::vector<std::size_t> order(a.scores.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return a.scores[i] > a.scores[j]; });
  const std::size_t fields = a.fields();
  std::vector<double> means, weights;
  for (const std::size_t i : order) {
    std::size_t best = weights.size();
    double highest = threshold;
    for (std::size_t c = 0; c < weights.size(); ++c) {
      const double ratio = iou(a.kind, &means[c * fields], a.at(i));
      if (ratio > highest) highest = ratio, best = c;
    }
    if (best == weights.size()) {
      means.insert(means.end(), a.at(i), a.at(i) + fields);
      weights.push_back(a.scores[i]);
      continue;
    }
    weights[best] += a.scores[i];
    const double share = a.scores[i] / weights[best];
    for (std::size_t k = 0; k < fields; ++k)
      means[best * fields + k] += share * (a.at(i)[k] - means[best * fields + k]);
  }
  return static_cast<std::int64_t>(weights.size());
}

// ---- The table. ----

struct Contestant {
  const char* name;
  std::int64_t (*run)(const Boxes& a, const Boxes& b);
  std::vector<double> milliseconds;
  std::int64_t found = 0;
};

void row(const char* what, std::int32_t kind, std::int64_t count, std::vector<Contestant> all) {
  const int runs = count > 5000 ? 5 : 15;
  Random random(7);
  Boxes a, b;
  for (int run = 0; run < runs; ++run) {
    draw(kind, count, random, a, b);
    for (Contestant& c : all) {
      const Clock::time_point start = Clock::now();
      c.found += c.run(a, b);
      c.milliseconds.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }
  }
  std::printf("%-8s %-5s %6d %9d found", what, vesica_kind_name(kind), static_cast<int>(count),
              static_cast<int>(all[0].found / runs));
  const double library = median(all[0].milliseconds);
  for (const Contestant& c : all) {
    const double time = median(c.milliseconds);
    std::printf("   %s %.2f ms", c.name, time);
    if (&c != &all[0]) std::printf(" (%.1f times)", time / library);
    if (std::abs(c.found - all[0].found) * 1000 > all[0].found)
      std::printf(" finds %d", static_cast<int>(c.found / runs));
  }
  std::printf("\n");
}

}  // namespace
}  // namespace vesica::bench

int main() {
  using namespace vesica::bench;
  for (const std::int32_t kind : {VESICA_AABB, VESICA_RECT}) {
    for (const std::int64_t count : {1000, 10000}) {
      row("pairs", kind, count,
          {{"vesica_join_ratio", pairs_by_index, {}},
           {"vesica_iou_matrix", pairs_by_matrix, {}},
           {"loop", pairs_by_loop, {}}});
    }
    for (const std::int64_t count : {1000, 10000}) {
      row("fusion", kind, count, {{"vesica_fuse", clusters_by_library, {}}, {"loop", clusters_by_loop, {}}});
    }
  }
}
