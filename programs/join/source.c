// SPDX-License-Identifier: Apache-2.0
#include "source.h"

#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "progress.h"

const char* shown_path(const struct source* source) {
  return strcmp(source->path, "-") == 0 ? "standard input" : source->path;
}

int refuse_source(const struct source* source, const char* reason) {
  end_progress();
  fprintf(stderr, "%s: %s\n", shown_path(source), reason);
  return 0;
}

static int refuse_file(const struct source* source) {
  struct fault fault;
  fail(&fault, "cannot read: %s", strerror(errno));
  return refuse_source(source, fault.text);
}

void complain_of_shape(struct source* source, const struct fault* fault, const char* where, ...) {
  va_list arguments;
  if (source->faults++ >= most_complaints) return;
  end_progress();
  fputs(shown_path(source), stderr);
  va_start(arguments, where);
  vfprintf(stderr, where, arguments);
  va_end(arguments);
  fprintf(stderr, ": %s\n", fault->text);
}

int take_shape(struct source* source, const struct shape* shape) {
  if (shape) return add_shape(&source->shapes, shape, &source->vertices) || refuse_source(source, "out of memory");
  source->shapes.count++;
  return 1;
}

void show_reading(const struct source* source, int64_t bytes) {
  if (source->bytes > 0) show_progress(shown_path(source), (double)bytes / (double)source->bytes);
}

static int64_t length_of(FILE* file) {
  const long bytes = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : 0;
  return fseek(file, 0, SEEK_SET) == 0 && bytes > 0 ? bytes : 0;
}

// Some editors begin UTF-8 files with a byte order mark.
static void drop_byte_order_mark(struct text* text) {
  if (text->size < 3 || memcmp(text->at, "\xEF\xBB\xBF", 3) != 0) return;
  memset(text->at, ' ', 3);
}

// No line of text begins with the first mark of GeoJSON, a brace or the separator.
static int read_text(struct source* source) {
  char first;
  if (!load_text(source->file, shown_path(source), source->threads, &source->text)) return refuse_file(source);
  drop_byte_order_mark(&source->text);
  first = source->text.at[strspn(source->text.at, " \t\r\n")];
  return first == '{' || first == record_separator ? read_geojson(source) : read_table(source);
}

static int read_file(struct source* source) {
  const int first = fgetc(source->file);
  if (first == EOF && ferror(source->file)) return refuse_file(source);
  ungetc(first, source->file);
  if (first != 0x93) return read_text(source);
  return source->id_name ? refuse_source(source, "--id: arrays have none") : read_npy(source, NULL);
}

// coordinates.npy,offsets.npy
static char* find_offsets(struct source* source) {
  char* const comma = strstr(source->path, ".npy,");
  if (!comma) return NULL;
  comma[4] = '\0';
  return comma + 5;
}

int open_source(struct source* source) {
  const int standard = strcmp(source->path, "-") == 0;
  source->offsets = find_offsets(source);
  source->file = standard ? stdin : fopen(source->path, "rb");
  if (!source->file) return refuse_file(source);
  source->bytes = standard ? 0 : length_of(source->file);
  return 1;
}

int read_source(struct source* source) {
  int good = source->offsets ? read_npy(source, source->offsets) : read_file(source);
  if (good && ferror(source->file)) good = refuse_file(source);
  if (source->file != stdin) fclose(source->file);
  free_vertices(&source->vertices);
  if (!source->id_name) {
    free(source->text.at);
    source->text.at = NULL;
  }
  end_progress();
  if (source->faults > most_complaints) {
    fprintf(stderr, "%s: and %lld more like these\n", shown_path(source),
            (long long)(source->faults - most_complaints));
  }
  return good;
}
