// SPDX-License-Identifier: Apache-2.0
/// Memory of a CUDA device that frees itself, and arrays of shapes in it.
#pragma once

#include <array>
#include <cstddef>
#include <stdexcept>
#include <vector>
#include <vesica/cuda.cuh>

namespace vesica::bench {

inline void must_succeed(cudaError_t error) {
  if (error != cudaSuccess) throw std::runtime_error(cudaGetErrorString(error));
}

/// `count` numbers.
template <class T>
class DeviceMemory {
 public:
  explicit DeviceMemory(std::size_t count) : bytes_(count * sizeof(T)) {
    void* memory = nullptr;
    must_succeed(cudaMalloc(&memory, bytes_ == 0 ? sizeof(T) : bytes_));
    memory_ = static_cast<T*>(memory);
  }
  explicit DeviceMemory(const std::vector<T>& numbers) : DeviceMemory(numbers.size()) {
    must_succeed(cudaMemcpy(memory_, numbers.data(), bytes_, cudaMemcpyHostToDevice));
  }
  DeviceMemory(const DeviceMemory&) = delete;
  DeviceMemory& operator=(const DeviceMemory&) = delete;
  ~DeviceMemory() { static_cast<void>(cudaFree(memory_)); }

  T* get() const { return memory_; }
  std::size_t bytes() const { return bytes_; }

  /// The contents, once all queued work is done.
  std::vector<T> read(std::size_t count) const {
    std::vector<T> numbers(count);
    must_succeed(cudaMemcpy(numbers.data(), memory_, count * sizeof(T), cudaMemcpyDeviceToHost));
    return numbers;
  }

 private:
  T* memory_ = nullptr;
  std::size_t bytes_;
};

/// The memory that a batch works in.
class DeviceWork {
 public:
  explicit DeviceWork(std::int64_t pairs) : memory_(cuda::work_bytes(pairs) / 4) {}
  cuda::Work work() const { return {memory_.get(), memory_.bytes()}; }
  std::uint32_t invalid() const { return memory_.read(1)[0]; }

 private:
  DeviceMemory<std::uint32_t> memory_;
};

/// Shapes of one kind, a column a number.
template <class T>
class DeviceColumns {
 public:
  /// `numbers` has the columns one after the other, `count` long each.
  DeviceColumns(std::int32_t kind, std::int64_t count, const std::vector<T>& numbers)
      : kind_(kind), count_(count), memory_(numbers) {}

  cuda::Shapes<T> shapes() const {
    cuda::Shapes<T> s{kind_, 0, count_, sizeof(T), {}};
    const std::size_t columns = memory_.bytes() / sizeof(T) / static_cast<std::size_t>(count_);
    for (std::size_t k = 0; k < columns; ++k) s.field[k] = memory_.get() + k * static_cast<std::size_t>(count_);
    return s;
  }

 private:
  std::int32_t kind_;
  std::int64_t count_;
  DeviceMemory<T> memory_;
};

}  // namespace vesica::bench
