// SPDX-License-Identifier: Apache-2.0
// main FILE right|same: queries compiled with other flags (flags.sh) answer as the library does. `right`: the same
// decisions and errors. `same`: the same bits of distances and points too.
#include <dlfcn.h>
#include <vesica.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>

#include "oracle/oracle.hpp"
#include "properties/generators.hpp"
#include "properties/spoilt.hpp"
#include "query.hpp"

namespace {

using properties::Pair;
using properties::Scalar;
using vesica::Query;

bool library_overlap(int kind_a, const double* a, int kind_b, const double* b) {
  return vesica_overlap_f64(kind_a, a, kind_b, b) == 1;
}

const Query& query(void* file, const char* name) {
  const void* found = dlsym(file, name);
  if (found == nullptr) throw std::runtime_error(dlerror());
  return *static_cast<const Query*>(found);
}

struct Library {
  static std::int32_t overlap(int a, const double* x, int b, const double* y) { return vesica_overlap_f64(a, x, b, y); }
  static std::int32_t overlap(int a, const float* x, int b, const float* y) { return vesica_overlap_f32(a, x, b, y); }
  static std::int32_t nearest(int a, const double* x, int b, const double* y, double* out) {
    return vesica_nearest_f64(a, x, b, y, reinterpret_cast<vesica_closest_points_f64*>(out));
  }
  static std::int32_t nearest(int a, const float* x, int b, const float* y, float* out) {
    return vesica_nearest_f32(a, x, b, y, reinterpret_cast<vesica_closest_points_f32*>(out));
  }
};

constexpr std::size_t fields = std::tuple_size_v<properties::Numbers>;

class Comparison {
 public:
  Comparison(void* file, bool same_bits)
      : overlap_(query(file, "_ZN6vesica7queries7overlapE")),
        nearest_(query(file, "_ZN6vesica7queries7nearestE")),
        same_bits_(same_bits) {}

  template <class T>
  void ask(const Pair& pair) {
    T a[fields], b[fields];
    for (std::size_t i = 0; i < fields; ++i) {
      a[i] = static_cast<T>(pair.a[i]);
      b[i] = static_cast<T>(pair.b[i]);
    }
    ++asked;
    const std::int32_t answer = vesica::ask<T>(overlap_, pair.kind_a, a, pair.kind_b, b, nullptr);
    T found[5] = {}, expected[5] = {};
    const std::int32_t error = vesica::ask<T>(nearest_, pair.kind_a, a, pair.kind_b, b, found);
    const bool right = answer == Library::overlap(pair.kind_a, a, pair.kind_b, b) &&
                       error == Library::nearest(pair.kind_a, a, pair.kind_b, b, expected) && agree(found, expected);
    if (!right && wrong++ < 5) std::printf("wrong: %s\n", describe(pair).c_str());
  }

  int asked = 0, wrong = 0;

 private:
  const Query &overlap_, &nearest_;
  bool same_bits_;

  template <class T>
  bool agree(const T (&found)[5], const T (&expected)[5]) const {
    if (same_bits_) return std::memcmp(found, expected, sizeof found) == 0;
    return (found[0] == 0) == (expected[0] == 0);
  }
};

template <class T>
void ask_all(Comparison& comparison, Scalar scalar) {
  for (const properties::Workload workload : properties::all_workloads) {
    for (int a = 0; a < properties::kinds; ++a) {
      for (int b = a; b < properties::kinds; ++b) {
        properties::Stream stream(workload, a, b, scalar, 5, library_overlap);
        for (int i = 0; i < 14; ++i) {
          Pair pair = stream.next();
          if (i >= 10) spoil(pair, i - 10);
          comparison.ask<T>(pair);
        }
      }
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return 2;
  void* file = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
  if (file == nullptr) {
    std::fprintf(stderr, "%s\n", dlerror());
    return 2;
  }
  Comparison comparison(file, std::string(arguments[2]) == "same");
  ask_all<double>(comparison, Scalar::f64);
  ask_all<float>(comparison, Scalar::f32);
  std::printf("%d of %d wrong\n", comparison.wrong, comparison.asked);
  return comparison.wrong == 0 ? 0 : 1;
}
