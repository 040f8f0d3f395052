// SPDX-License-Identifier: Apache-2.0
#include "answers/table.hpp"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace answers {

Table read_table(const std::string& path) {
  Table table;
  std::ifstream in(path);
  std::string line, name, kind;
  std::size_t a = 0;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    if (line[0] != ' ') {
      name = line;
      a = 0;
      continue;
    }
    std::istringstream words(line);
    words >> kind >> std::hex;
    for (std::uint32_t& hash : table[name].at(a)) words >> hash;
    ++a;
  }
  return table;
}

void write_table(const std::string& path, const Table& table) {
  std::ofstream out(path);
  out << "# Hashes of answers, by function and scalar type: a line for each first kind, a column for each second.\n"
         "# VESICA_ANSWERS=update answers_test writes this file.\n";
  for (const auto& [name, squares] : table) {
    out << name << '\n';
    for (std::size_t a = 0; a < squares.size(); ++a) {
      char text[24];
      std::snprintf(text, sizeof text, "  %-7s", properties::kind_name(static_cast<int>(a)));
      out << text;
      for (const std::uint32_t hash : squares[a]) {
        std::snprintf(text, sizeof text, " %08x", hash);
        out << text;
      }
      out << '\n';
    }
  }
}

}  // namespace answers
