// SPDX-License-Identifier: Apache-2.0
#include "batch.hpp"

#include <vesica/overlap.hpp>

#include "columns.hpp"

namespace vesica::batch {

namespace {

/// The pair that was asked for and the pair that is computed: kinds in the order of shapes.
template <class T>
struct Question {
  const KernelTable& kernels;
  std::int32_t kind_first, kind_second;
  const PairKernels<T>& pair;

  Question(const KernelTable& table, std::int32_t first, std::int32_t second) noexcept
      : kernels(table), kind_first(first), kind_second(second), pair(table.of(T{})[first][second]) {}
};

/// Exact answer for flat numbers that no filter decided.
std::int32_t decide_exactly(std::int32_t kind_a, const double* a, std::int32_t kind_b, const double* b) noexcept {
  return with_shape(kind_a, a, [&]<template <class> class A>(const A<double>& shape_a) {
    return with_shape(kind_b, b, [&]<template <class> class B>(const B<double>& shape_b) -> std::int32_t {
      if constexpr (detail::in_order<A<double>, B<double>>) return detail::decide_undecided(shape_a, shape_b);
      return error_kind;
    });
  });
}

template <class T>
struct Answerer {
  const Question<T>& question;
  Tally tally;

  /// The numbers of n elements, exact as doubles.
  template <int Chunk>
  static void gather(const T* const* field, int fields, bool repeated, const std::int32_t* index, std::int32_t n,
                     double (&out)[max_fields][Chunk]) noexcept {
    for (int k = 0; k < fields; ++k) {
      for (std::int32_t i = 0; i < n; ++i) {
        T x;
        std::memcpy(&x, field[k] + (repeated ? 0 : index[i]), sizeof x);
        out[k][i] = x;
      }
    }
  }

  void settle(std::int32_t answer, std::uint8_t* out) noexcept {
    if (answer < 0) tally.invalid = true;
    *out = answer == 1;
    tally.overlaps += *out;
  }

  /// One element by the exact stage.
  void resolve(const Block<T>& block, Repeat repeat, std::int32_t i) noexcept {
    double a[max_fields][1], b[max_fields][1];
    gather(block.first, field_count(question.kind_first), repeat == Repeat::first, &i, 1, a);
    gather(block.second, field_count(question.kind_second), repeat == Repeat::second, &i, 1, b);
    settle(decide_exactly(question.kind_first, a[0], question.kind_second, b[0]), block.out + i);
  }

  /// Elements that float lanes left open, a chunk at a time in double lanes; what those leave open, exactly.
  void retry_in_double(const Block<T>& block, Repeat repeat, std::int32_t undecided) noexcept {
    constexpr std::int32_t chunk = 64;
    const auto& pair = question.kernels.f64[question.kind_first][question.kind_second];
    const int fields_a = field_count(question.kind_first), fields_b = field_count(question.kind_second);
    double a[max_fields][chunk], b[max_fields][chunk];
    std::uint8_t answers[chunk];
    std::int32_t open[chunk];
    Block<double> retry{};
    for (int k = 0; k < max_fields; ++k) {
      retry.first[k] = a[k];
      retry.second[k] = b[k];
    }
    retry.out = answers;
    retry.undecided = open;
    for (std::int32_t begin = 0; begin < undecided; begin += chunk) {
      const std::int32_t* index = block.undecided + begin;
      retry.count = undecided - begin < chunk ? undecided - begin : chunk;
      gather(block.first, fields_a, repeat == Repeat::first, index, retry.count, a);
      gather(block.second, fields_b, repeat == Repeat::second, index, retry.count, b);
      const BlockResult result = pair.general[static_cast<int>(Repeat::none)](retry);
      tally.overlaps += result.overlaps;
      for (std::int32_t i = 0; i < retry.count; ++i) block.out[index[i]] = answers[i];
      for (std::int32_t i = 0; i < result.undecided; ++i) resolve(block, repeat, index[open[i]]);
    }
  }

  /// Answers a block: the kernel for unit axes first, the general one where that left much open, then what remains.
  void answer(const Block<T>& block, Repeat repeat) noexcept {
    const int way = static_cast<int>(repeat);
    BlockResult result = question.pair.unit[way](block);
    if (question.pair.unit[way] != question.pair.general[way] && result.undecided > block.count / 4) {
      result = question.pair.general[way](block);
    }
    tally.overlaps += result.overlaps;
    if constexpr (sizeof(T) == sizeof(float)) {
      retry_in_double(block, repeat, result.undecided);
    } else {
      for (std::int32_t i = 0; i < result.undecided; ++i) resolve(block, repeat, block.undecided[i]);
    }
  }
};

/// A block of the columns of both operands.
template <class T>
Block<T> make_block(const Columns<T>& first, const Columns<T>& second, std::int32_t n, std::uint8_t* out,
                    std::int32_t* undecided) noexcept {
  Block<T> block{};
  for (int k = 0; k < max_fields; ++k) {
    block.first[k] = first.field[k];
    block.second[k] = second.field[k];
  }
  block.count = n;
  block.out = out;
  block.undecided = undecided;
  return block;
}

template <class T>
std::int32_t block_length(std::int64_t rest) noexcept {
  return static_cast<std::int32_t>(rest < block_size<T> ? rest : block_size<T>);
}

/// Calls done(begin, length, bytes) for each block of n pairs in step, answered into place(begin).
template <class T, class Place, class Done>
Tally in_step(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, Place place,
              Done done) noexcept {
  const Shapes<T>& first = a.kind <= b.kind ? a : b;
  const Shapes<T>& second = a.kind <= b.kind ? b : a;
  const Question<T> question(kernels, first.kind, second.kind);
  const Repeat repeat = first.stride == 0 ? Repeat::first : second.stride == 0 ? Repeat::second : Repeat::none;
  Answerer<T> answerer{question, {}};
  Columns<T> columns_first, columns_second;
  std::int32_t undecided[block_size<T>];
  for (std::int64_t begin = 0; begin < n; begin += block_size<T>) {
    const std::int32_t length = block_length<T>(n - begin);
    columns_first.set(first, begin, repeat == Repeat::first ? 1 : length);
    columns_second.set(second, begin, repeat == Repeat::second ? 1 : length);
    std::uint8_t* out = place(begin);
    answerer.answer(make_block(columns_first, columns_second, length, out, undecided), repeat);
    done(begin, length, out);
  }
  return answerer.tally;
}

}  // namespace

template <class T>
Tally many(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n,
           std::uint8_t* out) noexcept {
  return in_step(
      kernels, a, b, n, [out](std::int64_t begin) { return out + begin; },
      [](std::int64_t, std::int32_t, const std::uint8_t*) {});
}

template <class T>
Tally select(const KernelTable& kernels, const Shapes<T>& one, const Shapes<T>& many, std::int64_t* out,
             std::int64_t capacity) noexcept {
  std::uint8_t bytes[block_size<T>];
  std::int64_t found = 0;
  const Tally tally = in_step(
      kernels, one, many, many.count, [&](std::int64_t) { return bytes; },
      [&](std::int64_t begin, std::int32_t length, const std::uint8_t* answers) {
        for (std::int32_t i = 0; i < length; ++i) {
          if (answers[i] == 0) continue;
          if (found < capacity) out[found] = begin + i;
          ++found;
        }
      });
  return tally;
}

template <class T>
Tally matrix(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::uint8_t* out,
             std::ptrdiff_t row_stride) noexcept {
  const bool in_order = a.kind <= b.kind;
  const Question<T> question(kernels, in_order ? a.kind : b.kind, in_order ? b.kind : a.kind);
  const Repeat repeat = in_order ? Repeat::first : Repeat::second;
  Answerer<T> answerer{question, {}};
  Columns<T> row, columns;
  std::int32_t undecided[block_size<T>];
  // A block of b stays in cache while every row passes over it.
  for (std::int64_t begin = 0; begin < b.count; begin += block_size<T>) {
    const std::int32_t length = block_length<T>(b.count - begin);
    columns.set(b, begin, length);
    for (std::int64_t i = 0; i < a.count; ++i) {
      row.set(a, i, 1);
      answerer.answer(make_block(in_order ? row : columns, in_order ? columns : row, length,
                                 out + i * row_stride + begin, undecided),
                      repeat);
    }
  }
  return answerer.tally;
}

template Tally many(const KernelTable&, const Shapes<float>&, const Shapes<float>&, std::int64_t,
                    std::uint8_t*) noexcept;
template Tally many(const KernelTable&, const Shapes<double>&, const Shapes<double>&, std::int64_t,
                    std::uint8_t*) noexcept;
template Tally matrix(const KernelTable&, const Shapes<float>&, const Shapes<float>&, std::uint8_t*,
                      std::ptrdiff_t) noexcept;
template Tally matrix(const KernelTable&, const Shapes<double>&, const Shapes<double>&, std::uint8_t*,
                      std::ptrdiff_t) noexcept;
template Tally select(const KernelTable&, const Shapes<float>&, const Shapes<float>&, std::int64_t*,
                      std::int64_t) noexcept;
template Tally select(const KernelTable&, const Shapes<double>&, const Shapes<double>&, std::int64_t*,
                      std::int64_t) noexcept;

}  // namespace vesica::batch
