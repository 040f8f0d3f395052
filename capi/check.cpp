// SPDX-License-Identifier: Apache-2.0
#include <vesica/check.hpp>
#include <vesica/polygon/facts.hpp>

#include "by_kind.hpp"
#include "environment.hpp"
#include "vesica.h"

namespace {

template <class T>
int32_t check_shape(int32_t kind, const void* shape) noexcept {
  VESICA_DEFAULT_ENVIRONMENT(check_shape<T>, kind, shape);
  return vesica::with_shape<T>(kind, shape, [](const auto& s) {
    if constexpr (vesica::Path<std::remove_cvref_t<decltype(s)>>) {
      return vesica::check_simple(s);
    } else {
      return vesica::check(s);
    }
  });
}

template <class T, class CPolygon, class CFacts>
int32_t polygon_facts(const CPolygon* polygon, CFacts* out) noexcept {
  VESICA_DEFAULT_ENVIRONMENT((polygon_facts<T, CPolygon, CFacts>), polygon, out);
  static_assert(sizeof(vesica::PolygonFacts<T>) == sizeof *out && sizeof(vesica::Polygon<T>) == sizeof *polygon);
  if (polygon == nullptr || out == nullptr) return VESICA_E_NULL;
  vesica::PolygonFacts<T> facts;
  const int32_t error = vesica::polygon_facts_or_error(vesica::load<vesica::Polygon<T>>(polygon), facts);
  if (error == 0) std::memcpy(out, &facts, sizeof *out);
  return error;
}

}  // namespace

int32_t vesica_check_f64(int32_t kind, const void* shape) { return check_shape<double>(kind, shape); }
int32_t vesica_check_f32(int32_t kind, const void* shape) { return check_shape<float>(kind, shape); }
int32_t vesica_polygon_facts_f64(const vesica_polygon_f64* polygon, vesica_facts_f64* out) {
  return polygon_facts<double>(polygon, out);
}
int32_t vesica_polygon_facts_f32(const vesica_polygon_f32* polygon, vesica_facts_f32* out) {
  return polygon_facts<float>(polygon, out);
}
