// SPDX-License-Identifier: Apache-2.0
// Shared areas of fresh pairs through the shared library, beside the usual rotated-IoU algorithm and Boost.Geometry,
// with each one's error against 60 digits; then non-maximum suppression.
#include <vesica.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cinttypes>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "area/reference.hpp"
#include "quantile.hpp"
#include "relation/area_peer.hpp"
#include "relation/report.hpp"
#include "textbook/rotated_area.hpp"
#include "workloads.hpp"

namespace vesica::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Textbook = textbook::RotatedArea<vesica_rect_f64>;

constexpr std::size_t pairs_per_pass = 256;
constexpr int passes = 200;
constexpr std::size_t pairs_checked = 400;

struct Kinds {
  std::int32_t a, b;
  double target;  ///< nanoseconds; 0 for none
};

/// Boost has no polygons of these here.
bool is_rounded(const Kinds& kinds) { return kinds.b == VESICA_CAPSULE || kinds.b == VESICA_ROUND_RECT; }

/// The pools of workloads.hpp; each shape with itself; and pairs of aspect 10^3 to 10^4, crossing.
enum class Data { mixed, near, itself, thin };
constexpr std::array all_data{Data::mixed, Data::near, Data::itself, Data::thin};

const char* name_of(Data data) {
  constexpr std::array names{"mixed", "near", "itself", "thin"};
  return names.at(static_cast<std::size_t>(data));
}

struct Pairs {
  std::vector<Numbers> a, b;
};

Numbers thinned(std::int32_t kind, Numbers n, Random& random) {
  const double by = std::exp2(random.between(-13.3, -10));
  if (kind == VESICA_RECT || kind == VESICA_ELLIPSE) n[5] = n[4] * by;
  return n;
}

Pairs draw(const Pool& pool, const Kinds& kinds, Data data, Random& random, std::size_t count) {
  Pairs pairs;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = random.index(pool.a.size());
    Numbers a = pool.a[index], b = pool.b[pool.matched ? index : random.index(pool.b.size())];
    if (data == Data::itself) b = a;
    if (data == Data::thin) {
      b[0] = a[0] + random.between(-0.1, 0.1);
      b[1] = a[1] + random.between(-0.1, 0.1);
      a = thinned(kinds.a, a, random);
      b = thinned(kinds.b, b, random);
    }
    pairs.a.push_back(a);
    pairs.b.push_back(b);
  }
  return pairs;
}

double library_area(const Kinds& kinds, const Numbers& a, const Numbers& b) {
  double out = 0;
  vesica_area_f64(kinds.a, a.data(), kinds.b, b.data(), &out);
  return out;
}

double textbook_area(const Numbers& a, const Numbers& b) {
  return Textbook::shared(to_shape<vesica_rect_f64>(a), to_shape<vesica_rect_f64>(b));
}

/// area(i): of pair i.
template <class Area>
double nanoseconds_a_call(std::size_t pairs, const Area& area, double& sum) {
  const Clock::time_point start = Clock::now();
  for (std::size_t i = 0; i < pairs; ++i) sum += area(i);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / static_cast<double>(pairs);
}

/// The worst |area - truth| over the lesser shape's area.
template <class Area>
double worst_error(const Kinds& kinds, const Pairs& pairs, const Area& area) {
  double worst = 0;
  for (std::size_t i = 0; i < pairs.a.size(); ++i) {
    const auto &a = pairs.a[i], &b = pairs.b[i];
    double whole_a = 0, whole_b = 0;
    vesica_shape_area_f64(kinds.a, a.data(), &whole_a);
    vesica_shape_area_f64(kinds.b, b.data(), &whole_b);
    const std::int32_t known = vesica_relation_f64(kinds.a, a.data(), kinds.b, b.data());
    const std::int32_t relation = known == VESICA_E_KIND ? VESICA_CROSS : known;
    const double truth = relation <= VESICA_TOUCH      ? 0
                         : relation == VESICA_EQUAL    ? whole_a
                         : relation >= VESICA_CONTAINS ? whole_b
                         : relation >= VESICA_INSIDE   ? whole_a
                                                       : reference::area(kinds.a, a.data(), kinds.b, b.data());
    worst = std::fmax(worst, std::fabs(area(i) - truth) / std::fmin(whole_a, whole_b));
  }
  return worst;
}

struct Entry {
  double nanoseconds, error;
};

/// prepare(pairs) makes the function that nanoseconds_a_call() wants.
template <class Prepare>
Entry measure(const Kinds& kinds, Data data, int rounds, const Prepare& prepare) {
  const Pool pool = make_pool(kinds.a, kinds.b, data == Data::near ? Workload::near : Workload::mixed, seed_of_run());
  Random random(seed_of_run());
  std::vector<double> times;
  double sum = 0;
  for (int pass = 0; pass < rounds; ++pass) {
    const Pairs pairs = draw(pool, kinds, data, random, pairs_per_pass);
    times.push_back(nanoseconds_a_call(pairs_per_pass, prepare(pairs), sum));
  }
  volatile double used = sum;
  static_cast<void>(used);
  const Pairs checked = draw(pool, kinds, data, random, pairs_checked);
  return {median(times), worst_error(kinds, checked, prepare(checked))};
}

auto by_library(const Kinds& kinds) {
  return [&kinds](const Pairs& pairs) {
    return [&](std::size_t i) { return library_area(kinds, pairs.a[i], pairs.b[i]); };
  };
}

auto by_textbook() {
  return [](const Pairs& pairs) { return [&](std::size_t i) { return textbook_area(pairs.a[i], pairs.b[i]); }; };
}

auto by_boost(const Kinds& kinds) {
  return [&kinds](const Pairs& pairs) {
    auto polygons = std::make_shared<BoostPairs>();
    for (std::size_t i = 0; i < pairs.a.size(); ++i) polygons->add(kinds.a, pairs.a[i], kinds.b, pairs.b[i]);
    return [polygons](std::size_t i) { return polygons->area(i); };
  };
}

void print_entry(std::FILE* out, const Entry& entry, const Entry& library) {
  std::fprintf(out, " %10.0f %8.1f %9.1e", entry.nanoseconds, entry.nanoseconds / library.nanoseconds, entry.error);
}

void report_pair(std::FILE* out, const Kinds& kinds, Data data) {
  const std::string name =
      std::string(vesica_kind_name(kinds.a)) + "_" + vesica_kind_name(kinds.b) + "/f64/" + name_of(data);
  const Entry library = measure(kinds, data, passes, by_library(kinds));
  const bool has_target = kinds.target > 0 && data == Data::mixed;
  std::fprintf(out, "%-28s %8.1f %9.1e %-8s", name.c_str(), library.nanoseconds, library.error,
               !has_target                           ? ""
               : library.nanoseconds <= kinds.target ? "met"
                                                     : "MISSED");
  if (kinds.a == VESICA_RECT && kinds.b == VESICA_RECT) {
    print_entry(out, measure(kinds, data, passes, by_textbook()), library);
  } else {
    std::fprintf(out, " %29s", "");
  }
  if (!is_rounded(kinds)) print_entry(out, measure(kinds, data, passes / 20, by_boost(kinds)), library);
  std::fprintf(out, "\n");
}

// ---- Non-maximum suppression.

struct Detections {
  std::vector<vesica_rect_f64> rects;
  std::vector<double> scores;
};

/// Turned rectangles scattered so that a tenth of an area (sparse) or five times an area (crowded) is covered.
Detections detections(std::size_t count, double side, Random& random) {
  Detections d;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = random.between(0, 6.283185307179586);
    d.rects.push_back({random.between(0, side), random.between(0, side), std::cos(angle), std::sin(angle),
                       random.between(0.5, 1.5), random.between(0.5, 1.5)});
    d.scores.push_back(random.unit());
  }
  return d;
}

std::int64_t suppress(const Detections& d, double threshold) {
  vesica_shapes_f64 shapes;
  const auto count = static_cast<std::int64_t>(d.rects.size());
  vesica_shapes_from_records_f64(VESICA_RECT, count, d.rects.data(), sizeof d.rects[0], &shapes);
  std::vector<char> scratch(static_cast<std::size_t>(vesica_nms_scratch(count)));
  std::vector<std::int64_t> keep(d.rects.size());
  std::int64_t kept = 0;
  vesica_nms_f64(&shapes, d.scores.data(), threshold, scratch.data(), static_cast<std::int64_t>(scratch.size()),
                 keep.data(), &kept);
  return kept;
}

std::int64_t suppress_by_textbook(const Detections& d, double threshold) {
  std::vector<std::size_t> order(d.rects.size()), kept;
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t i, std::size_t j) { return d.scores[i] > d.scores[j]; });
  for (const std::size_t i : order) {
    const auto hides = [&](std::size_t j) { return Textbook::iou(d.rects[j], d.rects[i]) > threshold; };
    if (std::ranges::none_of(kept, hides)) kept.push_back(i);
  }
  return static_cast<std::int64_t>(kept.size());
}

template <class Suppress>
double milliseconds(const Detections& d, const Suppress& nms, std::int64_t& kept) {
  const Clock::time_point start = Clock::now();
  kept = nms(d, 0.5);
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

}  // namespace

void report_area(std::FILE* out) {
  std::fprintf(
      out,
      "\nShared area: nanoseconds a call by kind through the shared library, medians over passes on fresh pairs; "
      "seed %" PRIu64
      ".\nerror: the worst of %zu pairs, over the lesser shape's area. Textbook: sorted hull of crossing points "
      "(rectangles). Boost: intersection\nof polygons, ellipses as inscribed 64-gons.\n\n%-28s %8s %9s %-8s %10s "
      "%8s %9s %10s %8s %9s\n",
      seed_of_run(), pairs_checked, "pair/scalar/data", "vesica", "error", "target", "textbook", "ratio", "error",
      "boost", "ratio", "error");
  constexpr Kinds rows[] = {{VESICA_RECT, VESICA_RECT, 60},
                            {VESICA_RECT, VESICA_ELLIPSE, 0},
                            {VESICA_CIRCLE, VESICA_ELLIPSE, 0},
                            {VESICA_ELLIPSE, VESICA_ELLIPSE, 1500},
                            {VESICA_RECT, VESICA_CAPSULE, 0},
                            {VESICA_CAPSULE, VESICA_CAPSULE, 0},
                            {VESICA_ROUND_RECT, VESICA_ROUND_RECT, 400},
                            {VESICA_ELLIPSE, VESICA_ROUND_RECT, 0}};
  for (const Kinds& kinds : rows) {
    for (const Data data : all_data) {
      if (!(is_rounded(kinds) && data == Data::thin)) report_pair(out, kinds, data);
    }
  }
}

void report_suppression(std::FILE* out) {
  constexpr std::size_t most_by_textbook = 10000;  // it is quadratic
  std::fprintf(out, "\n%-28s %10s %10s %10s %9s %12s %8s\n", "nms/rect/f64/count", "kept", "ms", "ns a box", "to 10000",
               "textbook ms", "ratio");
  for (const double side_per_root : {4.0, 1.0}) {
    double each_of_10000 = 0;
    for (const std::size_t count : {1000, 10000, 100000, 1000000}) {
      Random random(seed_of_run());
      const Detections d = detections(count, side_per_root * std::sqrt(static_cast<double>(count)), random);
      std::int64_t kept = 0, kept_by_textbook = 0;
      double library = milliseconds(d, suppress, kept);
      for (int again = 0; again < 2; ++again) library = std::min(library, milliseconds(d, suppress, kept));
      const double each = library * 1e6 / static_cast<double>(count);
      if (count == 10000) each_of_10000 = each;
      std::fprintf(out, "%-20s%8zu %10" PRId64 " %10.2f %10.0f", side_per_root > 2 ? "sparse" : "crowded", count, kept,
                   library, each);
      if (each_of_10000 > 0) {
        std::fprintf(out, " %9.2f", each / each_of_10000);
      } else {
        std::fprintf(out, " %9s", "");
      }
      if (count <= most_by_textbook) {
        const double textbook = milliseconds(d, suppress_by_textbook, kept_by_textbook);
        std::fprintf(out, " %12.1f %8.0f%s", textbook, textbook / library,
                     kept == kept_by_textbook ? "" : "  (it keeps others)");
      }
      std::fprintf(out, "\n");
    }
  }
}

}  // namespace vesica::bench
