// SPDX-License-Identifier: Apache-2.0
// Any file to the demo's readers of scenes and of the corpus's table: line by line, each line to a pair, and the pair
// to its query.
#include <cstdint>
#include <cstdio>

extern "C" {
#include "line.h"
#include "query.h"
#include "scene.h"
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  FILE* file = fmemopen(const_cast<std::uint8_t*>(data), size, "r");
  if (file == nullptr) return 0;
  line current{};
  while (read_line(file, &current)) {
    pair read{};
    fault why{};
    if (current.fault == nullptr && parse_line(current.text, current.number, &read, &why) == line_pair) {
      double answer = 0;
      if (read.query->answer != nullptr) read.query->answer(&read, &answer);
    }
  }
  std::fclose(file);
  return 0;
}
