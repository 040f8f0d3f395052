// SPDX-License-Identifier: Apache-2.0
#include "answers/table.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace answers {

std::string mode() {
  const char* text = std::getenv("VESICA_ANSWERS");
  return text != nullptr ? text : "";
}

std::string path(const std::string& file) { return std::string(VESICA_ANSWERS_FOLDER) + '/' + file; }

Table read_table(const std::string& file) {
  Table table;
  std::ifstream in(path(file));
  std::string line, name, first;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] != ' ') {
      name = line;
      continue;
    }
    std::istringstream words(line);
    words >> first >> std::hex;
    for (std::uint32_t hash = 0; words >> hash;) table[name][first].push_back(hash);
  }
  return table;
}

void write_table(const std::string& file, const Table& table) {
  if (mode() != "update") return;
  std::ofstream out(path(file));
  out << "# Hashes of answers, by function and scalar type. Written by VESICA_ANSWERS=update answers_test.\n";
  for (const auto& [name, lines] : table) {
    out << name << '\n';
    for (const auto& [first, hashes] : lines) {
      out << "  " << first;
      for (const std::uint32_t hash : hashes) {
        std::array<char, 16> text{};
        std::snprintf(text.data(), text.size(), " %08x", hash);
        out << text.data();
      }
      out << '\n';
    }
  }
}

void judge(std::uint32_t& pinned, std::uint32_t found, const std::string& of) {
  if (mode() == "update") {
    pinned = found;
  } else {
    EXPECT_EQ(pinned, found) << of;
  }
}

}  // namespace answers
