// SPDX-License-Identifier: Apache-2.0
/// vesica-join writes all pairs of shapes that overlap, of two files or of one with itself. Start with operand.c and
/// join.c: they have the calls of the library. source.c reads the files; docs/join.md is about the program.
///
/// The locale is never set: numbers have a point.
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <vesica.h>

#include "join.h"
#include "options.h"
#include "progress.h"
#include "source.h"

enum { failure = 2 };

static int complain(const char* text) {
  end_progress();
  fprintf(stderr, "vesica-join: %s\n", text);
  return failure;
}

static int read_sources(const struct options* options, struct source sources[2]) {
  int64_t faults = 0;
  for (int i = 0; i < options->file_count; i++) {
    const struct file_options* const file = &options->files[i];
    struct source* const source = &sources[i];
    source->path = malloc(strlen(file->path) + 1);
    if (!source->path) return complain("out of memory"), 0;
    strcpy(source->path, file->path);
    source->name = (char)('A' + i);
    source->kind = file->kind;
    source->columns = file->columns;
    source->id_name = file->id;
    source->delimiter = file->delimiter;
    source->threads = options->threads;
    if (!open_source(source)) return 0;
  }
  for (int i = 0; i < options->file_count; i++) {
    if (!read_source(&sources[i])) return 0;
    faults += sources[i].faults;
  }
  if (faults == 0 || options->skip_bad) return 1;
  complain("nothing is written: --skip-bad goes on without bad shapes");
  return 0;
}

struct times {
  double reading, building, joining;
};

static void summarise(const struct join* join, const struct times* times) {
  const int64_t shapes = join->a->items + (join->a == join->b ? 0 : join->b->items);
  fprintf(stderr, "vesica-join: %lld shapes", (long long)join->a->items);
  if (join->a != join->b) fprintf(stderr, " and %lld", (long long)join->b->items);
  fprintf(stderr, ", %lld pairs; read in %.3f s, indexed in %.3f s, joined in %.3f s", (long long)join->pairs,
          times->reading, times->building, times->joining);
  if (shapes > 0) fprintf(stderr, ": %.0f ns a shape", 1e9 * (times->building + times->joining) / (double)shapes);
  fputs("\n", stderr);
}

// The names of the columns that are written.
static void name_columns(const struct options* options, char out[64]) {
  const struct file_options* const files = options->files;
  const int last = options->file_count - 1;
  snprintf(out, 64, "a_%s,b_%s%s\n", files[0].id ? "id" : "from_0", files[last].id ? "id" : "from_0",
           options->question.neighbours > 0 ? ",distance" : "");
}

// Returns the exit status.
static int run(const struct options* options, struct join* join, FILE* file, const struct source sources[2],
               struct times* times) {
  const double begin = seconds();
  char header[64];
  struct output output = {.file = file, .binary = options->binary};
  int good;
  for (int i = 0; i < 2; i++) output.ids[i] = sources[i < options->file_count ? i : 0].shapes.ids;
  name_columns(options, header);
  if (!options->binary && !options->no_header) output.header = header;
  if (!options->count) join->output = &output;
  good = run_join(join);
  if (join->error != 0) return complain(vesica_strerror(join->error));
  if (join->short_of_memory || (!good && !ferror(file))) return complain("out of memory");
  if (!options->count) end_parts(&output);
  if (options->count && fprintf(file, "%lld\n", (long long)join->pairs) < 0) output.failed = 1;
  if (fflush(file) != 0 || ferror(file) || output.failed) return complain("cannot write the pairs");
  times->joining = seconds() - begin;
  return 0;
}

static int join_sources(const struct options* options, const struct source sources[2], struct times* times) {
  struct operand operands[2] = {{.items = 0}, {.items = 0}};
  struct join join = {.a = &operands[0],
                      .b = &operands[options->file_count - 1],
                      .question = options->question,
                      .threads = options->threads};
  const double begin = seconds();
  FILE* file = stdout;
  int good = 1, status;
  for (int i = 0; good && i < options->file_count; i++) {
    good = build_operand(&sources[i].shapes, options->threads, &operands[i]);
  }
  times->building = seconds() - begin;
  if (good && options->output) file = fopen(options->output, "wb");
  if (!good) {
    status = complain("out of memory, or more than 2147483647 shapes");
  } else if (!file) {
    struct fault fault;
    fail(&fault, "%.150s: cannot write: %s", options->output, strerror(errno));
    status = complain(fault.text);
  } else {
    status = run(options, &join, file, sources, times);
    if (file != stdout && fclose(file) != 0 && status == 0) status = complain("cannot write the pairs");
  }
  end_progress();
  if (status == 0 && !options->quiet) summarise(&join, times);
  for (int i = 0; i < options->file_count; i++) free_operand(&operands[i]);
  return status;
}

int main(int count, char** arguments) {
  static struct source sources[2];
  struct options options;
  struct fault fault;
  struct times times = {0, 0, 0};
  const double begin = seconds();
  int status = failure;
  if (!read_options(count, arguments, &options, &fault)) return complain(fault.text);
  if (options.help) return fputs(usage, stdout) < 0 ? failure : 0;
  if (options.version) {
    return printf("vesica-join %d.%d.%d\n", VESICA_VERSION_MAJOR, VESICA_VERSION_MINOR, VESICA_VERSION_PATCH) < 0
               ? failure
               : 0;
  }
  if (options.quiet) hide_progress();
  if (read_sources(&options, sources)) {
    times.reading = seconds() - begin;
    status = join_sources(&options, sources, &times);
  }
  for (int i = 0; i < 2; i++) {
    free_shapes(&sources[i].shapes);
    free(sources[i].text.at);
    free(sources[i].path);
  }
  return status;
}
