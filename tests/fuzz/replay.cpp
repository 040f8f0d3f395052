// SPDX-License-Identifier: Apache-2.0
// The calls of the fuzzer without libFuzzer, by any compiler: the files of a corpus, then 200,000 times random bytes.
//   fuzz_replay FILE...
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "properties/random.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  std::vector<std::uint8_t> bytes;
  for (int i = 1; i < argc; ++i) {
    std::ifstream in(argv[i], std::ios::binary);
    if (!in) return std::fprintf(stderr, "fuzz_replay: cannot read %s\n", argv[i]), 2;
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  std::printf("VESICA_SEED=%llu\n", static_cast<unsigned long long>(properties::seed()));
  std::fflush(stdout);
  properties::Random random(properties::seed());
  for (long calls = 200000L * properties::repeat(); calls > 0; --calls) {
    bytes.resize(static_cast<std::size_t>(random.integer(1, 1024)));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  return 0;
}
