// SPDX-License-Identifier: Apache-2.0
// Run-time switched mutants: every mutated file of the copied tree begins by including this one. The environment says
// which mutant is in force: VESICA_MUTANT=7, the seventh; -1, none, and each that is asked for is marked in the file
// VESICA_MUTANT_REACHED, a byte a mutant.
#pragma once

#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include <type_traits>

namespace vesica_mutant {

inline int from_environment() noexcept {
  const char* text = getenv("VESICA_MUTANT");
  return text ? atoi(text) : 0;
}

/// None if no file is given.
inline unsigned char* map_reached() noexcept {
  const char* path = getenv("VESICA_MUTANT_REACHED");
  const int file = path ? open(path, O_RDWR) : -1;
  struct stat facts;
  if (file < 0 || fstat(file, &facts) != 0) return nullptr;
  void* bytes = mmap(nullptr, static_cast<size_t>(facts.st_size), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  return bytes == MAP_FAILED ? nullptr : static_cast<unsigned char*>(bytes);
}

/// 0 is no mutant, which is also what code reads that runs before its library's variables are initialised. The library
/// and the program that uses it may each have a copy.
inline unsigned char* reached = map_reached();
inline int active = from_environment();

[[gnu::cold, gnu::noinline]] inline void mark(int mutant) noexcept {
  if (reached) reached[mutant] = 1;
}

[[gnu::always_inline]] inline constexpr bool is(int mutant) noexcept {
  if (std::is_constant_evaluated()) return false;
  if (active == mutant) return true;
  if (active < 0) mark(mutant);
  return false;
}

/// True if a change gives another value than the original. Zeros may differ by their sign, and of classes nothing is
/// known.
template <class A, class B>
constexpr bool differ(const A& a, const B& b) noexcept {
  if constexpr (std::is_same_v<A, bool> && std::is_same_v<B, bool>) {
    return a != b;
  } else if constexpr (std::is_arithmetic_v<A> && std::is_arithmetic_v<B>) {
    return !(a == b) || (std::is_floating_point_v<A> && a == 0);
  } else {
    return true;
  }
}

/// The same, but a mutant is marked only where it makes a difference to the value at its place: no test can find it
/// before.
template <class Differs>
[[gnu::always_inline]] inline constexpr bool is(int mutant, const Differs& differs) noexcept {
  if (std::is_constant_evaluated()) return false;
  if (active == mutant) return true;
  if (active < 0 && differs()) mark(mutant);
  return false;
}

}  // namespace vesica_mutant
