// SPDX-License-Identifier: Apache-2.0
/// Pinned hashes, and what to do with them: VESICA_ANSWERS is not set, "update" or "list".
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace answers {

/// FNV-1a of 64 bits; a table holds 32 of them.
class Hash {
 public:
  void add(const std::vector<unsigned char>& bytes) { add_values(bytes.data(), bytes.size()); }
  template <class T>
  void add_values(const T* values, std::size_t count) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values);
    for (std::size_t i = 0; i < count * sizeof(T); ++i) state_ = (state_ ^ bytes[i]) * 0x100000001b3u;
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(state_ ^ (state_ >> 32)); }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325u;
};

/// By function and scalar type, as "nearest f64": lines, such as a hash for each second kind by the first kind.
using Table = std::map<std::string, std::map<std::string, std::vector<std::uint32_t>>>;

std::string mode();

/// The table of a file of tests/answers; empty where it is not there.
Table read_table(const std::string& file);
/// Only in mode "update".
void write_table(const std::string& file, const Table& table);

/// Expects the pinned hash, or puts the found one in its place in mode "update".
void judge(std::uint32_t& pinned, std::uint32_t found, const std::string& of);

/// The path of a file of tests/answers.
std::string path(const std::string& file);

}  // namespace answers
