// SPDX-License-Identifier: Apache-2.0
#include "batch/scalar_calls.hpp"

#include <map>
#include <tuple>

#include "batch/contest.hpp"
#include "batch/pools.hpp"
#include "pair.hpp"

namespace vesica::bench {
namespace {

struct ScalarCall {
  std::int32_t kind_a, kind_b;
  bool single;
  double (*time)(const Pool& pool);
};

/// The passes of the scalar benchmark, in this one's contest.
template <auto call>
double time_of_call(const Pool& pool) {
  TypedPasses<call, nullptr> passes;
  passes.load(pool);
  const auto prepare = [&](std::uint64_t round) {
    Random random(seed_of_run() + round);
    passes.draw(random, pairs_per_pass);
  };
  const auto times = contest(prepare, {[&] { return passes.library_hits(); }}, {.seconds = 0.03, .rounds = 101});
  return median(times[0]) / static_cast<double>(pairs_per_pass);
}

template <auto... call>
std::vector<ScalarCall> list_of() {
  return {{kind_of<typename Arguments<decltype(call)>::A>, kind_of<typename Arguments<decltype(call)>::B>,
           std::is_same_v<typename Described<typename Arguments<decltype(call)>::A>::Scalar, float>,
           time_of_call<call>}...};
}

std::vector<ScalarCall> calls_f64() {
  return list_of<vesica_overlap_point_point_f64, vesica_overlap_point_segment_f64, vesica_overlap_point_circle_f64,
                 vesica_overlap_point_aabb_f64, vesica_overlap_point_rect_f64, vesica_overlap_point_ellipse_f64,
                 vesica_overlap_segment_segment_f64, vesica_overlap_segment_circle_f64, vesica_overlap_segment_aabb_f64,
                 vesica_overlap_segment_rect_f64, vesica_overlap_segment_ellipse_f64, vesica_overlap_circle_circle_f64,
                 vesica_overlap_circle_aabb_f64, vesica_overlap_circle_rect_f64, vesica_overlap_circle_ellipse_f64,
                 vesica_overlap_aabb_aabb_f64, vesica_overlap_aabb_rect_f64, vesica_overlap_aabb_ellipse_f64,
                 vesica_overlap_rect_rect_f64, vesica_overlap_rect_ellipse_f64, vesica_overlap_ellipse_ellipse_f64>();
}

std::vector<ScalarCall> calls_f32() {
  return list_of<vesica_overlap_point_point_f32, vesica_overlap_point_segment_f32, vesica_overlap_point_circle_f32,
                 vesica_overlap_point_aabb_f32, vesica_overlap_point_rect_f32, vesica_overlap_point_ellipse_f32,
                 vesica_overlap_segment_segment_f32, vesica_overlap_segment_circle_f32, vesica_overlap_segment_aabb_f32,
                 vesica_overlap_segment_rect_f32, vesica_overlap_segment_ellipse_f32, vesica_overlap_circle_circle_f32,
                 vesica_overlap_circle_aabb_f32, vesica_overlap_circle_rect_f32, vesica_overlap_circle_ellipse_f32,
                 vesica_overlap_aabb_aabb_f32, vesica_overlap_aabb_rect_f32, vesica_overlap_aabb_ellipse_f32,
                 vesica_overlap_rect_rect_f32, vesica_overlap_rect_ellipse_f32, vesica_overlap_ellipse_ellipse_f32>();
}

double measured(const Spec& spec) {
  for (const ScalarCall& call : spec.single ? calls_f32() : calls_f64()) {
    if (call.kind_a == spec.kind_a && call.kind_b == spec.kind_b) {
      return call.time(pool_of(spec.kind_a, spec.kind_b, Workload::mixed));
    }
  }
  return 0;
}

}  // namespace

double scalar_time(const Spec& spec) {
  static std::map<std::tuple<std::int32_t, std::int32_t, bool>, double> known;
  double& time = known[{spec.kind_a, spec.kind_b, spec.single}];
  if (time == 0) time = measured(spec);
  return time;
}

}  // namespace vesica::bench
