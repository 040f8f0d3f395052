// SPDX-License-Identifier: Apache-2.0
/// Distance of outlines by gradient descent. Uncertain: not converged. Wrong: converged, and off by more than a
/// millionth of the half lengths and the distance.
#include <algorithm>
#include <cmath>

#include "methods/method.hpp"

namespace vesica::bench::methods {
namespace {

using Ellipse = vesica_ellipse_f64;

double length_of(const Ellipse& e) { return std::hypot(e.ux, e.uy) * std::max(e.a, e.b); }

double exact_distance(const Ellipse& a, const Ellipse& b) {
  vesica_closest_points_f64 closest;
  const std::int32_t code = vesica_boundary_distance_f64(VESICA_ELLIPSE, &a, VESICA_ELLIPSE, &b, &closest);
  return code == 0 ? closest.distance : -1;
}

class DistanceContest final : public Contest {
 public:
  explicit DistanceContest(std::int32_t schedule) { vesica_method_descent_settings_f64(schedule, &settings_); }

  void load(const Pool& pool) override {
    for (std::size_t i = 0; i < most; ++i) {
      all_a_.push_back(to_shape<Ellipse>(pool.a[i]));
      all_b_.push_back(to_shape<Ellipse>(pool.b[i]));
    }
  }

  void unload() override {
    all_a_.clear();
    all_b_.clear();
  }

  std::size_t pairs() const override { return a_.size(); }

  void draw(Random& random) override {
    for (std::size_t i = 0; i < pairs(); ++i) {
      const std::size_t index = random.index(most);
      a_[i] = all_a_[index];
      b_[i] = all_b_[index];
    }
  }

  std::int64_t method_sum() const override {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < pairs(); ++i) sum += run(a_[i], b_[i]).iterations;
    return sum;
  }

  std::int64_t exact_sum() const override {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < pairs(); ++i) sum += exact_distance(a_[i], b_[i]) > 0;
    return sum;
  }

  void count(Outcome& outcome) const override {
    for (std::size_t i = 0; i < most; ++i) {
      const vesica_descent_result_f64 result = run(all_a_[i], all_b_[i]);
      const double distance = exact_distance(all_a_[i], all_b_[i]);
      const double scale = length_of(all_a_[i]) + length_of(all_b_[i]) + distance;
      ++outcome.asked;
      if (result.success == 0) {
        ++outcome.uncertain;
      } else {
        outcome.wrong += std::fabs(result.distance - distance) > 1e-6 * scale;
      }
    }
  }

 private:
  static constexpr std::size_t most = 4096;

  vesica_descent_result_f64 run(const Ellipse& a, const Ellipse& b) const {
    vesica_descent_result_f64 result{};
    vesica_method_ellipse_ellipse_distance_gradient_descent_f64(&a, &b, &settings_, &result, nullptr, 0);
    return result;
  }

  vesica_descent_settings_f64 settings_{};
  std::array<Ellipse, 32> a_{}, b_{};
  std::vector<Ellipse> all_a_, all_b_;
};

void add(std::vector<Method>& methods, const char* name, std::int32_t schedule) {
  methods.push_back({name,
                     "ellipse_ellipse, distance of outlines",
                     "vesica_boundary_distance",
                     {VESICA_ELLIPSE, VESICA_ELLIPSE, Axes::any},
                     std::make_unique<DistanceContest>(schedule),
                     {}});
}

}  // namespace

void add_ellipse_ellipse_distance(std::vector<Method>& methods) {
  add(methods, "ellipse_ellipse_distance_gradient_descent", VESICA_SCHEDULE_SCALE_AWARE);
  add(methods, "the same, schedule as printed", VESICA_SCHEDULE_LITERAL);
}

}  // namespace vesica::bench::methods
