// SPDX-License-Identifier: Apache-2.0
/// Stands in for CUDA's header where a kernel is compiled as plain C++: a grid is two loops, and a launch has ended
/// when it returns. What vesica/cuda.cuh, the program of docs/cuda.md and bench/cuda use, and no more. With
/// VESICA_NO_DEVICE in the environment there is no device. What a batch queues fails where a test asks for it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <cstring>

#define __global__
#define __device__
#define __host__

struct dim3 {
  unsigned x = 1, y = 1, z = 1;
  dim3() = default;
  explicit dim3(unsigned size) : x(size) {}
};
inline dim3 gridDim, blockDim, blockIdx, threadIdx;

enum cudaError_t { cudaSuccess = 0, cudaErrorInvalidValue = 1, cudaErrorLaunchFailure = 719 };
using cudaStream_t = struct CUstream_st*;
struct cudaLaunchConfig_t {
  dim3 gridDim, blockDim;
  cudaStream_t stream;
};

template <class T>
T atomicAdd(T* at, T added) {
  const T before = *at;
  *at += added;
  return before;
}

/// How many are queued from now on until one fails, that one too; 0: none does. And how many have not failed.
inline int queued_until_failure = 0, queued = 0;
inline bool queue_fails() {
  if (queued_until_failure > 0 && --queued_until_failure == 0) return true;
  ++queued;
  return false;
}

inline cudaError_t cudaMemsetAsync(void* at, int value, std::size_t size, cudaStream_t) {
  if (queue_fails()) return cudaErrorLaunchFailure;
  std::memset(at, value, size);
  return cudaSuccess;
}

enum cudaMemcpyKind { cudaMemcpyHostToDevice, cudaMemcpyDeviceToHost, cudaMemcpyDeviceToDevice };
inline cudaError_t cudaMemcpy(void* to, const void* from, std::size_t size, cudaMemcpyKind) {
  if (size > 0) std::memcpy(to, from, size);
  return cudaSuccess;
}
inline cudaError_t cudaMemcpyAsync(void* to, const void* from, std::size_t size, cudaMemcpyKind kind) {
  return cudaMemcpy(to, from, size, kind);
}

inline cudaError_t cudaMalloc(void** at, std::size_t size) {
  *at = std::malloc(size);
  return cudaSuccess;
}
template <class T>
cudaError_t cudaMallocManaged(T** at, std::size_t size) {
  *at = static_cast<T*>(std::malloc(size));
  return cudaSuccess;
}
inline cudaError_t cudaDeviceSynchronize() { return cudaSuccess; }
inline cudaError_t cudaFree(void* at) {
  std::free(at);
  return cudaSuccess;
}

inline const char* cudaGetErrorString(cudaError_t error) {
  return error == cudaSuccess             ? "no error"
         : error == cudaErrorInvalidValue ? "invalid argument"
                                          : "unspecified launch failure";
}
inline cudaError_t cudaGetDeviceCount(int* count) {
  *count = std::getenv("VESICA_NO_DEVICE") == nullptr ? 1 : 0;
  return cudaSuccess;
}
struct cudaDeviceProp {
  char name[256];
  int multiProcessorCount;
};
inline cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int) {
  *properties = {"no device but its stand-in", 1};
  return cudaSuccess;
}

using cudaEvent_t = std::chrono::steady_clock::time_point*;
inline cudaError_t cudaEventCreate(cudaEvent_t* event) {
  *event = new std::chrono::steady_clock::time_point;
  return cudaSuccess;
}
inline cudaError_t cudaEventDestroy(cudaEvent_t event) {
  delete event;
  return cudaSuccess;
}
inline cudaError_t cudaEventRecord(cudaEvent_t event) {
  *event = std::chrono::steady_clock::now();
  return cudaSuccess;
}
inline cudaError_t cudaEventSynchronize(cudaEvent_t) { return cudaSuccess; }
inline cudaError_t cudaEventElapsedTime(float* milliseconds, cudaEvent_t start, cudaEvent_t stop) {
  *milliseconds = std::chrono::duration<float, std::milli>(*stop - *start).count();
  return cudaSuccess;
}

/// Threads may run in any order; so tests ask for both.
inline bool last_thread_first = false;

template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config, void (*kernel)(Parameters...),
                               Arguments&&... arguments) {
  if (queue_fails()) return cudaErrorLaunchFailure;
  gridDim = config->gridDim;
  blockDim = config->blockDim;
  const unsigned count = gridDim.x * blockDim.x;
  for (unsigned i = 0; i < count; ++i) {
    const unsigned thread = last_thread_first ? count - 1 - i : i;
    blockIdx = dim3(thread / blockDim.x);
    threadIdx = dim3(thread % blockDim.x);
    kernel(arguments...);
  }
  return cudaSuccess;
}
