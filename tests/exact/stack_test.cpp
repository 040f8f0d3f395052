// SPDX-License-Identifier: Apache-2.0
// vesica.h promises that a call about two shapes uses at most 64 KiB of stack. Every such call is measured on a stack
// painted beforehand: where the paint is gone, it was used. For every pair of kinds, at exponents that make the exact
// stage's numbers their widest.
#include <gtest/gtest.h>
#include <pthread.h>
#include <vesica.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "capi/face.hpp"
#include "properties/random.hpp"

namespace {

constexpr std::size_t promised = 64 * 1024;
constexpr std::size_t stack_size = 256 * 1024;
constexpr unsigned char paint = 0xa5;

/// A stack of our own, and how far below its caller's frame a call reached.
class PaintedStack {
 public:
  std::size_t used_by(std::function<void()> call) {
    std::fill(memory_.begin(), memory_.end(), paint);
    call_ = std::move(call);
    pthread_attr_t attributes;
    pthread_t thread;
    EXPECT_EQ(pthread_attr_init(&attributes), 0);
    EXPECT_EQ(pthread_attr_setstack(&attributes, aligned(), stack_size), 0);
    EXPECT_EQ(pthread_create(&thread, &attributes, run, this), 0);
    EXPECT_EQ(pthread_join(thread, nullptr), 0);
    pthread_attr_destroy(&attributes);
    return static_cast<std::size_t>(caller_ -
                                    std::find_if(aligned(), caller_, [](unsigned char c) { return c != paint; }));
  }

 private:
  [[gnu::noinline]] static void* run(void* stack) {
    auto* const self = static_cast<PaintedStack*>(stack);
    self->caller_ = static_cast<unsigned char*>(__builtin_frame_address(0));
    self->call_();
    return nullptr;
  }
  unsigned char* aligned() {
    const auto address = reinterpret_cast<std::uintptr_t>(memory_.data());
    return memory_.data() + (alignment - address % alignment) % alignment;
  }

  static constexpr std::size_t alignment = 64 * 1024;
  std::vector<unsigned char> memory_ = std::vector<unsigned char>(stack_size + alignment);
  std::function<void()> call_;
  unsigned char* caller_ = nullptr;
};

[[gnu::noinline]] void use(std::size_t bytes) {
  auto* const memory = static_cast<volatile unsigned char*>(__builtin_alloca(bytes));
  for (std::size_t i = 0; i < bytes; ++i) memory[i] = 1;
}

TEST(Stack, MeasureSeesWhatIsUsed) {
  PaintedStack stack;
  const std::size_t used = stack.used_by([] { use(100'000); });
  EXPECT_GE(used, 100'000U);
  EXPECT_LT(used, 101'000U);
  // A thread's exit itself reaches a few kilobytes deep: calls that use less all measure the same.
  EXPECT_LT(stack.used_by([] { use(10); }), 16'384U);
}

constexpr int most_fields = 7;

/// Two shapes of any kinds, in vesica.h's order.
struct Shapes {
  int kind_a, kind_b;
  double a[most_fields], b[most_fields];
};

/// Numbers at both ends of the range: differences and products have as many bits as they can.
Shapes at_the_ends(int kind_a, int kind_b, properties::Random& random) {
  constexpr double ends[] = {DBL_MAX, 0x1.5555555555555p1023, 0x1.fffffffffffffp-1022, 0x1p-1074,
                             0x0.aaaaaaaaaaaaap-1022};
  Shapes shapes{kind_a, kind_b, {}, {}};
  const auto draw = [&](int kind, double* n) {
    for (int i = 0; i < most_fields; ++i) n[i] = ends[random.below(5)] * random.sign();
    for (int i = kind == VESICA_CIRCLE ? 2 : 4; i < most_fields; ++i) n[i] = n[i] < 0 ? -n[i] : n[i];
    if (kind != VESICA_AABB) return;
    if (n[0] > n[2]) std::swap(n[0], n[2]);
    if (n[1] > n[3]) std::swap(n[1], n[3]);
  };
  draw(kind_a, shapes.a);
  draw(kind_b, shapes.b);
  return shapes;
}

/// Ellipses with one axis v and half length 1 along it, at -v and v: they touch at the origin, so that both products of
/// the discriminant are needed in full. v spans the range, and so do the other half lengths.
Shapes touching_ellipses() {
  return {
      VESICA_ELLIPSE,
      VESICA_ELLIPSE,
      {-0x1.5555555555555p1022, -0x1.2345678p-1050, 0x1.5555555555555p1022, 0x1.2345678p-1050, 1, 0x1.89abcdefp-1050},
      {0x1.5555555555555p1022, 0x1.2345678p-1050, 0x1.5555555555555p1022, 0x1.2345678p-1050, 1,
       0x1.fffffffffffffp1023}};
}

/// Ellipses with one axis v, the second half as long along it and touching the first from inside at v.
Shapes nested_ellipses() {
  return {
      VESICA_ELLIPSE,
      VESICA_ELLIPSE,
      {0, 0, 0x1.5555555555555p1022, 0x1.2345678p-1050, 1, 0x1.89abcdefp1},
      {0x1.5555555555555p1021, 0x1.2345678p-1051, 0x1.5555555555555p1022, 0x1.2345678p-1050, 0.5, 0x1.2345678p-1050}};
}

using Query = std::int32_t (*)(std::int32_t, const void*, std::int32_t, const void*);

std::size_t used_by(PaintedStack& stack, Query query, const Shapes& s) {
  std::int32_t answer = VESICA_E_NULL;
  const std::size_t used = stack.used_by([&] { answer = query(s.kind_a, s.a, s.kind_b, s.b); });
  // Some questions refuse some pairs with a capsule or a rounded rectangle (properties/refused_test.cpp).
  const bool is_refused = answer == VESICA_E_KIND && s.kind_b >= VESICA_CAPSULE;
  EXPECT_TRUE(answer >= 0 || is_refused) << vesica_strerror(answer);
  return used;
}

/// Results beyond the finite numbers are answers here.
std::int32_t answer(std::int64_t code) { return static_cast<std::int32_t>(code == VESICA_E_RANGE ? 0 : code); }

template <auto function, class Out>
std::int32_t ask(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  Out out;
  return answer(function(kind_a, a, kind_b, b, &out));
}
/// A pair without area has no ratio, which is an answer too.
std::int32_t ratio(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  std::int32_t worst = 0;
  for (const std::int32_t ratio : {VESICA_RATIO_OVER_UNION, VESICA_RATIO_OVER_SMALLER, VESICA_RATIO_COMPLETE}) {
    double out;
    for (const std::int32_t code :
         {vesica_ratio_f64(ratio, kind_a, a, kind_b, b, &out), vesica_iou_f64(kind_a, a, kind_b, b, &out)}) {
      worst = std::min(worst, code == VESICA_E_ARGUMENT ? 0 : answer(code));
    }
  }
  return worst;
}
/// A tiny distance, the distance as computed, and a last place beside that; depths likewise.
std::int32_t within(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  vesica_closest_points_f64 found;
  vesica_penetration_f64 deep;
  if (vesica_nearest_f64(kind_a, a, kind_b, b, &found) != 0) found.distance = DBL_MAX;
  if (vesica_depth_f64(kind_a, a, kind_b, b, &deep) != 0) deep.depth = DBL_MAX;
  std::int32_t worst = 0;
  for (const double d : {0x1.2345678p-1050, found.distance, std::nextafter(found.distance, 0.0), -0x1.2345678p-1050,
                         -deep.depth, -std::nextafter(deep.depth, 0.0)}) {
    worst = std::min(worst, vesica_within_f64(kind_a, a, kind_b, b, d));
  }
  return worst;
}
std::int32_t de9im(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  char matrix[16];
  return answer(vesica_de9im_f64(kind_a, a, kind_b, b, matrix));
}
std::int32_t crossings(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  vesica_point_f64 out[8];
  std::int32_t shared;
  return answer(vesica_crossings_f64(kind_a, a, kind_b, b, out, 8, &shared));
}
/// Pairs with a rounded region have no vertices: VESICA_E_KIND is an answer too.
std::int32_t intersection(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  vesica_point_f64 out[8];
  const std::int64_t code = vesica_intersection_f64(kind_a, a, kind_b, b, out, 8);
  return code == VESICA_E_KIND ? 0 : answer(code);
}
/// The calls about one shape.
std::int32_t each_alone(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  std::int32_t worst = 0;
  const auto add = [&worst](std::int64_t code) { worst = std::min(worst, answer(code)); };
  for (const auto& [kind, shape] : {std::pair{kind_a, a}, std::pair{kind_b, b}}) {
    vesica_aabb_f64 box;
    double area;
    add(vesica_check_f64(kind, shape));
    add(vesica_bounds_f64(kind, shape, &box));
    add(vesica_sweep_bounds_f64(kind, shape, 0x1p1000, 0x1p-1050, 1, &box));
    if (kind >= VESICA_CIRCLE) add(vesica_shape_area_f64(kind, shape, &area));
  }
  return worst;
}
std::int32_t impact_time(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  const vesica_turn_f64 turn_a{0x1p-1050, 0, 1}, turn_b{0x1p1000, 0x1p-1050, 0.5};
  vesica_impact_f64 out;
  double gap;
  return answer(vesica_impact_time_f64(kind_a, a, &turn_a, kind_b, b, &turn_b, 0x1p-10, &out, &gap));
}

/// Shapes moved apart and towards each other again: so contact at the start is contact on the way, at a time of about
/// 1.
std::int32_t cast(std::int32_t kind_a, const void* a, std::int32_t kind_b, const void* b) {
  double apart[most_fields];
  std::copy_n(static_cast<const double*>(b), vesica_field_count(kind_b), apart);
  const bool corners = kind_b == VESICA_SEGMENT || kind_b == VESICA_AABB || kind_b == VESICA_CAPSULE;
  const double vx = 0x1p1019, vy = 0x1.3333p1018;
  for (int i = 0; i < (corners ? 4 : 2); ++i) apart[i] = apart[i] / 8 + (i % 2 == 0 ? vx : vy);
  vesica_impact_f64 out;
  std::int32_t worst = 0;
  for (const double end : {1.0, 0.7, HUGE_VAL}) {
    for (const void* moving : {b, static_cast<const void*>(apart)}) {
      const std::int32_t code = vesica_cast_f64(kind_a, a, kind_b, moving, -vx, -vy, end, &out);
      worst = code < 0 && code != VESICA_E_RANGE ? code : worst;
    }
  }
  return worst;
}

/// The most that any query of two shapes uses.
std::size_t used_by(PaintedStack& stack, const Shapes& s) {
  std::size_t most = 0;
  using Points = vesica_closest_points_f64;
  constexpr Query queries[] = {vesica_overlap_f64,
                               vesica_relation_f64,
                               vesica_contains_f64,
                               ask<vesica_area_f64, double>,
                               ask<vesica_nearest_f64, Points>,
                               ask<vesica_boundary_distance_f64, Points>,
                               ask<vesica_depth_f64, vesica_penetration_f64>,
                               ask<vesica_manifold_f64, vesica_contacts_f64>,
                               ask<vesica_signed_distance_f64, double>,
                               ratio,
                               within,
                               de9im,
                               crossings,
                               intersection,
                               each_alone,
                               cast,
                               impact_time};
  for (const Query query : queries) {
    most = std::max(most, used_by(stack, query, s));
  }
  return most;
}

TEST(Stack, AtMostAsPromised) {
  PaintedStack stack;
  properties::Random random(properties::seed());
  std::size_t most_of_all = 0;
  for (int a = VESICA_POINT; a <= VESICA_ROUND_RECT; ++a) {
    for (int b = a; b <= VESICA_ROUND_RECT; ++b) {
      std::size_t most = 0;
      for (int i = 0; i < 20 * properties::repeat(); ++i) {
        most = std::max(most, used_by(stack, at_the_ends(a, b, random)));
      }
      if (a == VESICA_ELLIPSE && b == VESICA_ELLIPSE) {
        EXPECT_EQ(vesica_overlap_f64(a, touching_ellipses().a, b, touching_ellipses().b), 1);
        most = std::max(most, used_by(stack, touching_ellipses()));
        EXPECT_EQ(vesica_relation_f64(a, nested_ellipses().a, b, nested_ellipses().b), VESICA_CONTAINS_TOUCH);
        most = std::max(most, used_by(stack, nested_ellipses()));
        // Five numbers of degree 16 or more: else the exact stage was not reached, and there was nothing to measure.
        EXPECT_GT(most, 30'000U);
      }
      EXPECT_LE(most, promised) << vesica_kind_name(a) << " " << vesica_kind_name(b);
      std::printf("  %-10s %-10s %6zu bytes\n", vesica_kind_name(a), vesica_kind_name(b), most);
      most_of_all = std::max(most_of_all, most);
    }
  }
  RecordProperty("most_bytes_of_stack", std::to_string(most_of_all));
}

/// An ellipse that a core with a radius holds, at contacts that take every stage of the decision; and at exponents that
/// make its numbers their widest.
TEST(Stack, AtMostAsPromisedOfAnEllipseInARoundedShape) {
  struct Contact {
    int kind;
    double ellipse[6], shape[7];
    int relation;
  };
  const Contact contacts[] = {
      {VESICA_ROUND_RECT, {0, 0, 1, 0, 80, 45}, {-441, -173, 15, -8, 20, 20, 75}, VESICA_INSIDE_TOUCH},
      {VESICA_ROUND_RECT, {0, 0, 1, 0, 585, 325}, {-1479, -752, 5, 12, 100, 100, 338}, VESICA_CROSS},
      {VESICA_CAPSULE, {0, 0, 1, 0, 240, 135}, {0, -175, 0, -1000, 320}, VESICA_INSIDE_TOUCH},
      {VESICA_CAPSULE, {0, 0, 1, 0, 5, 4}, {-2, 0, 2, 0, 3}, VESICA_CONTAINS_TOUCH},
  };
  PaintedStack stack;
  std::size_t most = 0;
  const auto measure = [&](const Contact& c, int expected) {
    std::int32_t answer = VESICA_E_NULL;
    const auto used = stack.used_by([&] { answer = vesica_relation_f64(VESICA_ELLIPSE, c.ellipse, c.kind, c.shape); });
    if (expected >= 0) {
      EXPECT_EQ(answer, expected);
    } else {
      EXPECT_GE(answer, 0) << vesica_strerror(answer);
    }
    most = std::max(most, used);
  };
  for (const Contact& c : contacts) measure(c, c.relation);
  properties::Random random(properties::seed());
  for (int i = 0; i < 40 * properties::repeat(); ++i) {
    Contact wide = contacts[random.below(4)];
    for (double& x : wide.ellipse) x *= 1 + random.between(0, 0x1p-40);
    for (double& x : wide.shape) x = std::ldexp(x, random.integer(-1000, 1000));
    measure(wide, -1);
  }
  EXPECT_GT(most, 30'000U);
  EXPECT_LE(most, promised);
  std::printf("  ellipse, core with a radius %6zu bytes\n", most);
}

}  // namespace
