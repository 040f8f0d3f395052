// SPDX-License-Identifier: Apache-2.0
/// The pinned hashes of tests/answers/hashes.txt.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "properties/pair.hpp"

namespace answers {

/// FNV-1a of 64 bits, of which the table holds 32.
class Hash {
 public:
  void add(const std::vector<unsigned char>& bytes) {
    for (const unsigned char byte : bytes) state_ = (state_ ^ byte) * 0x100000001b3u;
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(state_ ^ (state_ >> 32)); }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// A hash for each ordered pair of kinds, by function and scalar type, as "nearest f64".
using Squares = std::array<std::array<std::uint32_t, properties::kinds>, properties::kinds>;
using Table = std::map<std::string, Squares>;

/// Empty where the file is not there.
Table read_table(const std::string& path);
void write_table(const std::string& path, const Table& table);

}  // namespace answers
