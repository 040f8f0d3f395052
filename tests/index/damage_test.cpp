// SPDX-License-Identifier: Apache-2.0
/// Bytes that are no index: said so by vesica_index_check, or read without a step outside (the sanitizer sees it).
#include <gtest/gtest.h>

#include "index/face.hpp"

namespace index_tests {
namespace {

/// A copy that is as long as it says.
Memory copy_of(const Indexed<double>& indexed, std::int64_t bytes) {
  Memory copy(bytes);
  std::memcpy(copy.get(), indexed.index.get(), static_cast<std::size_t>(bytes));
  return copy;
}

/// Runs every query over an index that passed its check.
void query(const void* index, const Indexed<double>& whole) {
  const Memory scratch(vesica_join_scratch());
  std::int64_t out_a[64], out_b[64], state[4] = {0, 0, 0, 0};
  for (int calls = 0; calls < 3 && state[0] != -1; ++calls) {
    const std::int64_t n = vesica_join_f64(VESICA_JOIN_OVERLAP, index, whole.sets.data(), whole.sets.count(),
                                           whole.index.get(), whole.sets.data(), whole.sets.count(), 0, 1,
                                           scratch.get(), scratch.size, out_a, out_b, 64, state);
    if (n < 0) break;
    for (std::int64_t i = 0; i < n; ++i) {
      ASSERT_LT(out_a[i], whole.sets.items);
      ASSERT_LT(out_b[i], whole.sets.items);
    }
  }
  vesica_join_f64(VESICA_JOIN_BOUNDS, whole.index.get(), nullptr, 0, index, nullptr, 0, 1, 3, scratch.get(),
                  scratch.size, nullptr, nullptr, 0, nullptr);
  vesica_index_order(index, out_a, 64);
}

TEST(Damage, EveryByteOfAnIndex) {
  const Indexed<double> whole(rects<double>("two_scales", 120, 1));
  const Memory copy = copy_of(whole, whole.result);
  auto* bytes = static_cast<unsigned char*>(copy.get());
  std::int64_t refused = 0;
  for (std::int64_t i = 0; i < whole.result; ++i) {
    for (const int flip : {0x01, 0x80}) {
      const unsigned char was = bytes[i];
      bytes[i] = static_cast<unsigned char>(was ^ flip);
      if (vesica_index_check(copy.get(), copy.size) == 0) {
        // Only sides and numbers of items are outside the checksum.
        query(copy.get(), whole);
      } else {
        ++refused;
        ASSERT_EQ(vesica_index_check(copy.get(), copy.size), VESICA_E_INDEX);
      }
      bytes[i] = was;
    }
    if (i < 256) {
      ASSERT_EQ(refused, 2 * (i + 1)) << "a byte of the header";
    }
  }
  ASSERT_EQ(vesica_index_check(copy.get(), copy.size), 0);
}

/// Numbers of the header and of a block that are each possible, but not together.
TEST(Damage, NumbersThatDisagree) {
  enum Field { size = 2, blocks = 5, places = 6 };  // of the header's numbers of 8 bytes
  const Indexed<double> whole(rects<double>("two_scales", 5000, 1));
  const auto refuses = [&](auto change) {
    const Memory copy(whole.result + 64);
    std::memcpy(copy.get(), whole.index.get(), static_cast<std::size_t>(whole.result));
    change(static_cast<std::int64_t*>(copy.get()), static_cast<unsigned char*>(copy.get()));
    return vesica_index_check(copy.get(), copy.size) == VESICA_E_INDEX;
  };
  ASSERT_FALSE(refuses([](std::int64_t*, unsigned char*) {}));
  EXPECT_TRUE(refuses([](std::int64_t* header, unsigned char*) { ++header[size]; }));
  EXPECT_TRUE(refuses([](std::int64_t* header, unsigned char*) { header[size] += 64; }));
  EXPECT_TRUE(refuses([](std::int64_t* header, unsigned char*) {  // the directory alone
    header[size] -= header[places];
    header[places] = 0;
  }));
  EXPECT_TRUE(refuses([](std::int64_t* header, unsigned char* bytes) {  // the last block as long as any
    std::uint32_t place;
    std::memcpy(&place, bytes + header[places] + 4 * (header[blocks] - 1), 4);
    const std::int32_t count_and_leaves[] = {1024, 32};
    std::memcpy(bytes + 64 * std::int64_t{place} + 24, count_and_leaves, 8);
  }));
  EXPECT_TRUE(refuses([](std::int64_t* header, unsigned char* bytes) {  // one block more, of which there is nothing
    ASSERT_NE(header[blocks] % 8, 0) << "the directory would be longer";
    const auto place = static_cast<std::uint32_t>(header[places] / 64);
    std::memcpy(bytes + header[places] + 4 * header[blocks], &place, 4);
    ++header[blocks];
  }));
}

/// Every function looks at the header, those too that trust the rest.
TEST(Damage, HeadersThatDisagree) {
  enum Field { size = 2, items = 3, placed = 4, blocks = 5, places = 6, tree = 7 };
  const Indexed<double> whole(rects<double>("two_scales", 5000, 1));
  const auto bytes_after = [&](auto change) {
    const Memory copy(whole.result + 64);
    std::memcpy(copy.get(), whole.index.get(), static_cast<std::size_t>(whole.result));
    change(static_cast<std::int64_t*>(copy.get()));
    const std::int64_t bytes = vesica_index_bytes(copy.get());
    EXPECT_EQ(vesica_index_count(copy.get()) < 0, bytes < 0);
    return bytes;
  };
  EXPECT_EQ(bytes_after([](std::int64_t*) {}), whole.result);
  for (const std::int64_t by : {8, 64, -8, -64}) {
    EXPECT_EQ(bytes_after([by](std::int64_t* header) { header[size] += by; }), VESICA_E_INDEX) << by;
    EXPECT_EQ(bytes_after([by](std::int64_t* header) { header[places] += by; }), VESICA_E_INDEX) << by;
    EXPECT_EQ(bytes_after([by](std::int64_t* header) { header[tree] += by; }), VESICA_E_INDEX) << by;
    EXPECT_EQ(bytes_after([by](std::int64_t* header) {
                header[places] += by;
                header[tree] += by;
              }),
              VESICA_E_INDEX)
        << by;
  }
  EXPECT_EQ(bytes_after([](std::int64_t* header) {  // all alike, but not in whole lines
              header[size] += 8;
              header[places] += 8;
              header[tree] += 8;
            }),
            VESICA_E_INDEX);
  EXPECT_EQ(bytes_after([](std::int64_t* header) { header[blocks] += 64; }), VESICA_E_INDEX);
  EXPECT_EQ(bytes_after([](std::int64_t* header) { header[placed] = header[items] + 1; }), VESICA_E_INDEX);
  for (const Field field : {size, items, placed, blocks, places, tree}) {
    EXPECT_EQ(bytes_after([field](std::int64_t* header) { header[field] = -64; }), VESICA_E_INDEX) << field;
  }
}

/// Adds a word to a checksum as the index does.
std::uint64_t checksum_with(std::uint64_t sum, std::uint64_t word) {
  sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
  return sum ^ sum >> 29;
}
/// The sum of a header's words but the last.
std::uint64_t sum_of_header(const std::int64_t* header) {
  std::uint64_t sum = 0x243f6a8885a308d3u;
  for (int i = 0; i < 31; ++i) sum = checksum_with(sum, i == 12 ? 0 : static_cast<std::uint64_t>(header[i]));
  return sum;
}

/// More shapes in blocks than there are, one of them twice, with the checksum mended by a word that nobody reads.
TEST(Damage, AForgedNumberOfShapes) {
  enum Field { items = 3, placed = 4, reserved = 31 };
  const Indexed<double> whole(rects<double>("two_scales", 120, 1));
  const Memory copy = copy_of(whole, whole.result);
  auto* header = static_cast<std::int64_t*>(copy.get());
  auto* numbers = static_cast<std::uint32_t*>(copy.get());
  ASSERT_EQ(header[placed], header[items]);
  const std::uint64_t sum = sum_of_header(header);
  header[reserved] = 1;
  ASSERT_EQ(vesica_index_check(copy.get(), copy.size), VESICA_E_INDEX) << "the checksum is of this word too";
  header[11] ^= 1;  // a bound's last digit
  header[reserved] = static_cast<std::int64_t>(sum_of_header(header) ^ sum);
  ASSERT_EQ(vesica_index_check(copy.get(), copy.size), 0) << "mended";
  --header[items];
  header[reserved] = static_cast<std::int64_t>(sum_of_header(header) ^ sum);
  const auto last = static_cast<std::uint32_t>(header[items]);
  for (std::int64_t i = 64; i < copy.size / 4; ++i) {
    if (numbers[i] != last) continue;
    numbers[i] = 0;
    EXPECT_EQ(vesica_index_check(copy.get(), copy.size), VESICA_E_INDEX);
    numbers[i] = last;
  }
}

TEST(Damage, EveryLength) {
  const Indexed<double> whole(rects<double>("two_scales", 200, 1));
  for (std::int64_t size = 0; size < whole.result; ++size) {
    const Memory copy = copy_of(whole, size);
    ASSERT_EQ(vesica_index_check(copy.get(), size), VESICA_E_INDEX) << size;
  }
  EXPECT_EQ(vesica_index_check(whole.index.get(), whole.result), 0);
  EXPECT_EQ(vesica_index_check(whole.index.get(), INT64_MAX), 0);
  EXPECT_EQ(vesica_index_check(whole.index.get(), -1), VESICA_E_INDEX);
}

}  // namespace
}  // namespace index_tests
