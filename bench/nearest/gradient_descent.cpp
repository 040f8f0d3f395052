// SPDX-License-Identifier: Apache-2.0
/// The named method: descent over the angles of a point on each of two ellipses, with its own settings.
#include <vesica_methods.h>

#include "nearest/contestant.hpp"

namespace vesica::bench {
namespace {

bool ellipses(std::int32_t kind_a, std::int32_t kind_b) { return kind_a == VESICA_ELLIPSE && kind_b == VESICA_ELLIPSE; }

class Descents final : public DistancePairs {
 public:
  explicit Descents(std::span<const OutlinePair> pairs) {
    for (const OutlinePair& p : pairs) {
      a_.push_back(to_shape<vesica_ellipse_f64>(p.a));
      b_.push_back(to_shape<vesica_ellipse_f64>(p.b));
    }
  }

  double distance(std::size_t pair) override {
    vesica_descent_result_f64 out;
    vesica_method_ellipse_ellipse_distance_gradient_descent_f64(&a_[pair], &b_[pair], nullptr, &out, nullptr, 0);
    return out.distance;
  }

 private:
  std::vector<vesica_ellipse_f64> a_, b_;
};

std::unique_ptr<DistancePairs> make(std::int32_t, std::int32_t, std::span<const OutlinePair> pairs) {
  return std::make_unique<Descents>(pairs);
}

const bool added = add_contestant({"gradient descent", ellipses, make, 4});

}  // namespace
}  // namespace vesica::bench
