// SPDX-License-Identifier: Apache-2.0
/// Reasons why input cannot be used.
#ifndef FAULT_H
#define FAULT_H

struct fault {
  char text[224];
};

/// Writes a reason in the manner of printf and returns 0. Whatever is not printable becomes '?'.
__attribute__((format(printf, 2, 3))) int fail(struct fault* fault, const char* format, ...);

#endif
