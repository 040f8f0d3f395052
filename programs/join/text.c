// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "text.h"

#include <errno.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "work.h"

enum { piece_bytes = 1 << 22 };

struct loading {
  int file;
  struct text* text;
  int error;  // the last one, or 0
};

static void load_piece(void* context, int64_t piece) {
  struct loading* const loading = context;
  int64_t at = piece * piece_bytes;
  const int64_t end = at + piece_bytes < loading->text->size ? at + piece_bytes : loading->text->size;
  while (at < end) {
    const ssize_t count = pread(loading->file, loading->text->at + at, (size_t)(end - at), (off_t)at);
    if (count < 0 && errno == EINTR) continue;
    // A file that became shorter meanwhile is an error too.
    if (count <= 0) __atomic_store_n(&loading->error, count < 0 ? errno : EIO, __ATOMIC_RELAXED);
    if (count <= 0) return;
    at += count;
  }
}

static int load_file(int file, int64_t size, const char* path, int threads, struct text* text) {
  struct loading loading = {file, text, 0};
  text->at = malloc((size_t)size + 1);
  if (!text->at) return 0;
  text->size = size;
  text->at[size] = '\0';
  run_parts(threads, path, (size + piece_bytes - 1) / piece_bytes, load_piece, &loading);
  errno = loading.error;
  return loading.error == 0;
}

static int load_stream(FILE* file, struct text* text) {
  size_t room = 1 << 16, size = 0;
  text->at = NULL;
  for (;;) {
    char* const grown = realloc(text->at, room + 1);
    if (!grown) return 0;
    text->at = grown;
    size += fread(text->at + size, 1, room - size, file);
    if (size < room) break;
    room *= 2;
  }
  text->size = (int64_t)size;
  text->at[size] = '\0';
  return !ferror(file);
}

int load_text(FILE* file, const char* path, int threads, struct text* text) {
  struct stat status;
  const int regular = fstat(fileno(file), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0;
  // Standard input may be a file of which another program has read some.
  if (regular && file != stdin) return load_file(fileno(file), status.st_size, path, threads, text);
  return load_stream(file, text);
}
