// SPDX-License-Identifier: Apache-2.0
#include "batch.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "columns.hpp"
#include "polygon/blocks.hpp"
#include "queries/overlap.hpp"
#include "tiles.hpp"

namespace vesica::batch {

namespace {

/// A pair of kinds, in the order of shapes, with its kernels.
template <class T>
struct Question {
  const KernelTable& kernels;
  Common common;
  std::int32_t kind_first, kind_second;
  int fields_first, fields_second;
  const PairKernels<T>& pair;

  Question(const KernelTable& table, Common counted, std::int32_t first, std::int32_t second) noexcept
      : kernels(table),
        common(counted),
        kind_first(first),
        kind_second(second),
        fields_first(field_count(first)),
        fields_second(field_count(second)),
        pair(has_insides_kernels() ? table.insides(T{}).of[first] : table.of(T{})[first][second]) {}

  /// The kernels of a pair of kinds decide both questions, unless it has kernels of its own for insides.
  bool has_insides_kernels() const noexcept {
    return common == Common::insides &&
           detail::overlap::has_insides_filter(static_cast<Kind>(kind_first), static_cast<Kind>(kind_second));
  }
  const PackedKernels<T>& packed() const noexcept {
    return has_insides_kernels() ? kernels.insides(T{}).packed : kernels.packed(T{});
  }
};

/// Answers a block by a kernel, which takes whole vectors only. If elements are left over, the last whole vector of the
/// block is answered too, so that some elements are answered twice; a block shorter than a vector is copied and padded.
template <class T>
class RestOfBlock {
 public:
  RestOfBlock(const Question<T>& question, Repeat repeat) noexcept
      : width_(question.kernels.width(T{})),
        fields_first_(repeat == Repeat::first ? 0 : question.fields_first),
        fields_second_(repeat == Repeat::second ? 0 : question.fields_second) {}

  BlockResult answer(BlockKernel<T> kernel, const Block<T>& block) const noexcept {
    const std::int32_t rest = block.count % width_;
    if (rest == 0) return kernel(block);
    if (block.count < width_) return answer_rest(kernel, block, rest, {0, 0});
    Block<T> part = block;
    part.count = block.count - rest;
    const BlockResult result = kernel(part);
    return result.undecided > block.give_up ? result : answer_rest(kernel, block, rest, result);
  }

 private:
  static constexpr std::int32_t widest = 16;
  using Copy = T[max_fields][widest];

  std::int32_t width_;
  int fields_first_, fields_second_;  // of operands that do not repeat

  BlockResult answer_rest(BlockKernel<T> kernel, const Block<T>& block, std::int32_t rest,
                          BlockResult result) const noexcept {
    Copy copy_first, copy_second;
    std::uint8_t bytes[widest];
    std::int32_t undecided[widest];
    Block<T> last = block;
    last.count = width_;
    last.out = bytes;
    last.undecided = undecided;
    last.give_up = width_;
    const std::int32_t begin = block.count - width_, skipped = begin < 0 ? 0 : width_ - rest;
    if (begin < 0) {
      copy(last.first, fields_first_, rest, copy_first);
      copy(last.second, fields_second_, rest, copy_second);
    } else {
      for (int k = 0; k < fields_first_; ++k) last.first[k] = last.first[k] + begin;
      for (int k = 0; k < fields_second_; ++k) last.second[k] = last.second[k] + begin;
    }
    const BlockResult found = kernel(last);
    const std::int32_t whole = block.count - rest;
    for (std::int32_t i = 0; i < rest; ++i) {
      block.out[whole + i] = bytes[skipped + i];
      result.overlaps += bytes[skipped + i];
    }
    for (std::int32_t i = 0; i < found.undecided; ++i) {
      const std::int32_t lane = undecided[i] - skipped;
      if (lane >= 0 && lane < rest) block.undecided[result.undecided++] = whole + lane;
    }
    return result;
  }

  /// Lanes without an element repeat the first.
  static void copy(Unaligned<T> (&field)[max_fields], int fields, std::int32_t rest, Copy& copied) noexcept {
    for (int k = 0; k < fields; ++k) {
      std::fill_n(copied[k], widest, field[k][0]);
      copy_few(field[k], rest, copied[k]);
      field[k] = copied[k];
    }
  }

  /// 0 < n < 16 numbers: two moves of one size, the second of which may overlap the first, instead of a loop.
  static void copy_few(Unaligned<T> from, std::int32_t n, T* to) noexcept {
    const auto move = [&]<std::int32_t size>(std::integral_constant<std::int32_t, size>) {
      std::memcpy(to, from.bytes(), size * sizeof(T));
      std::memcpy(to + n - size, from.bytes(n - size), size * sizeof(T));
    };
    if (n >= 8) return move(std::integral_constant<std::int32_t, 8>{});
    if (n >= 4) return move(std::integral_constant<std::int32_t, 4>{});
    if (n >= 2) return move(std::integral_constant<std::int32_t, 2>{});
    move(std::integral_constant<std::int32_t, 1>{});
  }
};

template <class T>
BlockResult answer_block(const Question<T>& question, Repeat repeat, BlockKernel<T> kernel,
                         const Block<T>& block) noexcept {
  return RestOfBlock<T>(question, repeat).answer(kernel, block);
}

template <class T>
struct Answerer {
  const Question<T>& question;
  Tally tally;

  /// The numbers of element i as doubles.
  static void widen(const Unaligned<T>* field, int fields, std::ptrdiff_t offset, double (&out)[max_fields]) noexcept {
    for (int k = 0; k < fields; ++k) out[k] = static_cast<double>(field[k].advanced(offset)[0]);
  }

  /// Answers the pairs that a kernel left undecided by the scalar function.
  [[gnu::noinline]] void finish(const Block<T>& block, std::int32_t undecided) noexcept {
    const queries::OverlapFunction overlap = queries::overlap_in_order.of[question.kind_first][question.kind_second];
    for (std::int32_t k = 0; k < undecided; ++k) {
      const std::int32_t i = block.undecided[k];
      double a[max_fields], b[max_fields];
      widen(block.first, question.fields_first, i * block.stride_first, a);
      widen(block.second, question.fields_second, i * block.stride_second, b);
      const std::int32_t answer = overlap(a, b, question.common);
      tally.invalid |= answer < 0;
      tally.overlaps += answer == 1;
      block.out[i] = answer == 1;
    }
  }

  /// Answers a block by the kernel for unit axes, or, if it leaves too much undecided to pay, by the general one.
  void answer(Block<T>& block, Repeat repeat) noexcept {
    const BlockKernel<T> unit = question.pair.unit[static_cast<int>(repeat)];
    const BlockKernel<T> general = question.pair.general[static_cast<int>(repeat)];
    block.give_up = unit == general ? block.count : block.count / 32;
    BlockResult result = answer_block(question, repeat, unit, block);
    if (result.undecided > block.give_up) {
      block.give_up = block.count;
      result = answer_block(question, repeat, general, block);
    }
    tally.overlaps += result.overlaps;
    finish(block, result.undecided);
  }
};

/// A block of the columns of both operands.
template <class T, class Numbers>
Block<T> make_block(const Numbers* first, const Numbers* second, Repeat repeat, std::int32_t n, std::uint8_t* out,
                    std::int32_t* undecided) noexcept {
  Block<T> block{};
  block.stride_first = repeat == Repeat::first ? 0 : sizeof(T);
  block.stride_second = repeat == Repeat::second ? 0 : sizeof(T);
  for (int k = 0; k < max_fields; ++k) {
    block.first[k] = first[k];
    block.second[k] = second[k];
  }
  block.count = n;
  block.out = out;
  block.undecided = undecided;
  return block;
}

/// Rows of a matrix against one block of columns after another, by a checked kernel (kernels/checked.hpp) where it
/// pays.
template <class T>
class Rows {
 public:
  Rows(const Question<T>& question, Repeat repeat, typename CheckedKernels<T>::Pair checked) noexcept
      : answerer_{question, {}}, repeat_(repeat), kernels_(checked) {}

  /// space: room for the columns of a block.
  void begin(const Block<T>& block, std::int64_t rows, T* space) noexcept {
    whole_ = whole_checked_ = block;
    allowance_ = first_allowance * pairs_an_undecided;
    usable_ = rows >= worth_checking && kernels_.check_block != nullptr &&
              kernels_.check_block(whole_checked_, space, block_size<T>);
  }

  /// Rows that follow meet these columns of the block alone.
  void narrow(std::int32_t begin, std::int32_t length) noexcept {
    block_ = part(whole_, begin, length);
    checked_ = part(whole_checked_, begin, length);
    checked_.give_up = length / 32;
  }

  void answer(const Unaligned<T> (&shape)[max_fields], std::uint8_t* out) noexcept {
    if (usable_ && answer_checked(shape, out)) return;
    set_row(block_, shape, out);
    answerer_.answer(block_, repeat_);
  }

  const Tally& tally() const noexcept { return answerer_.tally; }

 private:
  static constexpr std::int64_t worth_checking = 4;
  static constexpr std::int64_t pairs_an_undecided = 512, first_allowance = 8;

  Answerer<T> answerer_;
  Repeat repeat_;
  typename CheckedKernels<T>::Pair kernels_;
  Block<T> whole_, whole_checked_;
  Block<T> block_, checked_;  // the columns that are met
  bool usable_ = false;
  std::int64_t allowance_ = 0;  // how much of this block checked kernels may still leave undecided

  Block<T> part(const Block<T>& whole, std::int32_t begin, std::int32_t length) const noexcept {
    Block<T> block = whole;
    const bool first_repeats = repeat_ == Repeat::first;
    auto& field = first_repeats ? block.second : block.first;
    // Fields beyond those of the kind are no addresses.
    const int fields = first_repeats ? answerer_.question.fields_second : answerer_.question.fields_first;
    for (int k = 0; k < fields; ++k) field[k] = field[k] + begin;
    block.count = length;
    return block;
  }

  void set_row(Block<T>& block, const Unaligned<T> (&shape)[max_fields], std::uint8_t* out) noexcept {
    auto& field = repeat_ == Repeat::first ? block.first : block.second;
    for (int k = 0; k < max_fields; ++k) field[k] = shape[k];
    block.out = out;
  }

  /// An undecided pair among 512 is allowed for. Blocks that have more have contacts, or shapes so unlike in size that
  /// one bound does not suit all: they are left to the other kernels.
  bool answer_checked(const Unaligned<T> (&shape)[max_fields], std::uint8_t* out) noexcept {
    set_row(checked_, shape, out);
    const BlockResult result = answer_block(answerer_.question, repeat_, kernels_.answer, checked_);
    if (result.undecided == row_is_unusable) return false;
    allowance_ += checked_.count - result.undecided * pairs_an_undecided;
    usable_ = allowance_ >= 0;
    if (result.undecided > checked_.give_up) return false;
    answerer_.tally.overlaps += result.overlaps;
    if (result.undecided > 0) {
      set_row(block_, shape, out);
      answerer_.finish(block_, result.undecided);
    }
    return true;
  }
};

/// Pairs of records without gaps, or one shape against such records, by a kernel that takes them as they are.
template <class T>
class PackedRecords {
 public:
  PackedRecords(const Question<T>& question, Repeat repeat, const Shapes<T>& first, const Shapes<T>& second) noexcept
      : first_(first), second_(second), width_(question.kernels.width(T{})), fields_(question.fields_first) {
    if (!has_packed_kernels || first.kind != second.kind || !has_no_gaps(second)) return;
    if (repeat == Repeat::first || has_no_gaps(first)) {
      kernel_ = question.packed()[first.kind][static_cast<int>(repeat)];
    }
  }

  /// Answers the first of n pairs, those of whole vectors, and returns how many. None once much stayed undecided.
  [[gnu::noinline]] std::int32_t answer(Answerer<T>& answerer, std::int64_t begin, std::int32_t n, std::uint8_t* out,
                                        std::int32_t* undecided) noexcept {
    if (!has_packed_kernels || kernel_ == nullptr || n < width_) return 0;
    Block<T> block{};
    for (int k = 0; k < fields_; ++k) {
      block.first[k] = first_.field[k].advanced(begin * first_.stride);
      block.second[k] = second_.field[k].advanced(begin * second_.stride);
    }
    block.count = n - n % width_;
    block.out = out;
    block.undecided = undecided;
    block.give_up = block.count / 32;
    block.stride_first = first_.stride;
    block.stride_second = second_.stride;
    const BlockResult result = kernel_(block);
    if (result.undecided > block.give_up) {
      kernel_ = nullptr;
      return 0;
    }
    answerer.tally.overlaps += result.overlaps;
    answerer.finish(block, result.undecided);
    return block.count;
  }

 private:
  const Shapes<T>&first_, &second_;
  std::int32_t width_;
  int fields_;
  BlockKernel<T> kernel_ = nullptr;

  bool has_no_gaps(const Shapes<T>& shapes) const noexcept {
    return shapes.stride == fields_ * static_cast<std::ptrdiff_t>(sizeof(T)) && lies_in_records(shapes, fields_);
  }
};

/// Calls done(begin, length, bytes) for each block of n pairs in step, answered into place(begin).
template <class T, class Place, class Done>
Tally in_step(const KernelTable& kernels, Common common, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n,
              Place place, Done done) noexcept {
  // If both kinds are the same, the second never repeats alone: there are no kernels for it.
  const bool in_order = a.kind < b.kind || (a.kind == b.kind && b.stride != 0);
  const Shapes<T>& first = in_order ? a : b;
  const Shapes<T>& second = in_order ? b : a;
  const Question<T> question(kernels, common, first.kind, second.kind);
  const Repeat repeat = first.stride == 0 ? Repeat::first : second.stride == 0 ? Repeat::second : Repeat::none;
  Answerer<T> answerer{question, {}};
  PackedRecords<T> packed(question, repeat, first, second);
  Columns<T, copied_block_size<T>> columns_first, columns_second;
  std::int32_t undecided[long_block_size];
  const bool in_place =
      (repeat == Repeat::first || lies_in_columns(first)) && (repeat == Repeat::second || lies_in_columns(second));
  const std::int32_t size = in_place ? long_block_size : copied_block_size<T>;
  for (std::int64_t begin = 0; begin < n; begin += long_block_size) {
    const std::int32_t length = block_length(n - begin, long_block_size);
    std::uint8_t* const out = place(begin);
    std::int32_t answered = packed.answer(answerer, begin, length, out, undecided);
    while (answered < length) {
      const std::int32_t part = block_length(length - answered, size);
      columns_first.set(kernels, first, begin + answered, repeat == Repeat::first ? 1 : part);
      columns_second.set(kernels, second, begin + answered, repeat == Repeat::second ? 1 : part);
      Block<T> block =
          make_block<T>(columns_first.field, columns_second.field, repeat, part, out + answered, undecided);
      answerer.answer(block, repeat);
      answered += part;
    }
    done(begin, length, out);
  }
  return answerer.tally;
}

}  // namespace

template <class T>
Tally many(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::int64_t n, std::uint8_t* out,
           Common common) noexcept {
  if (has_path(a, b)) {
    if (n > 0 && begin_as_rings(kernels, a, b)) {
      return rings_in_step(
          kernels, common, a, b, n, [out](std::int64_t begin) { return out + begin; },
          [](std::int64_t, std::int32_t, const std::uint8_t*) {});
    }
    Tally tally;
    each_in_step(a, b, n, [&](const Element<T>& first, const Element<T>& second, std::int64_t i) {
      out[i] = ask_path(common, first, second, tally);
    });
    return tally;
  }
  return in_step(
      kernels, common, a, b, n, [out](std::int64_t begin) { return out + begin; },
      [](std::int64_t, std::int32_t, const std::uint8_t*) {});
}

template <class T>
Tally select(const KernelTable& kernels, const Shapes<T>& one, const Shapes<T>& many, std::int64_t* out,
             std::int64_t capacity, Common common) noexcept {
  std::int64_t found = 0;
  std::uint8_t bytes[long_block_size];
  const auto place = [&](std::int64_t) { return bytes; };
  const auto done = [&](std::int64_t begin, std::int32_t length, const std::uint8_t* answers) {
    for (std::int32_t i = 0; i < length; ++i) {
      if (answers[i] == 0) continue;
      if (found < capacity) out[found] = begin + i;
      ++found;
    }
  };
  if (!has_path(one, many)) return in_step(kernels, common, one, many, many.count, place, done);
  if (many.count > 0 && begin_as_rings(kernels, one, many)) {
    return rings_in_step(kernels, common, one, many, many.count, place, done);
  }
  Tally tally;
  each_pair(one, many, [&](const Element<T>& first, const Element<T>& second, std::int64_t, std::int64_t i) {
    if (ask_path(common, first, second, tally) == 0) return;
    if (found < capacity) out[found] = i;
    ++found;
  });
  return tally;
}

template <class T>
Tally matrix(const KernelTable& kernels, const Shapes<T>& a, const Shapes<T>& b, std::uint8_t* out,
             std::ptrdiff_t row_stride, Common common) noexcept {
  if (has_path(a, b)) {
    if (begin_as_rings(kernels, a, b)) return ring_matrix(kernels, common, a, b, out, row_stride);
    Tally tally;
    each_pair(a, b, [&](const Element<T>& first, const Element<T>& second, std::int64_t i, std::int64_t j) {
      out[i * row_stride + j] = ask_path(common, first, second, tally);
    });
    return tally;
  }
  const bool in_order = a.kind <= b.kind;
  const Question<T> question(kernels, common, in_order ? a.kind : b.kind, in_order ? b.kind : a.kind);
  const Repeat repeat = in_order ? Repeat::first : Repeat::second;
  Rows<T> rows(question, repeat, kernels.checked(T{}).of[a.kind][b.kind]);
  Columns<T, block_size<T>> row, columns;
  std::int32_t undecided[block_size<T>];
  Tiles<T> tiles(kernels, a, b);
  // A block of b stays in cache while every row passes over it.
  for (std::int64_t begin = 0; begin < b.count; begin += block_size<T>) {
    const std::int32_t length = block_length(b.count - begin, block_size<T>);
    columns.set(kernels, b, begin, length);
    row.set(kernels, a, 0, 1);
    rows.begin(make_block<T>(in_order ? row.field : columns.field, in_order ? columns.field : row.field, repeat, length,
                             out, undecided),
               a.count, row.copy[0]);  // one shape needs no copy: there is room
    tiles.begin(begin, length);
    for (std::int64_t first = 0; first < a.count; first += Tiles<T>::rows) {
      const std::int32_t height = block_length(a.count - first, Tiles<T>::rows);
      tiles.each(first, height, [&](std::int32_t from, std::int32_t width, bool met) {
        if (met) rows.narrow(from, width);
        for (std::int64_t i = first; i < first + height; ++i) {
          std::uint8_t* const bytes = out + i * row_stride + begin + from;
          if (met) {
            row.set(kernels, a, i, 1);
            rows.answer(row.field, bytes);
          } else {
            std::memset(bytes, 0, static_cast<std::size_t>(width));
          }
        }
      });
    }
  }
  return rows.tally();
}

Tally overlap_block(const KernelTable& kernels, std::int32_t kind_first, const double* const* first,
                    std::int32_t kind_second, const double* const* second, std::int32_t n, std::uint8_t* out) noexcept {
  std::int32_t undecided[block_size<double>];
  const Question<double> question(kernels, Common::any, kind_first, kind_second);
  Answerer<double> answerer{question, {}};
  Block<double> block = make_block<double>(first, second, Repeat::none, n, out, undecided);
  answerer.answer(block, Repeat::none);
  return answerer.tally;
}

template Tally many(const KernelTable&, const Shapes<float>&, const Shapes<float>&, std::int64_t, std::uint8_t*,
                    Common) noexcept;
template Tally many(const KernelTable&, const Shapes<double>&, const Shapes<double>&, std::int64_t, std::uint8_t*,
                    Common) noexcept;
template Tally matrix(const KernelTable&, const Shapes<float>&, const Shapes<float>&, std::uint8_t*, std::ptrdiff_t,
                      Common) noexcept;
template Tally matrix(const KernelTable&, const Shapes<double>&, const Shapes<double>&, std::uint8_t*, std::ptrdiff_t,
                      Common) noexcept;
template Tally select(const KernelTable&, const Shapes<float>&, const Shapes<float>&, std::int64_t*, std::int64_t,
                      Common) noexcept;
template Tally select(const KernelTable&, const Shapes<double>&, const Shapes<double>&, std::int64_t*, std::int64_t,
                      Common) noexcept;

}  // namespace vesica::batch
