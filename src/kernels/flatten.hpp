// SPDX-License-Identifier: Apache-2.0
// How kernels are inlined. Included first by the sources of src/isa, so that the core's functions are declared like
// this.
//
// A kernel (VESICA_KERNEL) inlines all that it calls, at once. Were each of its functions forced into its caller, as
// elsewhere (VESICA_INLINE), g++ 12 would compile all the bodies in between, each as long as those that it holds: the
// queries of AVX-512 would take 18 s instead of 5 s.
//
// Clang's attribute reaches direct calls alone. Without optimisation g++ ignores it, and linkers could share the
// functions that are left with other instruction sets.
#pragma once

#if defined(VESICA_INLINE)
#error "flatten.hpp comes before all other headers of the library"
#endif
#if defined(__GNUC__) && !defined(__clang__) && defined(__OPTIMIZE__)
#define VESICA_INLINE inline
#define VESICA_KERNEL [[gnu::flatten]]
#else
#define VESICA_KERNEL
#endif
