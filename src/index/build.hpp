// SPDX-License-Identifier: Apache-2.0
// Builds an index: plan, bin, place, finish, residue and tree. Why so, in docs/join.md.
#pragma once

#include <cstdint>

#include "index/kernels.hpp"

namespace vesica::index {

inline constexpr std::int64_t most_items = INT32_MAX;
inline constexpr int build_steps = 5;

/// Bytes that suffice for an index of `items` shapes, and for the scratch of its build.
std::int64_t size_bound(std::int64_t items) noexcept;
std::int64_t scratch_bound(std::int64_t items) noexcept;

/// One step of a build, `part` of `parts`: 0 and 4 by one caller, 1 to 3 by any number; each step waits for the one
/// before. index and scratch are aligned to 64 and as large as the bounds. Returns false, having done nothing, where
/// the scratch does not belong to a build whose next step this is, or where some of the part was done before.
bool build_step(const Kernels& kernels, const Sets& sets, int step, std::int64_t part, std::int64_t parts, void* index,
                void* scratch) noexcept;

/// Builds an index in the scratch of a call, which need not be aligned. Returns where it begins: size_bound bytes, then
/// scratch_bound bytes that are free again; `alignment` bytes more are needed than for these. Not inlined: the stack of
/// the build is free again.
[[gnu::noinline]] unsigned char* build_in(const Kernels& kernels, const Sets& sets, void* scratch) noexcept;

}  // namespace vesica::index
