// SPDX-License-Identifier: Apache-2.0
#include "batch/guard_pages.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <stdexcept>

namespace batch_tests {

GuardedMemory::GuardedMemory(std::size_t capacity)
    : capacity_(capacity), page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
  void* all = mmap(nullptr, capacity + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (all == MAP_FAILED) throw std::runtime_error("mmap failed");
  mapping_ = static_cast<std::byte*>(all);
  if (mprotect(mapping_ + page_, capacity, PROT_READ | PROT_WRITE) != 0) throw std::runtime_error("mprotect failed");
}

GuardedMemory::~GuardedMemory() { munmap(mapping_, capacity_ + 2 * page_); }

std::byte* GuardedMemory::place(std::size_t size, Edge edge) {
  if (size > capacity_) throw std::length_error("more than a GuardedMemory holds");
  return mapping_ + page_ + (edge == Edge::before ? 0 : capacity_ - size);
}

}  // namespace batch_tests
