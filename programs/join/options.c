// SPDX-License-Identifier: Apache-2.0
#include "options.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "source.h"
#include "work.h"

const char usage[] =
    "usage: vesica-join [OPTION...] A [B] >pairs.csv\n"
    "\n"
    "Writes all pairs of shapes that overlap, one of each file, or two of A alone. Touching is overlap. Every answer\n"
    "is exact for the numbers as they are read. `-` is standard input. A file is one of\n"
    "  a table with names in its first line, between commas, semicolons or tabs: numbers by the names below, or\n"
    "    well-known text in a column named wkt or geometry, or what --shape says\n"
    "  lines of shapes: `rect 0 0 0.8 0.6 2 1`, `polygon 0 0 4 0 2 3` (x y of each vertex, one ring), or well-known\n"
    "    text, POINT, LINESTRING, POLYGON and these with MULTI\n"
    "  GeoJSON: a collection, or geometries and features one after the other\n"
    "  an array of numpy's (.npy): numbers of shapes as fields or columns; or polygons of k vertices each, (n, k, 2)\n"
    "  vertices (n, 2) and offsets, VERTICES.npy,RINGS.npy[,POLYGONS.npy]: where rings begin among the vertices, and\n"
    "    polygons among the rings, each with its end: as GeoArrow and shapely.to_ragged_array have them\n"
    "\n"
    "Names: x,y  x0,y0,x1,y1  cx,cy,r  min_x,min_y,max_x,max_y  cx,cy,ux,uy,hx,hy  cx,cy,ux,uy,a,b  x0,y0,x1,y1,r\n"
    "cx,cy,ux,uy,hx,hy,r (point segment circle aabb rect ellipse capsule round_rect); a rectangle by full sizes is\n"
    "cx,cy,w,h[,angle or angle_deg], an ellipse by half axes cx,cy,a,b,angle or angle_deg.\n"
    "\n"
    "Files. Given twice, the first is for A and the second for B, and `--shape=` is none:\n"
    "  --shape NAMES     columns of the shape: one of well-known text, or numbers; NAME=COLUMN for a column's own "
    "name\n"
    "  --id NAME         write this column instead of numbers; in GeoJSON a member of the feature or its properties\n"
    "  --kind KIND       what all shapes are, where lines, columns or arrays have numbers alone\n"
    "  --delimiter C     between the fields of a table; `tab` is one\n"
    "  --skip-bad        go on without lines that hold no valid shape; others keep their numbers\n"
    "\n"
    "Question, instead of overlap:\n"
    "  --contains        the first contains the second\n"
    "  --inside          the second contains the first\n"
    "  --interiors       their insides share a point: those that only touch are left out\n"
    "  --bounds          their bounding boxes meet, and a few more\n"
    "  --within D        they are at most D apart\n"
    "  --nearest K       the K nearest shapes of B for each of A, with their distance; --within D is then the largest\n"
    "\n"
    "Output: a line a pair, `a_from_0,b_from_0` (places in the files, from 0) or ids:\n"
    "  --count           how many there are, and no pairs\n"
    "  --no-header       without the first line\n"
    "  --binary          two int64 a pair, and a float64 after --nearest, without a header\n"
    "  --output FILE     into a file\n"
    "\n"
    "  --threads N       how many to use (all processors); the output is the same with any number\n"
    "  --quiet           neither progress nor the summary\n"
    "  --help, --version\n"
    "\n"
    "Exit status: 0; 2 for wrong arguments, a file that cannot be read or written, or, without --skip-bad, a bad "
    "shape.\n";

enum name {
  opt_binary,
  opt_bounds,
  opt_contains,
  opt_count,
  opt_delimiter,
  opt_help,
  opt_id,
  opt_inside,
  opt_interiors,
  opt_kind,
  opt_nearest,
  opt_no_header,
  opt_output,
  opt_quiet,
  opt_shape,
  opt_skip_bad,
  opt_threads,
  opt_version,
  opt_within,
  name_count
};

static const struct {
  const char* name;
  int has_value;
} names[name_count] = {{"binary", 0},   {"bounds", 0},    {"contains", 0}, {"count", 0},     {"delimiter", 1},
                       {"help", 0},     {"id", 1},        {"inside", 0},   {"interiors", 0}, {"kind", 1},
                       {"nearest", 1},  {"no-header", 0}, {"output", 1},   {"quiet", 0},     {"shape", 1},
                       {"skip-bad", 0}, {"threads", 1},   {"version", 0},  {"within", 1}};

struct parsing {
  struct options* options;
  int given[name_count];
  struct fault* fault;
};

// How many letters are to be changed, put in or taken out, up to the length of the table's names.
static size_t edits(const char* given, size_t length, const char* name) {
  enum { room = 24 };
  size_t row[room];
  const size_t columns = strlen(name);
  for (size_t j = 0; j <= columns; j++) row[j] = j;
  for (size_t i = 0; i < length; i++) {
    size_t corner = row[0];
    row[0] = i + 1;
    for (size_t j = 0; j < columns; j++) {
      const size_t above = row[j + 1];
      size_t least = corner + (given[i] != name[j]);
      if (above + 1 < least) least = above + 1;
      if (row[j] + 1 < least) least = row[j] + 1;
      row[j + 1] = least;
      corner = above;
    }
  }
  return row[columns];
}

static int refuse_name(const struct parsing* p, const char* given, size_t length) {
  size_t best = 3;  // more edits are another word
  const char* found = NULL;
  for (int i = 0; i < name_count; i++) {
    const size_t distance =
        length > 2 && strncmp(given, names[i].name, length) == 0 ? 1 : edits(given, length, names[i].name);
    if (distance >= best || distance >= length) continue;
    best = distance;
    found = names[i].name;
  }
  if (found) return fail(p->fault, "unknown option '--%.*s': --%s?", (int)(length < 40 ? length : 40), given, found);
  return fail(p->fault, "unknown option '--%.*s' (--help)", (int)(length < 40 ? length : 40), given);
}

// ---- Values ----

static int take_number(const struct parsing* p, enum name name, const char* text, double* out) {
  const char* const end = parse_decimal(text, out);
  if (end > text && !*end && !isnan(*out)) return 1;
  return fail(p->fault, "--%s: '%.40s' is not a number", names[name].name, text);
}

static int take_whole(const struct parsing* p, enum name name, const char* text, int64_t most, int64_t* out) {
  char* end;
  const long long value = strtoll(text, &end, 10);
  *out = value;
  if (end > text && !*end && value >= 1 && value <= most) return 1;
  return fail(p->fault, "--%s: '%.40s' is not a whole number from 1 to %lld", names[name].name, text, (long long)most);
}

static int take_kind(const struct parsing* p, const char* text, int32_t* out) {
  *out = find_kind(text);
  return *out >= 0 || fail(p->fault, "--kind: unknown kind '%.40s'", text);
}

static int take_delimiter(const struct parsing* p, const char* text, char* out) {
  *out = strcmp(text, "tab") == 0 ? '\t' : text[0];
  if (*out == '\t' || (text[0] && !text[1] && text[0] != '"' && text[0] != '\n')) return 1;
  return fail(p->fault, "--delimiter: '%.40s' is not a character, or `tab`", text);
}

// An option of a file: given once it is for both.
static int take_file_option(const struct parsing* p, enum name name, const char* text) {
  if (p->given[name] > 2) return fail(p->fault, "--%s: more than two", names[name].name);
  for (int i = p->given[name] - 1; i < 2; i++) {
    struct file_options* const file = &p->options->files[i];
    if (name == opt_shape) file->columns = *text ? text : NULL;
    if (name == opt_id) file->id = *text ? text : NULL;
    if (name == opt_kind && !take_kind(p, text, &file->kind)) return 0;
    if (name == opt_delimiter && !take_delimiter(p, text, &file->delimiter)) return 0;
  }
  return 1;
}

static int take_value(const struct parsing* p, enum name name, const char* text) {
  struct options* const options = p->options;
  int64_t whole;
  switch (name) {
    case opt_within:
      options->question.has_distance = 1;
      return take_number(p, name, text, &options->question.distance);
    case opt_nearest:
      return take_whole(p, name, text, INT32_MAX - 1, &options->question.neighbours);
    case opt_threads:
      if (!take_whole(p, name, text, 256, &whole)) return 0;
      options->threads = (int)whole;
      return 1;
    case opt_output:
      options->output = text;
      return 1;
    default:
      return take_file_option(p, name, text);
  }
}

static void set_flag(struct options* options, enum name name) {
  switch (name) {
    case opt_contains:
      options->question.query = VESICA_JOIN_CONTAINS;
      break;
    case opt_inside:
      options->question.query = VESICA_JOIN_INSIDE;
      break;
    case opt_interiors:
      options->question.query = VESICA_JOIN_INTERIORS;
      break;
    case opt_bounds:
      options->question.query = VESICA_JOIN_BOUNDS;
      break;
    default:
      options->binary |= name == opt_binary;
      options->count |= name == opt_count;
      options->help |= name == opt_help;
      options->no_header |= name == opt_no_header;
      options->quiet |= name == opt_quiet;
      options->skip_bad |= name == opt_skip_bad;
      options->version |= name == opt_version;
  }
}

// Returns how many arguments it took, or 0.
static int take_option(struct parsing* p, const char* text, const char* next) {
  const size_t length = strcspn(text, "=");
  for (int i = 0; i < name_count; i++) {
    const enum name name = (enum name)i;
    if (strlen(names[i].name) != length || strncmp(names[i].name, text, length) != 0) continue;
    p->given[i]++;
    if (!names[i].has_value) {
      if (text[length]) return fail(p->fault, "--%s takes no value", names[i].name);
      set_flag(p->options, name);
      return 1;
    }
    if (!text[length] && !next) return fail(p->fault, "--%s: its value is missing", names[i].name);
    if (!take_value(p, name, text[length] ? text + length + 1 : next)) return 0;
    return text[length] ? 1 : 2;
  }
  return refuse_name(p, text, length);
}

// ---- All of them ----

static int check_options(const struct parsing* p) {
  const struct options* const options = p->options;
  const int* const given = p->given;
  const int questions = !!given[opt_contains] + !!given[opt_inside] + !!given[opt_interiors] + !!given[opt_bounds] +
                        (given[opt_within] || given[opt_nearest]);
  if (questions > 1)
    return fail(p->fault, "more than one question: --contains, --inside, --interiors, --bounds, --within or --nearest");
  if (given[opt_nearest] && given[opt_within] && !(options->question.distance >= 0)) {
    return fail(p->fault, "--within: less than 0, beside --nearest");
  }
  if (options->binary && (options->files[0].id || options->files[1].id)) {
    return fail(p->fault, "--binary writes numbers, and --id text");
  }
  if (options->file_count == 0) return fail(p->fault, "a file is missing (--help)");
  if (options->file_count == 2 && strcmp(options->files[0].path, "-") == 0 &&
      strcmp(options->files[1].path, "-") == 0) {
    return fail(p->fault, "standard input can be one file only");
  }
  return 1;
}

int read_options(int count, char** arguments, struct options* options, struct fault* fault) {
  struct parsing p = {options, {0}, fault};
  int are_paths = 0;
  *options = (struct options){.question = {.query = VESICA_JOIN_OVERLAP}, .threads = usable_processors()};
  options->files[0].kind = options->files[1].kind = any_kind;
  for (int i = 1; i < count;) {
    char* const text = arguments[i];
    if (!are_paths && strcmp(text, "--") == 0) {
      are_paths = 1;
      i++;
    } else if (!are_paths && strncmp(text, "--", 2) == 0) {
      const int taken = take_option(&p, text + 2, i + 1 < count ? arguments[i + 1] : NULL);
      if (taken == 0) return 0;
      i += taken;
    } else if (!are_paths && text[0] == '-' && text[1]) {
      return fail(fault, "unknown option '%.40s' (--help)", text);
    } else {
      if (options->file_count == 2) return fail(fault, "'%.40s' would be a third file", text);
      options->files[options->file_count++].path = text;
      i++;
    }
  }
  return options->help || options->version || check_options(&p);
}
