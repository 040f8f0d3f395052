// SPDX-License-Identifier: Apache-2.0
#include "source.h"

#include <errno.h>
#include <string.h>

#include "fields.h"
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

int is_valid(const struct source* source, const struct shape* shape, struct fault* fault) {
  if (!has_vertices(shape->kind)) return check_shape(shape, source->name, fault);
  const vesica_polygon_f64 polygon = view_vertices(&source->vertices);
  const int32_t error = vesica_check_f64(shape->kind, &polygon);
  return error == 0 || fail(fault, "shape %c (%s) is invalid: %s", source->name, vesica_kind_name(shape->kind),
                            vesica_strerror(error));
}

void show_reading(const struct source* source) {
  if (source->bytes > 0) show_progress(source->path, (double)ftell(source->file) / (double)source->bytes);
}

static int64_t length_of(FILE* file) {
  const long bytes = fseek(file, 0, SEEK_END) == 0 ? ftell(file) : 0;
  return fseek(file, 0, SEEK_SET) == 0 && bytes > 0 ? bytes : 0;
}

// The first byte tells: that of numpy's files, and a brace or the separator of GeoJSON, begin no line of text.
static int read_file(struct source* source) {
  const int first = fgetc(source->file);
  ungetc(first, source->file);
  if (first == 0x93) return read_npy(source, NULL);
  return first == '{' || first == record_separator ? read_geojson(source) : read_text(source);
}

// coordinates.npy,offsets.npy
static char* find_offsets(struct source* source) {
  char* const comma = strstr(source->path, ".npy,");
  if (!comma) return NULL;
  comma[4] = '\0';
  return comma + 5;
}

int read_source(struct source* source) {
  char* const offsets = find_offsets(source);
  int good;
  source->file = fopen(source->path, "rb");
  if (!source->file) return refuse_file(source);
  source->bytes = length_of(source->file);
  good = offsets ? read_npy(source, offsets) : read_file(source);
  if (good && ferror(source->file)) good = refuse_file(source);
  fclose(source->file);
  free_vertices(&source->vertices);
  end_progress();
  if (source->faults > most_complaints) {
    fprintf(stderr, "%s: and %lld more like these\n", source->path, (long long)(source->faults - most_complaints));
  }
  return good;
}
