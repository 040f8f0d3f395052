// SPDX-License-Identifier: Apache-2.0
/// Stands in for CUDA's header where Clang compiles device code without CUDA: what vesica/cuda.cuh and the core use of
/// it. Of the host's side there are declarations alone.
#pragma once

#define __CUDACC__
#define __global__ __attribute__((global))
#define __device__ __attribute__((device))
#define __host__ __attribute__((host))

#include <cmath>
#include <cstddef>
#include <cstring>

struct dim3 {
  unsigned x, y, z;
  dim3(unsigned size = 1, unsigned size_y = 1, unsigned size_z = 1) : x(size), y(size_y), z(size_z) {}
};
struct uint3;
#include <__clang_cuda_builtin_vars.h>

__device__ inline unsigned atomicAdd(unsigned* at, unsigned added) {
  return __atomic_fetch_add(at, added, __ATOMIC_RELAXED);
}

// Device overloads of the C functions that the core calls; Clang turns them into instructions. The overloads for float
// are the C++ library's own.
__device__ inline double fabs(double x) { return __builtin_fabs(x); }
__device__ inline double sqrt(double x) { return __nvvm_sqrt_rn_d(x); }
__device__ inline double fma(double x, double y, double z) { return __builtin_fma(x, y, z); }
__device__ inline void* memmove(void* to, const void* from, std::size_t size) {
  return __builtin_memmove(to, from, size);
}
namespace std {
using ::fabs;
using ::fma;
using ::memmove;
using ::sqrt;
}  // namespace std

enum cudaError_t { cudaSuccess = 0, cudaErrorInvalidValue = 1 };
using cudaStream_t = struct CUstream_st*;
struct cudaLaunchConfig_t {
  dim3 gridDim, blockDim;
  cudaStream_t stream;
};
cudaError_t cudaMemsetAsync(void* at, int value, std::size_t size, cudaStream_t stream);
template <class... Parameters, class... Arguments>
cudaError_t cudaLaunchKernelEx(const cudaLaunchConfig_t* config, void (*kernel)(Parameters...),
                               Arguments&&... arguments);
