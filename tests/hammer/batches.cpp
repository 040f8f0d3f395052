// SPDX-License-Identifier: Apache-2.0
#include "hammer/batches.hpp"

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>
#include <vesica.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <limits>
#include <set>
#include <stdexcept>

#include "batch/guard_pages.hpp"
#include "hammer/deliberate.hpp"

namespace hammer {
namespace {

using batch_tests::Edge;
using batch_tests::GuardedMemory;

/// A copy of the library's file that only this process sees, loaded as a library of its own.
void* load_copy(const std::string& file) {
  const int memory = memfd_create("vesica", 0);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (memory < 0 || write(memory, bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size())) {
    throw std::runtime_error("cannot copy " + file);
  }
  const std::string path = "/proc/self/fd/" + std::to_string(memory);
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  if (handle == nullptr) throw std::runtime_error(dlerror());
  return handle;  // the file stays open: its path is the copy's name, which no other copy may have
}

struct Loaded {
  std::string isa;
  void* handle;
};

template <class Function>
Function* find(void* handle, const std::string& symbol) {
  void* found = dlsym(handle, symbol.c_str());
  if (found == nullptr) throw std::runtime_error("no " + symbol);
  return reinterpret_cast<Function*>(found);
}

std::string library_file() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&vesica_version), &info) == 0) throw std::runtime_error("no library");
  return info.dli_fname;
}

std::vector<Loaded> load_each() {
  std::vector<Loaded> result;
  const char* before = std::getenv("VESICA_ISA");
  const std::string kept = before != nullptr ? before : "";
  for (const char* isa : {"portable", "sse2", "avx2", "avx512", "neon"}) {
    setenv("VESICA_ISA", isa, 1);
    void* handle = load_copy(library_file());
    if (std::string(find<const char*()>(handle, "vesica_isa_name")()) == isa) {
      result.push_back({isa, handle});
    } else {
      dlclose(handle);
    }
  }
  if (before != nullptr) {
    setenv("VESICA_ISA", kept.c_str(), 1);
  } else {
    unsetenv("VESICA_ISA");
  }
  return result;
}

const std::vector<Loaded>& loaded() {
  static const std::vector<Loaded> all = load_each();
  return all;
}

template <class T>
struct Types;
template <>
struct Types<double> {
  using Shapes = vesica_shapes_f64;
  static constexpr const char* suffix = "_f64";
  static constexpr Scalar scalar = Scalar::f64;
};
template <>
struct Types<float> {
  using Shapes = vesica_shapes_f32;
  static constexpr const char* suffix = "_f32";
  static constexpr Scalar scalar = Scalar::f32;
};

/// An array of shapes between guard pages: columns or records, forwards or backwards, at any byte.
template <class T>
class Array {
 public:
  using Shapes = typename Types<T>::Shapes;

  Array(int kind, std::span<const Numbers> shapes, unsigned layout, GuardedMemory& memory) : shapes_{} {
    const auto fields = static_cast<std::size_t>(properties::field_count(kind));
    const bool columns = layout % 2 == 0, backward = layout / 2 % 4 == 0;
    const std::size_t padding = columns ? 0 : layout / 8 % 3 * 5, count = shapes.size();
    const std::size_t element = columns ? sizeof(T) : fields * sizeof(T) + padding;
    const std::size_t size = columns ? fields * count * sizeof(T) : count * element;
    std::byte* begin = memory.place(size, layout / 32 % 2 == 0 ? Edge::before : Edge::after);
    std::memset(begin, 0xFF, size);
    shapes_.kind = kind;
    shapes_.count = static_cast<std::int64_t>(count);
    shapes_.stride = backward ? -static_cast<std::ptrdiff_t>(element) : static_cast<std::ptrdiff_t>(element);
    for (std::size_t k = 0; k < fields; ++k) {
      std::byte* field = begin + (columns ? k * count * sizeof(T) : k * sizeof(T));
      for (std::size_t i = 0; i < count; ++i) {
        const T number = static_cast<T>(shapes[backward ? count - 1 - i : i][k]);
        std::memcpy(field + i * element, &number, sizeof number);
      }
      shapes_.field[k] = reinterpret_cast<const T*>(field + (backward ? (count - 1) * element : 0));
    }
  }
  const Shapes& view() const { return shapes_; }

 private:
  Shapes shapes_;
};

constexpr Query batched[] = {Query::overlap,           Query::relation, Query::contains, Query::nearest,
                             Query::boundary_distance, Query::depth,    Query::area,     Query::iou};

constexpr bool is_code(Query query) { return query <= Query::contains; }
constexpr std::size_t columns_of(Query query) {
  return query == Query::nearest || query == Query::boundary_distance ? 5 : query == Query::depth ? 3 : 1;
}

/// What a batch must return for these scalar answers.
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
    const auto function = find<std::int64_t(const Shapes*, const Shapes*, std::uint8_t*)>(library_.handle, symbol);
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
    void* handle = library_.handle;
    using S = const Shapes*;
    if (c.size() == 1) return find<std::int64_t(S, S, T*)>(handle, symbol)(&a, &b, c[0].data());
    if (c.size() == 3) {
      return find<std::int64_t(S, S, T*, T*, T*)>(handle, symbol)(&a, &b, c[0].data(), c[1].data(), c[2].data());
    }
    return find<std::int64_t(S, S, T*, T*, T*, T*, T*)>(handle, symbol)(&a, &b, c[0].data(), c[1].data(), c[2].data(),
                                                                        c[3].data(), c[4].data());
  }

  template <class Out>
  Called filled(const std::string& symbol, const Shapes& a, const Shapes& b, std::size_t size) const {
    std::vector<Out> out(size);
    Called called;
    called.returned = run_in(environment_, called.environment_changed, [&] {
      return find<std::int64_t(const Shapes*, const Shapes*, Out*, std::ptrdiff_t)>(library_.handle, symbol)(
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

bool has_matrix(Query query) { return is_code(query) || query == Query::area || query == Query::iou; }

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
  const bool matrix = has_matrix(query) && layout % 5 == 0;
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
    if (scalar == Scalar::f64) {
      judge_query<double>(query, pairs, layout, environment, faults);
    } else {
      judge_query<float>(query, pairs, layout, environment, faults);
    }
  }
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

}  // namespace hammer
