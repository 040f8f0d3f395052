// SPDX-License-Identifier: Apache-2.0
#include "queries/within.hpp"

#include <vesica/within.hpp>

#include "columns.hpp"
#include "compiled_once.hpp"
#include "polygon/arrays.hpp"

namespace vesica {

namespace queries {

namespace {

/// Not inlined, so that the code of a pair exists once. The shapes are read in place, as in pair_table.hpp.
template <class A, class B>
VESICA_CALLED std::int32_t answer(const double* a, const double* b, double distance) noexcept {
  const void *const first = a, *const second = b;
  return within_or_error(*static_cast<const A*>(first), *static_cast<const B*>(second), distance);
}
template <class A, class B>
std::int32_t reversed(const double* a, const double* b, double distance) noexcept {
  return answer<B, A>(b, a, distance);
}

struct Table {
  WithinOfPair of[kind_count][kind_count];
};

consteval Table table() noexcept {
  Table t{};
#define VESICA_ENTRY(a, A, b, B)                                                               \
  t.of[static_cast<int>(Kind::b)][static_cast<int>(Kind::a)] = reversed<B<double>, A<double>>; \
  t.of[static_cast<int>(Kind::a)][static_cast<int>(Kind::b)] = answer<A<double>, B<double>>;
  VESICA_EACH_PAIR_OF_FORMS(VESICA_ENTRY)
  VESICA_EACH_PAIR_INFLATED(VESICA_ENTRY)
#undef VESICA_ENTRY
  return t;
}

constinit const Table pairs = table();

}  // namespace

WithinOfPair within(std::int32_t kind_a, std::int32_t kind_b) noexcept { return pairs.of[kind_a][kind_b]; }

}  // namespace queries

namespace batch {

namespace {

std::uint8_t noted(std::int32_t code, WithinTally& tally) noexcept {
  tally.count += code > 0;
  if (code < 0 && tally.error != error_shape) tally.error = code;
  return code < 0 ? std::uint8_t{0} : static_cast<std::uint8_t>(code);
}

}  // namespace

template <class T>
WithinTally within_many(const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, double distance,
                        std::uint8_t* out) noexcept {
  WithinTally tally;
  if (has_path(a, b)) {
    each_in_step(a, b, n, [&](const Element<T>& first, const Element<T>& second, std::int64_t i) {
      out[i] = noted(polygon::within(first.operand(), second.operand(), distance), tally);
    });
    return tally;
  }
  const queries::WithinOfPair pair = queries::within(a.kind, b.kind);
  for (std::int64_t i = 0; i < n; ++i) {
    double first[max_fields], second[max_fields];
    read_element(a, i, first);
    read_element(b, i, second);
    out[i] = noted(pair(first, second, distance), tally);
  }
  return tally;
}

template <class T>
WithinTally within_matrix(const Shapes<T>& a, const Shapes<T>& b, double distance, std::uint8_t* out,
                          std::ptrdiff_t row_stride) noexcept {
  WithinTally tally;
  if (has_path(a, b)) {
    each_pair(a, b, [&](const Element<T>& first, const Element<T>& second, std::int64_t i, std::int64_t j) {
      out[i * row_stride + j] = noted(polygon::within(first.operand(), second.operand(), distance), tally);
    });
    return tally;
  }
  const queries::WithinOfPair pair = queries::within(a.kind, b.kind);
  for (std::int64_t i = 0; i < a.count; ++i) {
    double first[max_fields], second[max_fields];
    read_element(a, i, first);
    for (std::int64_t j = 0; j < b.count; ++j) {
      read_element(b, j, second);
      out[i * row_stride + j] = noted(pair(first, second, distance), tally);
    }
  }
  return tally;
}

#define VESICA_WITHIN(T)                                                                                              \
  template WithinTally within_many(const Shapes<T>&, const Shapes<T>&, std::int64_t, double, std::uint8_t*) noexcept; \
  template WithinTally within_matrix(const Shapes<T>&, const Shapes<T>&, double, std::uint8_t*,                       \
                                     std::ptrdiff_t) noexcept;
VESICA_WITHIN(double)
VESICA_WITHIN(float)
#undef VESICA_WITHIN

}  // namespace batch

}  // namespace vesica
