// SPDX-License-Identifier: Apache-2.0
/// The arguments of the program.
#ifndef OPTIONS_H
#define OPTIONS_H

#include "fault.h"
#include "join.h"

/// Options that may differ between the two files.
struct file_options {
  const char* path;
  const char* columns;  ///< --shape, or NULL
  const char* id;       ///< or NULL
  int32_t kind;         ///< or any_kind
  char delimiter;       ///< or 0
};

struct options {
  struct question question;
  struct file_options files[2];
  int file_count;
  const char* output;  ///< a path, or NULL
  int threads;
  int count, skip_bad, binary, no_header, quiet, help, version;
};

/// Reads the arguments. Returns 1, or 0 with the reason in `fault`.
int read_options(int count, char** arguments, struct options* options, struct fault* fault);

/// The text of --help.
extern const char usage[];

#endif
