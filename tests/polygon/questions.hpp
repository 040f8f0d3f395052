// SPDX-License-Identifier: Apache-2.0
/// Every question about two shapes, one of them perhaps a path, and its answer as bytes.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "capi/face.hpp"

namespace polygons {

using capi_tests::Face;
using Bytes = std::vector<unsigned char>;

template <class T>
using PolygonOf = std::conditional_t<std::is_same_v<T, float>, vesica_polygon_f32, vesica_polygon_f64>;

struct Given {
  std::int32_t kind;
  const void* shape;
};

template <class T>
void append(Bytes& bytes, const T& value) {
  const auto* from = reinterpret_cast<const unsigned char*>(&value);
  bytes.insert(bytes.end(), from, from + sizeof value);
}

/// A question, and its answer as bytes.
struct Question {
  const char* name;
  Bytes (*ask)(const Given& a, const Given& b);
};

template <auto function>
Bytes ask_code(const Given& a, const Given& b) {
  Bytes bytes;
  append(bytes, function(a.kind, a.shape, b.kind, b.shape));
  return bytes;
}
template <class Out, auto function>
Bytes ask_out(const Given& a, const Given& b) {
  Bytes bytes;
  Out out;
  std::memset(&out, 0, sizeof out);
  append(bytes, function(a.kind, a.shape, b.kind, b.shape, &out));
  append(bytes, out);
  return bytes;
}
template <class T>
Bytes ask_ratios(const Given& a, const Given& b) {
  Bytes bytes;
  for (const int ratio : {VESICA_RATIO_OVER_FIRST, VESICA_RATIO_GENERALIZED, VESICA_RATIO_COMPLETE}) {
    T out = 0;
    append(bytes, Face<T>::ratio(ratio, a.kind, a.shape, b.kind, b.shape, &out));
    append(bytes, out);
  }
  return bytes;
}
template <class T>
Bytes ask_motion(const Given& a, const Given& b) {
  Bytes bytes;
  typename Face<T>::Impact impact;
  std::memset(&impact, 0, sizeof impact);
  append(bytes, Face<T>::cast(a.kind, a.shape, b.kind, b.shape, T{1}, T{-0.5}, T{8}, &impact));
  append(bytes, impact);
  append(bytes, Face<T>::within(a.kind, a.shape, b.kind, b.shape, T{0.75}));
  return bytes;
}
template <class T>
Bytes ask_one(const Given& a, const Given&) {
  Bytes bytes;
  typename Face<T>::Aabb box;
  std::memset(&box, 0, sizeof box);
  T area = 0;
  append(bytes, Face<T>::check(a.kind, a.shape));
  append(bytes, Face<T>::bounds(a.kind, a.shape, &box));
  append(bytes, Face<T>::shape_area(a.kind, a.shape, &area));
  append(bytes, box);
  append(bytes, area);
  return bytes;
}

template <class T>
Bytes ask_turns(const Given& a, const Given& b) {
  Bytes bytes;
  const typename Face<T>::Turn first{T{0.5}, T{-1}, T{0.75}}, second{T{-2}, T{0.25}, T{-3}};
  typename Face<T>::Impact impact;
  std::memset(&impact, 0, sizeof impact);
  T gap = 0;
  append(bytes, Face<T>::impact_time(a.kind, a.shape, &first, b.kind, b.shape, &second, T{0.0078125}, &impact, &gap));
  append(bytes, impact);
  append(bytes, gap);
  return bytes;
}
template <class T>
Bytes ask_intersection(const Given& a, const Given& b) {
  Bytes bytes;
  std::array<T, 16> vertices{};
  append(bytes, Face<T>::intersection(a.kind, a.shape, b.kind, b.shape, vertices.data()));
  append(bytes, vertices);
  return bytes;
}

template <class T>
const std::vector<Question>& questions() {
  using F = Face<T>;
  static const std::vector<Question> all{
      {"overlap", ask_code<F::overlap>},
      {"interiors_overlap", ask_code<F::interiors_overlap>},
      {"relation", ask_code<F::relation>},
      {"contains", ask_code<F::contains>},
      {"nearest", ask_out<typename F::Points, F::nearest>},
      {"boundary_distance", ask_out<typename F::Points, F::boundary_distance>},
      {"signed_distance", ask_out<T, F::signed_distance>},
      {"depth", ask_out<typename F::Penetration, F::depth>},
      {"manifold", ask_out<typename F::Contacts, F::manifold>},
      {"area", ask_out<T, F::area>},
      {"iou", ask_out<T, F::iou>},
      {"ratios", ask_ratios<T>},
      {"intersection", ask_intersection<T>},
      {"motion", ask_motion<T>},
      {"turns", ask_turns<T>},
      {"one", ask_one<T>},
  };
  return all;
}

}  // namespace polygons
