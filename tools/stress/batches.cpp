// SPDX-License-Identifier: Apache-2.0
#include "stress/batches.hpp"

#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "stress/arrays.hpp"
#include "stress/deliberate.hpp"
#include "stress/libraries.hpp"

namespace stress {
namespace {

constexpr Query batched[] = {Query::overlap,           Query::relation, Query::contains, Query::nearest,
                             Query::boundary_distance, Query::depth,    Query::area,     Query::iou};

constexpr bool is_code(Query query) { return query <= Query::contains; }
constexpr std::size_t columns_of(Query query) {
  return query == Query::nearest || query == Query::boundary_distance ? 5 : query == Query::depth ? 3 : 1;
}

/// A batch's result for the given scalar answers.
std::int64_t expected_return(Query query, std::span<const Answer> answers) {
  std::int64_t count = 0, error = 0;
  for (const Answer& answer : answers) {
    if (answer.code == VESICA_E_SHAPE || (answer.code < 0 && error == 0)) error = answer.code;
    if (answer.code < 0) continue;
    const bool zero = query == Query::nearest || query == Query::boundary_distance;
    count += is_code(query) ? answer.code > 0 : zero ? answer.numbers[0] == 0 : answer.numbers[0] > 0;
  }
  return error != 0 ? error : count;
}

bool as_scalar(Query query, const Answer& answer, std::size_t column, double got) {
  if (is_code(query)) return got == (answer.code < 0 ? 0 : answer.code);
  if (answer.code < 0) return std::isnan(got);
  return std::memcmp(&answer.numbers[column], &got, sizeof got) == 0;
}

/// One call of a batch function; results as columns of doubles.
struct Called {
  std::int64_t returned;
  std::vector<std::vector<double>> columns;
  bool environment_changed = false;
};

template <class T, class Out>
std::vector<double> widened(const std::vector<Out>& column) {
  return std::vector<double>(column.begin(), column.end());
}

template <class T>
class Batch {
 public:
  using Shapes = typename Types<T>::Shapes;

  Batch(const Loaded& library, const Environment& environment) : library_(library), environment_(environment) {}

  Called many(Query query, const Shapes& a, const Shapes& b, std::size_t n) const {
    const std::string symbol = symbol_of(query, "_many");
    if (is_code(query)) return codes(symbol, a, b, n);
    std::vector<std::vector<T>> c(columns_of(query), std::vector<T>(n));
    Called called;
    called.returned = run_in(environment_, called.environment_changed, [&] { return numbers(symbol, a, b, c); });
    for (const auto& column : c) called.columns.push_back(widened<T>(column));
    return called;
  }

  /// Rows of b's count.
  Called matrix(Query query, const Shapes& a, const Shapes& b) const {
    const std::string symbol = symbol_of(query, "_matrix");
    const auto size = static_cast<std::size_t>(a.count * b.count);
    return is_code(query) ? filled<std::uint8_t>(symbol, a, b, size) : filled<T>(symbol, a, b, size);
  }

 private:
  static std::string symbol_of(Query query, const char* shape) {
    return std::string("vesica_") + name(query) + shape + Types<T>::suffix;
  }

  Called codes(const std::string& symbol, const Shapes& a, const Shapes& b, std::size_t n) const {
    const auto function = find<std::int64_t(const Shapes*, const Shapes*, std::uint8_t*)>(library_, symbol);
    std::byte* out = out_.place(n, Edge::after);
    Called called;
    called.returned = run_in(environment_, called.environment_changed,
                             [&] { return function(&a, &b, reinterpret_cast<std::uint8_t*>(out)); });
    called.columns.emplace_back();
    for (std::size_t i = 0; i < n; ++i) called.columns[0].push_back(std::to_integer<int>(out[i]));
    return called;
  }

  std::int64_t numbers(const std::string& symbol, const Shapes& a, const Shapes& b,
                       std::vector<std::vector<T>>& c) const {
    using S = const Shapes*;
    if (c.size() == 1) return find<std::int64_t(S, S, T*)>(library_, symbol)(&a, &b, c[0].data());
    if (c.size() == 3) {
      return find<std::int64_t(S, S, T*, T*, T*)>(library_, symbol)(&a, &b, c[0].data(), c[1].data(), c[2].data());
    }
    return find<std::int64_t(S, S, T*, T*, T*, T*, T*)>(library_, symbol)(&a, &b, c[0].data(), c[1].data(), c[2].data(),
                                                                          c[3].data(), c[4].data());
  }

  template <class Out>
  Called filled(const std::string& symbol, const Shapes& a, const Shapes& b, std::size_t size) const {
    std::vector<Out> out(size);
    Called called;
    called.returned = run_in(environment_, called.environment_changed, [&] {
      return find<std::int64_t(const Shapes*, const Shapes*, Out*, std::ptrdiff_t)>(library_, symbol)(
          &a, &b, out.data(), static_cast<std::ptrdiff_t>(b.count));
    });
    called.columns.push_back(widened<T>(out));
    return called;
  }

  const Loaded& library_;
  const Environment& environment_;
  mutable GuardedMemory out_;
};

/// Compares what one call gave with the scalar answers.
void compare(Query query, const std::string& law, std::span<const Answer> answers, const Called& called,
             std::vector<BatchFault>& faults) {
  const std::int64_t expected = expected_return(query, answers);
  for (std::size_t i = 0; i < answers.size(); ++i) {
    for (std::size_t k = 0; k < called.columns.size(); ++k) {
      const double got = called.columns[k][i];
      if (as_scalar(query, answers[i], k, got)) continue;
      faults.push_back({i, {law, text(answers[i]), hex(got)}});
      return;
    }
  }
  if (called.returned != expected) {
    faults.push_back({answers.size(), {law + "_returned", std::to_string(expected), std::to_string(called.returned)}});
  }
  if (called.environment_changed) faults.push_back({answers.size(), {law + "_environment_kept", "as before", "other"}});
}

constexpr std::size_t rows = 3;

/// The scalar answers of the first rows of a with every b.
std::vector<Answer> matrix_answers(Query query, Scalar scalar, std::span<const Pair> pairs) {
  std::vector<Answer> answers;
  for (std::size_t i = 0; i < std::min(rows, pairs.size()); ++i) {
    for (const Pair& p : pairs) answers.push_back(ask(query, scalar, {p.kind_a, p.kind_b, pairs[i].a, p.b}));
  }
  return answers;
}

std::vector<Numbers> side(std::span<const Pair> pairs, bool of_b, std::size_t most) {
  std::vector<Numbers> result;
  for (std::size_t i = 0; i < std::min(most, pairs.size()); ++i) result.push_back(of_b ? pairs[i].b : pairs[i].a);
  return result;
}

template <class T>
void judge_query(Query query, std::span<const Pair> pairs, unsigned layout, const Environment& environment,
                 std::vector<BatchFault>& faults) {
  static GuardedMemory memory_a, memory_b, memory_rows;
  const Array<T> a(pairs[0].kind_a, side(pairs, false, pairs.size()), layout, memory_a);
  const Array<T> b(pairs[0].kind_b, side(pairs, true, pairs.size()), layout / 7, memory_b);
  const Array<T> few(pairs[0].kind_a, side(pairs, false, rows), layout / 3, memory_rows);
  std::vector<Answer> in_step, every;
  for (const Pair& p : pairs) in_step.push_back(ask(query, Types<T>::scalar, p));
  const bool matrix = layout % 5 == 0;
  if (matrix) every = matrix_answers(query, Types<T>::scalar, pairs);
  for (const Loaded& library : loaded()) {
    const Batch<T> batch(library, environment);
    const std::string law = std::string("batch.") + name(query) + '_' + library.isa +
                            (environment.bits == 0 ? "" : std::string("_environment_") + environment.name);
    Called called = batch.many(query, a.view(), b.view(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (deliberate_fault() != nullptr && flips_lane(query, pairs[i], i))
        called.columns[0][i] = 1 - called.columns[0][i];
    }
    compare(query, law, in_step, called, faults);
    if (!matrix) continue;
    std::vector<BatchFault> found;
    compare(query, law + "_matrix", every, batch.matrix(query, few.view(), b.view()), found);
    for (BatchFault& fault : found) {
      fault.element = pairs.size();
      faults.push_back(fault);
    }
  }
}

}  // namespace

std::vector<std::string> instruction_sets() {
  std::vector<std::string> names;
  for (const Loaded& library : loaded()) names.push_back(library.isa);
  return names;
}

std::vector<BatchFault> judge_batches(Scalar scalar, std::span<const Pair> pairs, unsigned layout,
                                      const Environment& environment) {
  std::vector<BatchFault> faults;
  if (pairs.empty()) return faults;
  for (const Query query : batched) {
    if (is_refused(query, pairs[0].kind_a, pairs[0].kind_b)) continue;
    if (scalar == Scalar::f64) {
      judge_query<double>(query, pairs, layout, environment, faults);
    } else {
      judge_query<float>(query, pairs, layout, environment, faults);
    }
  }
  judge_arrays(scalar, pairs, layout, environment, faults);
  return faults;
}

void judge_copies(Judge& j, const Case& c, bool in_environments) {
  constexpr std::size_t copies = 37;
  const std::vector<Pair> pairs(copies, c.pair);
  std::vector<BatchFault> faults = judge_batches(c.scalar, pairs, 0);
  for (const Environment& environment : environments()) {
    if (!in_environments) break;
    for (BatchFault& fault : judge_batches(c.scalar, pairs, 0, environment)) faults.push_back(fault);
  }
  constexpr std::size_t prefix = sizeof "batch." - 1;
  for (const BatchFault& fault : faults) {
    j.demand(false, fault.fault.law.substr(prefix).c_str(), fault.fault.expected, fault.fault.got);
  }
}

}  // namespace stress
