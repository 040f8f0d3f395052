// SPDX-License-Identifier: Apache-2.0
// One hash of several hundred thousand answers, each within 64 places of a contact: what a contracted product, an extra
// bit of precision or a lane's wrong bound would change, and random pairs would not show. The literal below holds on
// every instruction set, processor, compiler and optimisation level.
//
// Exit status: 0 when all is as it must be, 1 when not, 77 when this processor does not have the set of VESICA_ISA.
#include <vesica.h>

#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "batch/near_tie_hash/contact.hpp"

namespace {

using near_tie::Pair;

// If `inputs` is right and `answers` is not, the library is wrong; if `inputs` differs too, look at the first answers:
// the search for contacts asks the library.
constexpr std::uint64_t expected_inputs = 0x3cbfe73e571920f0;
constexpr std::uint64_t expected_answers = 0xb64d2e09b9caa6f3;

/// FNV-1a, 64 bits (Fowler, Noll and Vo).
struct Hash {
  std::uint64_t value = 0xcbf29ce484222325U;
  void add(std::uint8_t byte) { value = (value ^ byte) * 0x100000001b3U; }
};

/// A number's bits, the lowest byte first on any machine.
void add(Hash& hash, double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  for (int shift = 0; shift < 64; shift += 8) hash.add(static_cast<std::uint8_t>(bits >> shift));
}

struct Report {
  Hash inputs, answers;
  std::int64_t count = 0, overlaps = 0, wrong_batches = 0;
};

vesica_shapes_f64 records(int kind, std::int64_t count, const double* first, std::ptrdiff_t stride) {
  vesica_shapes_f64 shapes;
  vesica_shapes_from_records_f64(kind, count, first, stride, &shapes);
  return shapes;
}
vesica_shapes_f32 records(int kind, std::int64_t count, const float* first, std::ptrdiff_t stride) {
  vesica_shapes_f32 shapes;
  vesica_shapes_from_records_f32(kind, count, first, stride, &shapes);
  return shapes;
}
std::int64_t overlap_many(const vesica_shapes_f64& a, const vesica_shapes_f64& b, std::uint8_t* out) {
  return vesica_overlap_many_f64(&a, &b, out);
}
std::int64_t overlap_many(const vesica_shapes_f32& a, const vesica_shapes_f32& b, std::uint8_t* out) {
  return vesica_overlap_many_f32(&a, &b, out);
}

enum class Order { as_drawn, swapped };

/// Adds the answers of batches, which must be the scalar function's: the first of `length` pairs, later ones of every
/// length up to `longest`, over and over.
template <class T>
void add_batches(Report& report, const std::vector<Pair<T>>& pairs, Order order, std::size_t length,
                 const std::vector<std::uint8_t>& scalar, std::int64_t overlaps) {
  constexpr std::size_t longest = 67;
  std::vector<std::uint8_t> out(pairs.size());
  std::int64_t returned = 0;
  for (std::size_t begin = 0; begin < pairs.size(); begin += length, length = length % longest + 1) {
    const Pair<T>& first = pairs[begin];
    const auto n = static_cast<std::int64_t>(std::min(length, pairs.size() - begin));
    const auto a = records(first.kind_a, n, first.a.data(), sizeof(Pair<T>));
    const auto b = records(first.kind_b, n, first.b.data(), sizeof(Pair<T>));
    returned += order == Order::as_drawn ? overlap_many(a, b, &out[begin]) : overlap_many(b, a, &out[begin]);
  }
  for (const std::uint8_t answer : out) report.answers.add(answer);
  if (returned == overlaps && out == scalar) return;
  ++report.wrong_batches;
  std::printf("%s with %s: batches differ from the scalar function\n", vesica_kind_name(pairs[0].kind_a),
              vesica_kind_name(pairs[0].kind_b));
}

template <class T>
void add_pairs(Report& report, int kind_a, int kind_b) {
  const std::vector<Pair<T>> pairs = near_tie::contacts<T>(kind_a, kind_b);
  std::vector<std::uint8_t> scalar;
  std::int64_t overlaps = 0;
  for (const Pair<T>& pair : pairs) {
    for (const T x : pair.a) add(report.inputs, static_cast<double>(x));
    for (const T x : pair.b) add(report.inputs, static_cast<double>(x));
    scalar.push_back(near_tie::overlap(pair) == 1);
    report.answers.add(scalar.back());
    overlaps += scalar.back();
  }
  add_batches(report, pairs, Order::as_drawn, pairs.size(), scalar, overlaps);
  add_batches(report, pairs, Order::swapped, 1, scalar, overlaps);
  report.count += 3 * static_cast<std::int64_t>(pairs.size());
  report.overlaps += 3 * overlaps;
}

bool lacks_what_was_asked_for() {
  const char* asked = std::getenv("VESICA_ISA");
  return asked != nullptr && std::strcmp(asked, vesica_isa_name()) != 0;
}

}  // namespace

int main() {
  if (lacks_what_was_asked_for()) {
    std::printf("skipped: this processor lacks %s\n", std::getenv("VESICA_ISA"));
    return 77;
  }
  Report report;
  for (int a = 0; a < 6; ++a) {
    for (int b = a; b < 6; ++b) {
      add_pairs<float>(report, a, b);
      add_pairs<double>(report, a, b);
    }
  }
  std::printf("%s: %" PRId64 " answers, %" PRId64 " of them overlaps\n", vesica_isa_name(), report.count,
              report.overlaps);
  std::printf("inputs  0x%016" PRIx64 ", expected 0x%016" PRIx64 "\n", report.inputs.value, expected_inputs);
  std::printf("answers 0x%016" PRIx64 ", expected 0x%016" PRIx64 "\n", report.answers.value, expected_answers);
  const bool right = report.inputs.value == expected_inputs && report.answers.value == expected_answers;
  return right && report.wrong_batches == 0 ? 0 : 1;
}
