// SPDX-License-Identifier: Apache-2.0
#include "queries.hpp"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vesica/relation_code.hpp>

#include "by_kind.hpp"
#include "columns.hpp"

namespace vesica::batch {

namespace {

/// n rounded up to a multiple of the widest vector's doubles.
constexpr std::int32_t whole_vectors(std::int32_t n) noexcept {
  return (n + widest_vector - 1) / widest_vector * widest_vector;
}

/// The radius of a circle about a rectangle's centre that holds it, at most 2^-47 of itself too great. NaN, of which
/// nothing follows, for a rectangle that is invalid or whose squares are not normal numbers.
inline double reach_of(double cx, double cy, double ux, double uy, double hx, double hy) noexcept {
  constexpr double least = 0x1p-400, most = 0x1p400;
  const double uu = ux * ux + uy * uy, hh = hx * hx + hy * hy, square = uu * hh;
  const bool usable = (hx >= 0) & (hy >= 0) & (uu >= least) & (uu <= most) & (hh >= least) & (hh <= most);
  const double zero = 0 * cx + 0 * cy;  // where they are finite
  return usable ? std::sqrt(square) * (1 + 0x1p-48) + zero : std::numeric_limits<double>::quiet_NaN();
}

/// A block of shapes of one kind, all numbers as doubles, in whole vectors.
class NumberColumns {
 public:
  std::int32_t kind() const noexcept { return kind_; }
  bool repeated() const noexcept { return repeated_; }

  /// Elements [begin, begin + n), or one shape repeated.
  template <class T>
  void set(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n, const Query& query,
           const KernelTable& kernels) noexcept {
    const Known known = query.asked().known;
    const ShapeArea shape_area = query.shape_area;
    kind_ = shapes.kind;
    repeated_ = shapes.stride == 0;
    if (repeated_) n = 1;
    // overlap_block() reads whole columns.
    const std::int32_t end = repeated_ && known == Known::overlap ? query_block : whole_vectors(n);
    if (!read_in_place(shapes, begin, n, end)) {
      if (n < widest_vector) {
        read_few(shapes, begin, n);
      } else {
        read(shapes, begin, n, kernels);
      }
      fill_up(n, end);
      for (int k = 0; k < max_fields; ++k) number_[k] = copy_[k];
    }
    // Numbers that the kind does not have repeat the first: loops of a fixed length read elements faster.
    for (int k = field_count(kind_); k < max_fields; ++k) number_[k] = number_[0];
    if (shape_area != nullptr) set_areas(n, end, shape_area);
    if (known == Known::reach && kind_ == static_cast<std::int32_t>(Kind::rect)) {
      set_reaches(end, shape_area != nullptr);
    }
  }

  /// n > 0 elements of another.
  void gather(const NumberColumns& from, const std::int32_t* list, std::int32_t n) noexcept {
    kind_ = from.kind_;
    repeated_ = false;
    const auto pick = [&](const double* source, double(&to)[query_block]) {
      for (std::int32_t i = 0; i < whole_vectors(n); ++i) to[i] = source[list[i < n ? i : 0]];
    };
    for (int k = 0; k < field_count(kind_); ++k) {
      pick(from.number_[k], copy_[k]);
      number_[k] = copy_[k];
    }
    pick(from.area_, area_);
    pick(from.reach_, reach_);
  }

  const double* area() const noexcept { return area_; }
  const double* const* numbers() const noexcept { return number_; }

  QueryOperand operand() const noexcept {
    QueryOperand out{{}, area_, reach_, repeated_};
    for (int k = 0; k < max_fields; ++k) out.number[k] = number_[k];
    return out;
  }

  void element(std::int32_t i, double (&out)[max_fields]) const noexcept {
    const std::int32_t at = repeated_ ? 0 : i;
    for (int k = 0; k < field_count(kind_); k += 2) {
      out[k] = number_[k][at];
      out[k + 1] = number_[k + 1][at];
    }
  }

  /// The same with its area, where the query asked for areas.
  ShapeOfKind shape(std::int32_t i, double (&numbers)[max_fields]) const noexcept {
    element(i, numbers);
    return {kind_, numbers, area_[repeated_ ? 0 : i]};
  }

 private:
  std::int32_t kind_;
  bool repeated_;
  const double* number_[max_fields] = {};
  double copy_[max_fields][query_block];
  double area_[query_block] = {};
  double reach_[query_block] = {};

  /// Whole vectors of aligned doubles that lie in columns need no copy.
  bool read_in_place(const Shapes<double>& shapes, std::int64_t begin, std::int32_t n, std::int32_t end) noexcept {
    if (!lies_in_columns(shapes) || n != end) return false;
    for (int k = 0; k < field_count(kind_); ++k) {
      number_[k] = shapes.field[k].advanced(begin * shapes.stride).aligned();
      if (number_[k] == nullptr) return false;
    }
    return true;
  }
  static bool read_in_place(const Shapes<float>&, std::int64_t, std::int32_t, std::int32_t) noexcept { return false; }

  /// Number by number. For few shapes a transposition would cost more than it saves.
  template <class T>
  void read_few(const Shapes<T>& shapes, std::int64_t begin, std::int32_t n) noexcept {
    for (int k = 0; k < field_count(kind_); ++k) {
      const Unaligned<T> from = shapes.field[k].advanced(begin * shapes.stride);
      for (std::int32_t i = 0; i < n; ++i) copy_[k][i] = static_cast<double>(from.advanced(i * shapes.stride)[0]);
    }
  }
  void read(const Shapes<double>& shapes, std::int64_t begin, std::int32_t n, const KernelTable&) noexcept {
    copy_to_columns(shapes, begin, n, copy_);
  }
  void read(const Shapes<float>& shapes, std::int64_t begin, std::int32_t n, const KernelTable& kernels) noexcept {
    float narrow[max_fields][query_block];
    const bool in_place = lies_in_columns(shapes);
    if (!in_place) copy_to_columns(shapes, begin, n, narrow);
    for (int k = 0; k < field_count(kind_); ++k) {
      const Unaligned<float> lies = shapes.field[k].advanced(begin * shapes.stride);
      kernels.widen_column(in_place ? lies : Unaligned<float>(narrow[k]), n, copy_[k]);
    }
  }

  /// Whole vectors repeat the first element behind the last one.
  void fill_up(std::int32_t n, std::int32_t end) noexcept {
    for (int k = 0; k < field_count(kind_); ++k) {
      for (std::int32_t i = n; i < end; ++i) copy_[k][i] = copy_[k][0];
    }
  }

  void set_areas(std::int32_t n, std::int32_t end, ShapeArea shape_area) noexcept {
    for (std::int32_t i = 0; i < n; ++i) {
      double numbers[max_fields];
      element(i, numbers);
      area_[i] = shape_area(kind_, numbers);
    }
    for (std::int32_t i = n; i < end; ++i) area_[i] = area_[0];
  }

  void set_reaches(std::int32_t n, bool with_areas) noexcept {
    for (std::int32_t i = 0; i < n; ++i) {
      reach_[i] = reach_of(number_[0][i], number_[1][i], number_[2][i], number_[3][i], number_[4][i], number_[5][i]);
      // Where areas are asked for, one of 0 is an error for some pairs, and one of odd magnitude needs the scalar care.
      const bool usual = (area_[i] >= 0x1p-700) & (area_[i] <= 0x1p700);
      if (with_areas && !usual) reach_[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
};

struct Pairs {
  NumberColumns a, b;
  std::int32_t n;

  bool reversed() const noexcept { return a.kind() > b.kind(); }
  const NumberColumns& first() const noexcept { return reversed() ? b : a; }
  const NumberColumns& second() const noexcept { return reversed() ? a : b; }
};

using Results = double[max_results][query_block];

/// Kernel results of (second, first) as those of (first, second). Points were exchanged as the kernel wrote them.
void reverse_columns(Reversal reversal, std::int32_t n, Results& results) noexcept {
  if (reversal == Reversal::direction) {
    for (std::int32_t i = 0; i < n; ++i) {
      results[1][i] = 0 - results[1][i];  // no -0
      results[2][i] = 0 - results[2][i];
    }
  }
  if (reversal == Reversal::converse) {
    for (std::int32_t i = 0; i < n; ++i) {
      if (std::isnan(results[0][i])) continue;
      results[0][i] = static_cast<double>(converse(static_cast<Relation>(static_cast<int>(results[0][i]))));
    }
  }
}

/// Results as the caller's type has them. Codes hold 0 for errors.
template <class Out>
using Stored = Out[max_results][query_block];

/// Whether any of n floats is infinite. By their bits: comparisons of floats a compiler would make one by one.
bool any_infinite(const float* numbers, std::int32_t n) noexcept {
  std::uint32_t any = 0;
  for (std::int32_t i = 0; i < n; ++i) any |= (std::bit_cast<std::uint32_t>(numbers[i]) & 0x7fffffffu) == 0x7f800000u;
  return any != 0;
}

/// Whether rounding made any of n lengths 0. By their bits too.
bool any_lost(const double* lengths, const float* rounded, std::int32_t n) noexcept {
  std::uint64_t any = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    any |= std::uint64_t{(std::bit_cast<std::uint32_t>(rounded[i]) & 0x7fffffffu) == 0} &
           std::uint64_t{std::bit_cast<std::uint64_t>(lengths[i]) << 1 != 0};
  }
  return any != 0;
}

/// Where rounding to float made a length 0 or left the range: the least float, or an error.
std::int32_t mend(const Query& query, std::int32_t n, const Results& results, Stored<float>& out) noexcept {
  std::int32_t error = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    bool in_range = true;
    for (int k = 0; k < query.columns(); ++k) in_range = in_range && !std::isinf(out[k][i]);
    // Below 0 it is a depth.
    const bool lost = query.is_length && out[0][i] == 0 && std::fabs(results[0][i]) > 0;
    if (lost) out[0][i] = std::copysign(std::numeric_limits<float>::denorm_min(), static_cast<float>(results[0][i]));
    if (in_range) continue;
    error = error_range;
    for (int k = 0; k < query.columns(); ++k) out[k][i] = std::numeric_limits<float>::quiet_NaN();
  }
  return error;
}

/// Rounds n results once, as the scalar functions do. A float beyond the range is an error.
std::int32_t store(const Query& query, std::int32_t n, const Results& results, Stored<float>& out) noexcept {
  bool in_range = true;
  for (int k = 0; k < query.columns(); ++k) {
    for (std::int32_t i = 0; i < n; ++i) out[k][i] = static_cast<float>(results[k][i]);
    in_range = in_range && !any_infinite(out[k], n);
  }
  if (query.reversal == Reversal::direction) {
    for (int k = 1; k < query.columns(); ++k) {
      for (std::int32_t i = 0; i < n; ++i) out[k][i] += 0.0f;  // no -0
    }
  }
  const bool lost = query.is_length && any_lost(results[0], out[0], n);
  return in_range && !lost ? 0 : mend(query, n, results, out);
}
std::int32_t store(const Query& query, std::int32_t n, const Results& results, Stored<double>& out) noexcept {
  for (int k = 0; k < query.columns(); ++k)
    std::memcpy(out[k], results[k], static_cast<std::size_t>(n) * sizeof(double));
  return 0;
}
std::int32_t store(const Query&, std::int32_t n, const Results& results, Stored<std::uint8_t>& out) noexcept {
  for (std::int32_t i = 0; i < n; ++i) {
    out[0][i] = std::isnan(results[0][i]) ? std::uint8_t{0} : static_cast<std::uint8_t>(results[0][i]);
  }
  return 0;
}

class Engine {
 public:
  Engine(const Query& query, const KernelTable& kernels) noexcept : query_(query), kernels_(kernels) {}

  /// Results of all pairs as Out; NaN, or code 0, where there is an error.
  template <class Out>
  void answer(const Pairs& pairs, Stored<Out>& out) noexcept {
    Results results;
    answer(query_, pairs, results);
    note(store(query_, pairs.n, results, out));
  }

  std::int32_t error() const noexcept { return error_; }

 private:
  const Query& query_;
  const KernelTable& kernels_;
  std::int32_t error_ = 0;
  NumberColumns first_near_, second_near_;

  void answer(const Query& query, const Pairs& pairs, Results& results) noexcept {
    if (query.derive != nullptr) return derive(query, pairs, results);
    if (query.from_code != nullptr) {
      answer(*query.asked_instead, pairs, results);
      for (std::int32_t i = 0; i < pairs.n; ++i) results[0][i] = query.from_code(results[0][i]);
      return;
    }
    const QueryKernel kernel = kernel_of(query, pairs.first().kind(), pairs.second().kind());
    if (kernel != nullptr && ask_kernel(kernel, query, pairs, results)) return;
    ask_scalar(query, pairs, kernel == nullptr, results);
  }

  /// What is an error of the other query is looked at anew.
  void derive(const Query& query, const Pairs& pairs, Results& results) noexcept {
    const std::int32_t error = error_;
    answer(*query.asked_instead, pairs, results);
    error_ = error;
    for (std::int32_t i = 0; i < pairs.n; ++i) {
      double a[max_fields], b[max_fields], number = std::numeric_limits<double>::quiet_NaN();
      note(query.derive(results[0][i], pairs.a.shape(i, a), pairs.b.shape(i, b), number));
      results[0][i] = number;
    }
  }

  QueryKernel kernel_of(const Query& query, std::int32_t first, std::int32_t second) const noexcept {
    return query.kernels == nullptr ? nullptr : (kernels_.queries->*query.kernels)[first][second];
  }

  /// Whether that answered all.
  bool ask_kernel(QueryKernel kernel, const Query& query, const Pairs& pairs, Results& results) noexcept {
    double known[query_block];
    const QueryColumns asked{pairs.first().operand(), pairs.second().operand(), known};
    tell(query, pairs, asked, known);
    if (query.known == Known::reach) {
      std::int32_t near[query_block];
      const std::int32_t count = find_near(asked, pairs.n, near);
      if (2 * count <= pairs.n) return ask_kernel_of(near, count, kernel, pairs, results);
    }
    double* columns[max_results] = {results[0], results[1], results[2], results[3], results[4]};
    if (pairs.reversed() && query.reversal == Reversal::points) {
      std::swap(columns[1], columns[3]);
      std::swap(columns[2], columns[4]);
    }
    const bool all_settled = kernel(asked, whole_vectors(pairs.n), columns);
    if (pairs.reversed()) reverse_columns(query.reversal, pairs.n, results);
    return all_settled;
  }

  /// The pairs whose circles are not certainly apart.
  std::int32_t find_near(const QueryColumns& asked, std::int32_t n, std::int32_t (&near)[query_block]) noexcept {
    std::uint8_t apart[query_block];
    kernels_.queries->apart(asked, whole_vectors(n), apart);
    std::int32_t count = 0;
    for (std::int32_t i = 0; i < n; ++i) {
      near[count] = i;
      count += 1 - apart[i];
    }
    return count;
  }

  /// Only the listed pairs, put side by side; what shapes that are apart share is 0.
  bool ask_kernel_of(const std::int32_t* list, std::int32_t count, QueryKernel kernel, const Pairs& pairs,
                     Results& results) noexcept {
    for (std::int32_t i = 0; i < pairs.n; ++i) results[0][i] = 0;
    if (count == 0) return true;
    const QueryColumns asked{gathered(pairs.first(), list, count, first_near_),
                             gathered(pairs.second(), list, count, second_near_), first_near_.area()};
    double found[query_block];
    double* columns[max_results] = {found};
    const bool all_settled = kernel(asked, whole_vectors(count), columns);
    for (std::int32_t i = 0; i < count; ++i) results[0][list[i]] = found[i];
    return all_settled;
  }

  static QueryOperand gathered(const NumberColumns& from, const std::int32_t* list, std::int32_t count,
                               NumberColumns& room) noexcept {
    if (from.repeated()) return from.operand();
    room.gather(from, list, count);
    return room.operand();
  }

  /// Whether they overlap. Errors show again when the scalar function is asked.
  void tell(const Query& query, const Pairs& pairs, const QueryColumns& asked, double (&known)[query_block]) noexcept {
    if (query.known == Known::overlap) {
      std::uint8_t bytes[query_block];
      const std::int32_t n = whole_vectors(pairs.n);
      overlap_block(kernels_, pairs.first().kind(), asked.first.number, pairs.second().kind(), asked.second.number, n,
                    bytes);
      for (std::int32_t i = 0; i < n; ++i) known[i] = bytes[i];
    }
  }

  void note(std::int32_t error) noexcept {
    if (error < 0 && error_ != error_shape) error_ = error;
  }

  /// All pairs, or only those that a kernel left open by a NaN.
  void ask_scalar(const Query& query, const Pairs& pairs, bool all, Results& results) noexcept {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const PairFunction answer_pair = query.doubles.of[pairs.a.kind()][pairs.b.kind()];
    for (std::int32_t i = 0; i < pairs.n; ++i) {
      if (!all && !std::isnan(results[0][i])) continue;
      double a[max_fields], b[max_fields], numbers[max_results];
      pairs.a.element(i, a);
      pairs.b.element(i, b);
      const std::int32_t code = answer_pair(a, b, numbers);
      if (code < 0) {
        note(code);
        for (int k = 0; k < query.columns(); ++k) results[k][i] = nan;
      } else if (query.numbers == 0) {
        results[0][i] = code;
      } else {
        for (int k = 0; k < query.numbers; ++k) results[k][i] = numbers[k];
      }
    }
  }
};

template <class Out>
std::int64_t count(const Query& query, const Out* numbers, std::int32_t n) noexcept {
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < n; ++i) count += query.counts_zero ? numbers[i] <= 0 : numbers[i] > 0;
  return count;
}

}  // namespace

template <class T, class Out>
QueryTally query_many(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                      std::int64_t n, Out* const* columns) noexcept {
  Engine engine(query, kernels);
  Pairs pairs;
  Stored<Out> results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < n; begin += query_block) {
    pairs.n = block_length(n - begin, query_block);
    if (begin == 0 || a.stride != 0) pairs.a.set(a, begin, pairs.n, query, kernels);
    if (begin == 0 || b.stride != 0) pairs.b.set(b, begin, pairs.n, query, kernels);
    engine.answer<Out>(pairs, results);
    counted += count(query, results[0], pairs.n);
    for (int k = 0; k < query.columns(); ++k) {
      if (columns[k] == nullptr) continue;
      std::memcpy(columns[k] + begin, results[k], static_cast<std::size_t>(pairs.n) * sizeof(Out));
    }
  }
  return {counted, engine.error()};
}

template <class T, class Out>
QueryTally query_matrix(const Query& query, const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b,
                        Out* out, std::ptrdiff_t row_stride) noexcept {
  Engine engine(query, kernels);
  Pairs pairs;
  Stored<Out> results;
  std::int64_t counted = 0;
  for (std::int64_t begin = 0; begin < b.count; begin += query_block) {
    pairs.n = block_length(b.count - begin, query_block);
    pairs.b.set(b, begin, pairs.n, query, kernels);
    for (std::int64_t row = 0; row < a.count; ++row) {
      pairs.a.set(element(a, row), 0, pairs.n, query, kernels);
      engine.answer<Out>(pairs, results);
      counted += count(query, results[0], pairs.n);
      std::memcpy(out + row * row_stride + begin, results[0], static_cast<std::size_t>(pairs.n) * sizeof(Out));
    }
  }
  return {counted, engine.error()};
}

#define VESICA_QUERIES(T, Out)                                                                                       \
  template QueryTally query_many(const Query&, const KernelTable&, const Shapes<T>&, const Shapes<T>&, std::int64_t, \
                                 Out* const*) noexcept;                                                              \
  template QueryTally query_matrix(const Query&, const KernelTable&, const Shapes<T>&, const Shapes<T>&, Out*,       \
                                   std::ptrdiff_t) noexcept;
VESICA_QUERIES(float, float)
VESICA_QUERIES(double, double)
VESICA_QUERIES(float, std::uint8_t)
VESICA_QUERIES(double, std::uint8_t)
#undef VESICA_QUERIES

}  // namespace vesica::batch
