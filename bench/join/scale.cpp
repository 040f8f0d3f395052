// SPDX-License-Identifier: Apache-2.0
/// Rows without peers: kinds, growth, memory, threads, frames.
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>

#include "join/measure.hpp"
#include "join/rows.hpp"

namespace vesica::bench {
namespace {

std::vector<vesica_shapes_f64> views(const index_tests::Laid<double>& laid) {
  std::vector<vesica_shapes_f64> sets(laid.size());
  for (std::size_t i = 0; i < laid.size(); ++i) {
    const std::ptrdiff_t record = vesica_field_count(laid[i].kind) * static_cast<std::ptrdiff_t>(sizeof(double));
    vesica_shapes_from_records_f64(laid[i].kind, laid[i].count(), laid[i].numbers.data(), record, &sets[i]);
  }
  return sets;
}

double nanoseconds_a_shape(std::int64_t n, int repeats) {
  const auto shapes_a = draw("uniform", n, 1), shapes_b = draw("uniform", n, 2);
  const Operand a({view(shapes_a)}), b({view(shapes_b)});
  return least(a, b, Scratch(n), repeats).total() * 1e9 / (2.0 * static_cast<double>(n));
}

double resident_bytes() {
  long long all = 0, resident = 0;
  if (FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lld %lld", &all, &resident) != 2) resident = 0;
    std::fclose(file);
  }
  return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

/// Seconds on the clock until this number of threads has joined all parts.
double joined_by(int threads, const Operand& a, const Operand& b) {
  const std::int64_t parts = 8 * threads;
  std::atomic<std::int64_t> next{0};
  const auto begin = std::chrono::steady_clock::now();
  std::vector<std::thread> all;
  for (int i = 0; i < threads; ++i) {
    all.emplace_back([&] {
      const Memory scratch(vesica_join_scratch());
      for (std::int64_t part = next++; part < parts; part = next++) join(a, b, part, parts, scratch);
    });
  }
  for (std::thread& t : all) t.join();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Frame {
  double build, join;  // seconds
};

/// The median of several frames, between which every rectangle moves.
Frame median_frame(std::int64_t n) {
  constexpr int frames = 31;
  auto shapes = draw("uniform", n, 1);
  const auto moves = draw("uniform", n, 2);
  const Operand set({view(shapes)});
  const Scratch scratch(n);
  std::vector<Frame> all;
  for (int frame = 0; frame < frames; ++frame) {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      shapes[i].cx += 0.1 * moves[i].ux;
      shapes[i].cy += 0.1 * moves[i].uy;
    }
    Times times;
    build(set, scratch, times);
    const double begin = seconds();
    join(set, set, 0, 1, scratch.join);
    all.push_back({times.build(), seconds() - begin});
  }
  std::ranges::nth_element(all, all.begin() + frames / 2, {}, [](const Frame& f) { return f.build + f.join; });
  return all[frames / 2];
}

}  // namespace

void report_kinds(std::int64_t n, int repeats) {
  const auto shapes_a = draw("uniform", n, 1), shapes_b = draw("uniform", n, 2);
  const auto mixed_a = index_tests::mixed<double>("uniform", n, 1),
             mixed_b = index_tests::mixed<double>("uniform", n, 2);
  const Scratch scratch(n);
  const Times rects = least(Operand({view(shapes_a)}), Operand({view(shapes_b)}), scratch, repeats);
  const Times kinds = least(Operand(views(mixed_a)), Operand(views(mixed_b)), scratch, repeats);
  std::printf("six kinds: %.1f ns a candidate, rectangles alone %.1f: x%.2f\n", kinds.decide_each(),
              rects.decide_each(), kinds.decide_each() / rects.decide_each());
}

void report_growth(std::int64_t n, int repeats) {
  const double one = nanoseconds_a_shape(n, repeats), ten = nanoseconds_a_shape(10 * n, std::min(repeats, 3));
  std::printf("growth: %.1f ns/shape of %lld, %.1f of ten times as many: x%.2f\n", one, static_cast<long long>(n), ten,
              ten / one);
}

void report_memory(std::int64_t n) {
  const auto shapes_a = draw("uniform", n, 1), shapes_b = draw("uniform", n, 2);
  const double before = resident_bytes();
  const Operand a({view(shapes_a)}), b({view(shapes_b)});
  const Scratch scratch(n);
  least(a, b, scratch, 1);
  std::printf("memory: %.1f bytes a shape of both sides\n",
              (resident_bytes() - before) / (2.0 * static_cast<double>(n)));
}

void report_threads(std::int64_t n, int repeats) {
  const auto shapes_a = draw("uniform", n, 1), shapes_b = draw("uniform", n, 2);
  const Operand a({view(shapes_a)}), b({view(shapes_b)});
  least(a, b, Scratch(n), 1);
  double one = joined_by(1, a, b), two = joined_by(2, a, b);
  for (int i = 1; i < repeats; ++i) {
    one = std::min(one, joined_by(1, a, b));
    two = std::min(two, joined_by(2, a, b));
  }
  std::printf("threads: two join x%.2f as fast as one\n", one / two);
}

void report_frame() {
  constexpr double room = 1.0 / 60;
  std::int64_t n = 100000;
  Frame frame = median_frame(n);
  // The cost of a shape hardly changes with their number: a few steps find the number that fits.
  for (int i = 0; i < 3; ++i) {
    n = static_cast<std::int64_t>(static_cast<double>(n) * room / (frame.build + frame.join));
    frame = median_frame(n);
  }
  const double each = 1e9 / static_cast<double>(n);
  std::printf("frame: %lld moving rectangles at %.0f frames a second: build %.1f ns, join %.1f ns each\n",
              static_cast<long long>(n), 1 / (frame.build + frame.join), frame.build * each, frame.join * each);
}

}  // namespace vesica::bench
