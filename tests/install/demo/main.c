// SPDX-License-Identifier: Apache-2.0
/// Answers every pair of a scene file, beside the known answers, and draws the pairs.
///
/// demo [-o PICTURE] SCENE; the picture is scenes.svg when not named.
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
#include "scene.h"

struct tally {
  long pairs, answered, right, wrong, unknown, skipped, faults;
};

static void report_fault(const char* path, long number, const char* text) {
  fflush(stdout);
  fprintf(stderr, "%s:%ld: %s\n", path, number, text);
}

static void print_answer(const struct pair* pair, long number, double answer, int wrong) {
  char kinds[40], known[40] = "?";
  snprintf(kinds, sizeof kinds, "%s-%s", vesica_kind_name(pair->a.kind), vesica_kind_name(pair->b.kind));
  if (pair->has_known) snprintf(known, sizeof known, "%.17g", pair->known);
  printf("%6ld  %-16s  %-10s  %8.17g  %8s  ", number, kinds, pair->query->name, answer, known);
  put_printable(stdout, pair->id, (int)sizeof pair->id);
  puts(wrong ? "  WRONG" : "");
}

static int differs(const struct pair* pair, double answer) {
  const double difference = answer > pair->known ? answer - pair->known : pair->known - answer;
  return pair->has_known && !(difference <= pair->tolerance);
}

static int shapes_overlap(const struct pair* pair) {
  return vesica_overlap_f64(pair->a.kind, pair->a.numbers, pair->b.kind, pair->b.numbers) == 1;
}

static void answer_pair(const char* path, long number, const struct pair* pair, struct picture* picture,
                        struct tally* tally) {
  double answer = 0;
  int32_t error;
  int wrong;
  tally->pairs++;
  if (!pair->query->answer) {
    tally->skipped++;
    return;
  }
  error = pair->query->answer(pair, &answer);
  if (error != 0) {
    tally->faults++;
    report_fault(path, number, vesica_strerror(error));
    return;
  }
  wrong = differs(pair, answer);
  tally->answered++;
  tally->wrong += wrong;
  tally->right += pair->has_known && !wrong;
  tally->unknown += !pair->has_known;
  print_answer(pair, number, answer, wrong);
  add_panel(picture, pair, shapes_overlap(pair), wrong);
}

static void answer_line(const char* path, struct line* line, struct picture* picture, struct tally* tally) {
  struct pair pair;
  struct fault fault;
  enum line_meaning meaning = line_fault;
  if (!line->fault) meaning = parse_line(line->text, line->number, &pair, &fault);
  if (meaning == line_pair) {
    answer_pair(path, line->number, &pair, picture, tally);
  } else if (meaning == line_fault) {
    tally->faults++;
    report_fault(path, line->number, line->fault ? line->fault : fault.text);
  }
}

// To be called before errno can change.
static int fail_file(const char* path, const char* verb) {
  const char* reason = strerror(errno);
  fflush(stdout);
  fprintf(stderr, "%s: cannot %s: %s\n", path, verb, reason);
  return 0;
}

static int answer_file(const char* path, struct picture* picture, struct tally* tally) {
  static struct line line;
  FILE* file = fopen(path, "rb");
  int failed;
  if (!file) return fail_file(path, "read");
  printf("%6s  %-16s  %-10s  %8s  %8s  %s\n", "line", "shapes", "query", "answer", "known", "id");
  while (read_line(file, &line)) answer_line(path, &line, picture, tally);
  failed = ferror(file);
  if (failed) fail_file(path, "read");
  fclose(file);
  if (!failed && tally->pairs + tally->faults == 0) {
    tally->faults++;
    report_fault(path, line.number + 1, "no pair in this file");
  }
  return !failed;
}

static void print_tally(const struct tally* tally) {
  printf(
      "pairs %ld, answered %ld (right %ld, wrong %ld, not known %ld), other queries skipped %ld, lines with errors "
      "%ld\n",
      tally->pairs, tally->answered, tally->right, tally->wrong, tally->unknown, tally->skipped, tally->faults);
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

static int find_paths(int count, char** arguments, const char** scene, const char** picture) {
  for (int i = 1; i < count; i++) {
    if (strcmp(arguments[i], "-o") == 0 && i + 1 < count) {
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
  struct tally tally = {0, 0, 0, 0, 0, 0, 0};
  const char *scene_path = NULL, *picture_path = "scenes.svg";
  if (!find_paths(count, arguments, &scene_path, &picture_path)) {
    fputs("usage: demo [-o PICTURE] SCENE\n", stderr);
    return 2;
  }
  if (!answer_file(scene_path, &picture, &tally)) return 2;
  print_tally(&tally);
  if (!save_picture(picture_path, &picture)) return 2;
  if (fflush(stdout) != 0 || ferror(stdout)) return 2;
  return tally.faults > 0 || tally.wrong > 0;
}
