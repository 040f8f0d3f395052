// SPDX-License-Identifier: Apache-2.0
// The library's only variable, the choice of kernels, however early the first call comes and from how many threads.
#include <dlfcn.h>
#include <gtest/gtest.h>
#include <vesica.h>

#include <barrier>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

extern "C" {
extern std::int64_t early_hits;
extern const char* early_isa;
}

namespace {

constexpr int threads = 4, rounds = 50;

TEST(Load, AnswersBeforeItsConstructorsHaveRun) {
  EXPECT_EQ(early_hits, 2);
  EXPECT_STREQ(early_isa, vesica_isa_name());
}

/// Loads the library, asks for the set it chose, and closes it again.
std::string load_and_ask(std::barrier<>& together) {
  together.arrive_and_wait();
  void* const library = dlopen(VESICA_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return dlerror();
  const auto isa_name = reinterpret_cast<decltype(&vesica_isa_name)>(dlsym(library, "vesica_isa_name"));
  const std::string chosen = isa_name();
  together.arrive_and_wait();  // nobody closes it before all have asked
  dlclose(library);
  return chosen;
}

TEST(Load, FromSeveralThreadsIsAsFromOne) {
  for (int round = 0; round < rounds; ++round) {
    ASSERT_EQ(dlopen(VESICA_LIBRARY, RTLD_NOW | RTLD_NOLOAD), nullptr) << "each round loads it anew";
    std::barrier together(threads);
    std::vector<std::string> chosen(threads);
    std::vector<std::thread> loading;
    for (std::string& own : chosen) loading.emplace_back([&] { own = load_and_ask(together); });
    for (std::thread& thread : loading) thread.join();
    for (const std::string& own : chosen) ASSERT_EQ(own, vesica_isa_name());
  }
}

}  // namespace
