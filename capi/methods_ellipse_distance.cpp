// SPDX-License-Identifier: Apache-2.0
#include <cstring>
#include <vesica/methods/ellipse_ellipse_distance_gradient_descent.hpp>

#include "methods.hpp"

static_assert(static_cast<int32_t>(vesica::methods::Schedule::scale_aware) == VESICA_SCHEDULE_SCALE_AWARE);
static_assert(static_cast<int32_t>(vesica::methods::Schedule::literal) == VESICA_SCHEDULE_LITERAL);
static_assert(vesica::methods::most_descent_iterations == VESICA_MOST_DESCENT_ITERATIONS);

namespace {

using vesica::methods::Schedule;

template <class T, class COut>
int32_t settings_of(int32_t schedule, COut* out) noexcept {
  static_assert(sizeof(COut) == sizeof(vesica::methods::DescentSettings<T>));
  VESICA_DEFAULT_ENVIRONMENT((settings_of<T, COut>), schedule, out);
  if (out == nullptr) return VESICA_E_NULL;
  if (schedule != VESICA_SCHEDULE_SCALE_AWARE && schedule != VESICA_SCHEDULE_LITERAL) return VESICA_E_ARGUMENT;
  const auto settings = vesica::methods::descent_settings<T>(static_cast<Schedule>(schedule));
  std::memcpy(out, &settings, sizeof settings);
  return 0;
}

template <class T, class CSettings, class COut>
int32_t distance(const void* a, const void* b, const CSettings* given, COut* out, T* errors,
                 int32_t capacity) noexcept {
  using Ellipse = vesica::Ellipse<T>;
  static_assert(sizeof(COut) == sizeof(vesica::methods::DescentResult<T>));
  VESICA_DEFAULT_ENVIRONMENT((distance<T, CSettings, COut>), a, b, given, out, errors, capacity);
  if (a == nullptr || b == nullptr || out == nullptr || (errors == nullptr && capacity > 0)) return VESICA_E_NULL;
  auto settings = vesica::methods::descent_settings<T>(Schedule::scale_aware);
  if (given != nullptr) std::memcpy(&settings, given, sizeof settings);
  vesica::methods::DescentResult<T> result;
  const int32_t answer = vesica::methods::gradient_descent_distance(
      vesica::shape_at<Ellipse>(a), vesica::shape_at<Ellipse>(b), settings, result, errors, capacity);
  if (answer >= 0) std::memcpy(out, &result, sizeof result);
  return answer;
}

}  // namespace

#define VESICA_METHODS(scalar, T)                                                                            \
  int32_t vesica_method_descent_settings_##scalar(int32_t schedule, vesica_descent_settings_##scalar* out) { \
    return settings_of<T>(schedule, out);                                                                    \
  }                                                                                                          \
  int32_t vesica_method_ellipse_ellipse_distance_gradient_descent_##scalar(                                  \
      const vesica_ellipse_##scalar* a, const vesica_ellipse_##scalar* b,                                    \
      const vesica_descent_settings_##scalar* settings, vesica_descent_result_##scalar* out, T* errors,      \
      int32_t capacity) {                                                                                    \
    return distance<T>(a, b, settings, out, errors, capacity);                                               \
  }

VESICA_METHODS(f64, double)
VESICA_METHODS(f32, float)
#undef VESICA_METHODS
