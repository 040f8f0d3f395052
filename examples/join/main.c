// SPDX-License-Identifier: Apache-2.0
/// Writes all pairs of shapes that overlap, of two files or of one with itself. Start with operand.c and join.c: they
/// have the calls of the library. source.c reads text, well-known text, GeoJSON and arrays of numpy's.
///
/// join [OPTION...] A [B] >pairs.csv; without arguments it prints the options. A shape's number is its place among the
/// shapes of its file, from 0; a bad one keeps its number.
///
/// Exit status: 0, or 2 when a file could not be read or written or, without --skip-bad, held a bad shape.
#include <stdio.h>
#include <string.h>
#include <vesica.h>

#include "fields.h"
#include "join.h"
#include "progress.h"
#include "source.h"

static const char usage[] =
    "usage: join [OPTION...] A [B] >pairs.csv\n"
    "\n"
    "Pairs of shapes that overlap, one of each file, or two of A alone. Numbers of shapes begin with 0. A file\n"
    "is one of\n"
    "  lines of text: `rect 0 0 0.8 0.6 2 1`, `polygon 0 0 4 0 2 3` (x y of each vertex, one ring), or well-known\n"
    "    text, POINT, LINESTRING, POLYGON, MULTIPOINT, MULTILINESTRING or MULTIPOLYGON\n"
    "  GeoJSON: a collection, or geometries and features one after the other\n"
    "  an array of numpy's (.npy): numbers of shapes as fields or columns; or polygons of k vertices each, (n, k, 2)\n"
    "  vertices (n, 2) and offsets, VERTICES.npy,RINGS.npy[,POLYGONS.npy]: where rings begin among the vertices, and\n"
    "    polygons among the rings, each with its end: as GeoArrow and shapely.to_ragged_array have them\n"
    "\n"
    "  --contains   pairs of which the first contains the second\n"
    "  --inside     pairs of which the second contains the first\n"
    "  --interiors  pairs whose insides share a point: those that only touch are left out\n"
    "  --bounds     pairs whose bounding boxes meet, and a few more\n"
    "  --count      how many there are, and no pairs\n"
    "  --kind KIND  what all shapes are (point segment circle aabb rect ellipse capsule\n"
    "               round_rect polygon polyline), where lines or arrays have numbers alone\n"
    "  --skip-bad   go on without lines that hold no valid shape\n";

struct options {
  int32_t query, kind;
  int count, skip_bad, files;
  char* paths[2];
};

static int read_option(const char* text, struct options* options) {
  static const struct {
    const char* name;
    int32_t query;
  } queries[] = {{"--contains", VESICA_JOIN_CONTAINS},
                 {"--inside", VESICA_JOIN_INSIDE},
                 {"--interiors", VESICA_JOIN_INTERIORS},
                 {"--bounds", VESICA_JOIN_BOUNDS}};
  for (size_t i = 0; i < sizeof queries / sizeof *queries; i++) {
    if (strcmp(text, queries[i].name) != 0) continue;
    options->query = queries[i].query;
    return 1;
  }
  options->count |= strcmp(text, "--count") == 0;
  options->skip_bad |= strcmp(text, "--skip-bad") == 0;
  return strcmp(text, "--count") == 0 || strcmp(text, "--skip-bad") == 0;
}

static int read_arguments(int count, char** arguments, struct options* options) {
  for (int i = 1; i < count; i++) {
    if (strcmp(arguments[i], "--kind") == 0 && i + 1 < count) {
      options->kind = path_kind(arguments[++i]);
      if (options->kind < 0) options->kind = find_kind(arguments[i]);
      if (options->kind < 0) return 0;
    } else if (strncmp(arguments[i], "--", 2) == 0) {
      if (!read_option(arguments[i], options)) return 0;
    } else {
      if (options->files == 2) return 0;
      options->paths[options->files++] = arguments[i];
    }
  }
  return options->files > 0;
}

static int complain(const char* text) {
  end_progress();
  fprintf(stderr, "join: %s\n", text);
  return 2;
}

static int read_sources(const struct options* options, struct source sources[2]) {
  int64_t faults = 0;
  for (int i = 0; i < options->files; i++) {
    sources[i].path = options->paths[i];
    sources[i].name = (char)('A' + i);
    sources[i].kind = options->kind;
    if (!read_source(&sources[i])) return 0;
    faults += sources[i].faults;
  }
  if (faults == 0 || options->skip_bad) return 1;
  complain("nothing is written: --skip-bad goes on without bad shapes");
  return 0;
}

static void summarise(const struct join* join, double reading, double building) {
  const int64_t shapes = join->a->items + (join->a == join->b ? 0 : join->b->items);
  end_progress();
  fprintf(stderr, "join: %lld shapes", (long long)join->a->items);
  if (join->a != join->b) fprintf(stderr, " and %lld", (long long)join->b->items);
  fprintf(stderr, ", %lld pairs; read in %.3f s, indexed in %.3f s, joined in %.3f s", (long long)join->pairs, reading,
          building, join->seconds);
  if (shapes > 0) fprintf(stderr, ": %.0f ns a shape", 1e9 * (building + join->seconds) / (double)shapes);
  fputs("\n", stderr);
}

static int join_sources(const struct options* options, const struct source sources[2], double reading) {
  struct operand operands[2] = {{.items = 0}, {.items = 0}};
  struct join join = {&operands[0], &operands[options->files - 1], options->query, stdout, 0, 0, 0};
  const double begin = seconds();
  double building;
  int good = 1;
  for (int i = 0; good && i < options->files; i++) good = build_operand(&sources[i].shapes, &operands[i]);
  building = seconds() - begin;
  if (options->count) join.out = NULL;
  if (good && join.out) fputs("a_from_0,b_from_0\n", stdout);
  good = good && run_join(&join);
  if (good && options->count) printf("%lld\n", (long long)join.pairs);
  for (int i = 0; i < options->files; i++) free_operand(&operands[i]);
  if (fflush(stdout) != 0 || ferror(stdout)) return complain("cannot write the pairs");
  if (join.error != 0) return complain(vesica_strerror(join.error));
  if (!good) return complain("out of memory, or more than 2147483647 shapes");
  summarise(&join, reading, building);
  return 0;
}

int main(int count, char** arguments) {
  static struct source sources[2];
  struct options options = {.query = VESICA_JOIN_OVERLAP, .kind = any_kind};
  const double begin = seconds();
  int status = 2;
  if (count == 2 && strcmp(arguments[1], "--help") == 0) return fputs(usage, stdout) < 0 ? 2 : 0;
  if (!read_arguments(count, arguments, &options)) {
    fputs(usage, stderr);
    return 2;
  }
  if (read_sources(&options, sources)) status = join_sources(&options, sources, seconds() - begin);
  for (int i = 0; i < 2; i++) free_shapes(&sources[i].shapes);
  return status;
}
