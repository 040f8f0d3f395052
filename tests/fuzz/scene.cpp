// SPDX-License-Identifier: Apache-2.0
// Any file to the demo's readers of scenes and of the corpus's table: line by line, each line to a pair, and the pair
// to its query. The lines are read into room of a fixed size, and once more into room that grows.
#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" {
#include "line.h"
#include "query.h"
#include "scene.h"
}

namespace scene_fuzzer {

inline void read_lines(FILE* file, line& current) {
  std::rewind(file);
  while (read_line(file, &current)) {
    pair read{};
    fault why{};
    if (current.fault == nullptr && parse_line(current.text, current.number, &read, &why) == line_pair) {
      double answer = 0;
      if (read.query->answer != nullptr) read.query->answer(&read, &answer);
    }
  }
}

}  // namespace scene_fuzzer

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  FILE* file = fmemopen(const_cast<std::uint8_t*>(data), size, "r");
  if (file == nullptr) return 0;
  char text[line_limit + 2];
  line fixed{};
  fixed.text = text;
  scene_fuzzer::read_lines(file, fixed);
  line grows{};
  grows.grows = 1;
  scene_fuzzer::read_lines(file, grows);
  std::free(grows.text);
  std::fclose(file);
  return 0;
}
