// SPDX-License-Identifier: Apache-2.0
/// Boxes to shapes and back, corners and bounds, in arrays, beside the loops that one writes without the library: these
/// check nothing, and 90 degrees are not a right angle to them. Every pass has boxes that were not seen before.
#include <vesica.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "quantile.hpp"
#include "random.hpp"

namespace {

using Clock = std::chrono::steady_clock;
using vesica::bench::median;
constexpr std::int64_t count = 1000;
constexpr int passes = 300;
constexpr double degree = 0.017453292519943295;

struct Box {
  double cx, cy, width, height, angle;
};

struct Pass {
  std::vector<Box> boxes;
  std::vector<vesica_rect_f64> rects;
  std::vector<double> corners;
  std::vector<double> out;
  vesica_shapes_f64 shapes;
};

void draw(vesica::bench::Random& random, Pass& pass) {
  pass.boxes.resize(count);
  pass.rects.resize(count);
  pass.corners.resize(8 * count);
  pass.out.resize(8 * count);
  for (Box& b : pass.boxes) {
    b = {random.between(-9, 9), random.between(-9, 9), random.between(0, 3), random.between(0, 3),
         random.between(-180, 180)};
  }
  vesica_rects_from_boxes_f64(&pass.boxes[0].cx, count, sizeof(Box), VESICA_ANGLE_DEGREES, pass.rects.data());
  vesica_shapes_from_records_f64(VESICA_RECT, count, pass.rects.data(), sizeof pass.rects[0], &pass.shapes);
  vesica_corners_of_shapes_f64(&pass.shapes, pass.corners.data());
}

template <class Loop>
double nanoseconds(const Loop& loop, Pass& pass) {
  const Clock::time_point start = Clock::now();
  loop(pass);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count() / count;
}

template <class Library, class Textbook>
void row(const char* name, const Library& library, const Textbook& textbook) {
  vesica::bench::Random random(7);
  Pass pass;
  std::vector<double> ours, theirs, ratio;
  double sum = 0;
  for (int i = 0; i < passes; ++i) {
    draw(random, pass);
    ours.push_back(nanoseconds(library, pass));
    sum += pass.out[static_cast<std::size_t>(i)];
    draw(random, pass);
    theirs.push_back(nanoseconds(textbook, pass));
    sum += pass.out[static_cast<std::size_t>(i)];
    ratio.push_back(ours.back() / theirs.back());
  }
  volatile double used = sum;
  static_cast<void>(used);
  std::printf("%-28s %8.1f %10.1f %8.2f\n", name, median(ours), median(theirs), median(ratio));
}

void rects_by_hand(Pass& pass) {
  auto* out = reinterpret_cast<vesica_rect_f64*>(pass.out.data());
  for (const Box& b : pass.boxes) {
    const double angle = b.angle * degree;
    *out++ = {b.cx, b.cy, std::cos(angle), std::sin(angle), b.width / 2, b.height / 2};
  }
}

void rects_from_corners_by_hand(Pass& pass) {
  auto* out = reinterpret_cast<vesica_rect_f64*>(pass.out.data());
  for (const double* c = pass.corners.data(); c < pass.corners.data() + pass.corners.size(); c += 8) {
    const double ux = c[2] - c[0], uy = c[3] - c[1], vx = c[4] - c[2], vy = c[5] - c[3];
    const double width = std::sqrt(ux * ux + uy * uy), height = std::sqrt(vx * vx + vy * vy);
    *out++ = {(c[0] + c[2] + c[4] + c[6]) / 4,
              (c[1] + c[3] + c[5] + c[7]) / 4,
              ux / width,
              uy / width,
              width / 2,
              height / 2};
  }
}

void boxes_by_hand(Pass& pass) {
  auto* out = reinterpret_cast<Box*>(pass.out.data());
  for (const vesica_rect_f64& r : pass.rects) {
    const double length = std::hypot(r.ux, r.uy);
    *out++ = {r.cx, r.cy, 2 * r.hx * length, 2 * r.hy * length, std::atan2(r.uy, r.ux) / degree};
  }
}

void corners_by_hand(Pass& pass) {
  double* out = pass.out.data();
  constexpr double along[] = {-1, 1, 1, -1}, across[] = {-1, -1, 1, 1};
  for (const vesica_rect_f64& r : pass.rects) {
    for (int i = 0; i < 4; ++i) {
      *out++ = r.cx + along[i] * r.hx * r.ux - across[i] * r.hy * r.uy;
      *out++ = r.cy + along[i] * r.hx * r.uy + across[i] * r.hy * r.ux;
    }
  }
}

void bounds_by_hand(Pass& pass) {
  auto* out = reinterpret_cast<vesica_aabb_f64*>(pass.out.data());
  for (const vesica_rect_f64& r : pass.rects) {
    const double x = r.hx * std::fabs(r.ux) + r.hy * std::fabs(r.uy);
    const double y = r.hx * std::fabs(r.uy) + r.hy * std::fabs(r.ux);
    *out++ = {r.cx - x, r.cy - y, r.cx + x, r.cy + y};
  }
}

}  // namespace

int main() {
  std::printf("Arrays of %lld boxes, double, degrees. ns an element, medians of %d passes.\n",
              static_cast<long long>(count), passes);
  std::printf("%-28s %8s %10s %8s\n", "", "vesica", "by hand", "ratio");
  row(
      "vesica_rects_from_boxes",
      [](Pass& p) {
        vesica_rects_from_boxes_f64(&p.boxes[0].cx, count, sizeof(Box), VESICA_ANGLE_DEGREES,
                                    reinterpret_cast<vesica_rect_f64*>(p.out.data()));
      },
      rects_by_hand);
  row(
      "vesica_rects_from_corners",
      [](Pass& p) {
        vesica_rects_from_corners_f64(p.corners.data(), count, 8 * sizeof(double),
                                      reinterpret_cast<vesica_rect_f64*>(p.out.data()));
      },
      rects_from_corners_by_hand);
  row(
      "vesica_boxes_from_shapes",
      [](Pass& p) { vesica_boxes_from_shapes_f64(&p.shapes, VESICA_ANGLE_DEGREES, p.out.data()); }, boxes_by_hand);
  row(
      "vesica_corners_of_shapes", [](Pass& p) { vesica_corners_of_shapes_f64(&p.shapes, p.out.data()); },
      corners_by_hand);
  row(
      "vesica_bounds_many",
      [](Pass& p) { vesica_bounds_many_f64(&p.shapes, reinterpret_cast<vesica_aabb_f64*>(p.out.data())); },
      bounds_by_hand);
}
