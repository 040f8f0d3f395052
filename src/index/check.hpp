// SPDX-License-Identifier: Apache-2.0
// Validation of bytes that should be an index.
#pragma once

#include <cstdint>

#include "index/layout.hpp"

namespace vesica::index {

/// True if a header's fields are consistent: magic, byte order, version, and parts that lie within `size` bytes.
bool header_is_sound(const void* index, std::int64_t size) noexcept;

/// The same for all of it: every query stays within these bytes, and the checksum is right.
bool is_sound(const void* index, std::int64_t size) noexcept;

}  // namespace vesica::index
