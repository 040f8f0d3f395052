// SPDX-License-Identifier: Apache-2.0
#include "source.h"

#include <errno.h>
#include <string.h>

#include "progress.h"

int refuse_source(const struct source* source, const char* reason) {
  end_progress();
  fprintf(stderr, "%s: %s\n", source->path, reason);
  return 0;
}

static int refuse_file(const struct source* source) {
  char reason[160];
  snprintf(reason, sizeof reason, "cannot read: %s", strerror(errno));
  return refuse_source(source, reason);
}

int take_shape(struct source* source, const char* where, const struct shape* shape, const struct fault* fault) {
  if (shape) return add_shape(&source->shapes, shape, &source->vertices) || refuse_source(source, "out of memory");
  source->shapes.count++;
  if (source->faults++ < most_complaints) {
    end_progress();
    fprintf(stderr, "%s: %s\n", where, fault->text);
  }
  return 1;
}

void show_reading(const struct source* source) {
  if (source->bytes > 0) show_progress(source->path, (double)ftell(source->file) / (double)source->bytes);
}

static int64_t length_of(FILE* file) {
  const long bytes = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : 0;
  return fseek(file, 0, SEEK_SET) == 0 && bytes > 0 ? bytes : 0;
}

// The first byte of numpy's files begins no line of text.
static int is_npy(FILE* file) {
  const int first = fgetc(file);
  ungetc(first, file);
  return first == 0x93;
}

int read_source(struct source* source) {
  int good;
  source->file = fopen(source->path, "rb");
  if (!source->file) return refuse_file(source);
  source->bytes = length_of(source->file);
  good = is_npy(source->file) ? read_npy(source) : read_text(source);
  if (good && ferror(source->file)) good = refuse_file(source);
  fclose(source->file);
  free_vertices(&source->vertices);
  end_progress();
  if (source->faults > most_complaints) {
    fprintf(stderr, "%s: and %lld more like these\n", source->path, (long long)(source->faults - most_complaints));
  }
  return good;
}
