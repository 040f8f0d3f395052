# SPDX-License-Identifier: Apache-2.0
# CMake toolchain: clang and lld with wasi-libc, libc++-14-dev-wasm32 and libclang-rt-14-dev-wasm32, as Debian 12 has
# them. "Generic" is a machine without a system, and so without shared libraries.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_COMPILER clang)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER clang++)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
