// SPDX-License-Identifier: Apache-2.0
/// A fuzzer's bytes as arguments of calls.
#pragma once

#include <vesica.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include "batch/guard_pages.hpp"

namespace fuzz {

using batch_tests::Edge;
using batch_tests::GuardedMemory;

/// Takes values off the front; zeros where nothing is left.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  template <class T>
  T take() {
    T value{};
    const std::size_t n = size_ < sizeof value ? size_ : sizeof value;
    std::memcpy(&value, data_, n);
    data_ += n;
    size_ -= n;
    return value;
  }

  unsigned below(unsigned count) { return take<std::uint8_t>() % count; }

  /// A kind, those with a radius about a core less often; or now and then anything but a kind whose shapes are pointers
  /// to vertices, which a row of numbers is not.
  std::int32_t kind() {
    const unsigned choice = below(64);
    if (choice == 63) {
      const auto any = take<std::int32_t>();
      return any == VESICA_POLYGON || any == VESICA_POLYLINE ? -1 : any;
    }
    return static_cast<std::int32_t>(choice < 48 ? choice % 6 : VESICA_CAPSULE + choice % 2);
  }

  /// Small whole numbers and halves, powers of two, or any bits at all.
  template <class T>
  T number() {
    switch (below(4)) {
      case 0:
        return static_cast<T>(take<std::int8_t>()) / 2;
      case 1:
        return std::ldexp(static_cast<T>(take<std::int8_t>()), take<std::int16_t>() % 1100);
      default:
        return take<T>();
    }
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

/// Must hold after every call; the fuzzer reports it if not.
inline void demand(bool holds, const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
  if (holds) return;
  std::fprintf(stderr, "%s:%d: does not hold\n", file, line);
  __builtin_trap();
}

/// Numbers of a shape against a guard page: as many as its kind has, so that no reading is legal beyond them.
template <class T>
class Shape {
 public:
  Shape(Bytes& bytes, GuardedMemory& memory) : kind_(bytes.kind()) {
    if (bytes.below(128) == 127) return;
    const std::int32_t count = vesica_field_count(kind_);
    const std::size_t fields = count < 0 ? 0 : static_cast<std::size_t>(count);
    auto* numbers = reinterpret_cast<T*>(memory.place(fields * sizeof(T), Edge::after));
    for (std::size_t i = 0; i < fields; ++i) numbers[i] = bytes.number<T>();
    numbers_ = numbers;
  }
  std::int32_t kind() const { return kind_; }
  const T* numbers() const { return numbers_; }

 private:
  std::int32_t kind_;
  const T* numbers_ = nullptr;
};

/// An output against a guard page that shows whether it was written to.
template <class Out>
class Output {
 public:
  explicit Output(GuardedMemory& memory, bool null = false)
      : bytes_(null ? nullptr : memory.place(sizeof(Out), Edge::after)) {
    if (bytes_ != nullptr) std::memset(bytes_, mark, sizeof(Out));
  }
  Out* get() const { return reinterpret_cast<Out*>(bytes_); }
  bool untouched() const {
    for (std::size_t i = 0; bytes_ != nullptr && i < sizeof(Out); ++i) {
      if (std::to_integer<int>(bytes_[i]) != mark) return false;
    }
    return true;
  }

 private:
  static constexpr int mark = 0xA5;
  std::byte* bytes_;
};

/// Three pieces of memory: two inputs and an output.
struct Memory {
  GuardedMemory a, b, out;
};

void call_batch(Bytes& bytes, Memory& memory);
void call_boxes(Bytes& bytes, Memory& memory);
void call_constructor(Bytes& bytes, Memory& memory);
void call_index(Bytes& bytes, Memory& memory);
void call_motion(Bytes& bytes, Memory& memory);
void call_polygons(Bytes& bytes, Memory& memory);
void call_topology(Bytes& bytes, Memory& memory);

}  // namespace fuzz
