// SPDX-License-Identifier: Apache-2.0
/// Answers every pair of a scene file, compares with the known answers, and draws the pairs. Start with query.c: it has
/// the calls of the library. scene.c reads, report.c prints, picture.c draws.
///
/// demo [--table] [-o PICTURE] SCENE; the picture is scenes.svg when not named. Wrong answers are always printed, the
/// others with --table.
///
/// Exit status: 0 when every line was fine and every known answer met; 1 when a line was not, an answer was wrong, or
/// the file holds no pair; 2 when a file could not be read or written.
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <vesica.h>

#include "line.h"
#include "picture.h"
#include "query.h"
#include "report.h"
#include "scene.h"

static void answer_pair(const char* path, long number, const struct pair* pair, struct picture* picture,
                        struct report* report) {
  char reason[160];
  double answer = 0;
  const int32_t error = pair->query->answer(pair, &answer);
  if (error != 0) {
    snprintf(reason, sizeof reason, "%s: %s", pair->query->name, vesica_strerror(error));
    report_fault(report, path, number, reason);
    return;
  }
  add_question(picture, pair, answer, report_answer(report, pair, number, answer));
}

static void answer_line(const char* path, struct line* line, struct picture* picture, struct report* report) {
  struct pair pair;
  struct fault fault;
  enum line_meaning meaning = line_fault;
  if (!line->fault) meaning = parse_line(line->text, line->number, &pair, &fault);
  if (meaning == line_pair) {
    answer_pair(path, line->number, &pair, picture, report);
  } else if (meaning == line_fault) {
    report_fault(report, path, line->number, line->fault ? line->fault : fault.text);
  }
}

// To be called before errno can change.
static int fail_file(const char* path, const char* verb) {
  const char* reason = strerror(errno);
  fflush(stdout);
  fprintf(stderr, "%s: cannot %s: %s\n", path, verb, reason);
  return 0;
}

static int answer_file(const char* path, struct picture* picture, struct report* report) {
  static char text[line_limit + 2];
  struct line line = {.text = text};
  FILE* file = fopen(path, "rb");
  int failed;
  if (!file) return fail_file(path, "read");
  print_head(report);
  while (read_line(file, &line)) answer_line(path, &line, picture, report);
  failed = ferror(file);
  if (failed) fail_file(path, "read");
  fclose(file);
  if (!failed && total(report).pairs + report->faults == 0) {
    report_fault(report, path, line.number + 1, "no pair in this file");
  }
  return !failed;
}

static int save_picture(const char* path, const struct picture* picture) {
  FILE* file = fopen(path, "w");
  int failed;
  if (!file) return fail_file(path, "write");
  write_picture(file, picture);
  failed = ferror(file);
  if (fclose(file) != 0 || failed) return fail_file(path, "write");
  return 1;
}

static int read_arguments(int count, char** arguments, const char** scene, const char** picture, int* table) {
  for (int i = 1; i < count; i++) {
    if (strcmp(arguments[i], "--table") == 0) {
      *table = 1;
    } else if (strcmp(arguments[i], "-o") == 0 && i + 1 < count) {
      *picture = arguments[++i];
    } else if (*arguments[i] == '-' || *scene) {
      return 0;
    } else {
      *scene = arguments[i];
    }
  }
  return *scene != NULL;
}

int main(int count, char** arguments) {
  static struct picture picture;
  static struct report report;
  const char *scene_path = NULL, *picture_path = "scenes.svg";
  if (!read_arguments(count, arguments, &scene_path, &picture_path, &report.table)) {
    fputs("usage: demo [--table] [-o PICTURE] SCENE\n", stderr);
    return 2;
  }
  if (!answer_file(scene_path, &picture, &report)) return 2;
  print_summary(&report);
  if (!save_picture(picture_path, &picture)) return 2;
  if (fflush(stdout) != 0 || ferror(stdout)) return 2;
  return report.faults > 0 || total(&report).wrong > 0;
}
