// SPDX-License-Identifier: Apache-2.0
#include "report.h"

#include <math.h>
#include <stdio.h>
#include <vesica.h>

#include "line.h"

void print_head(const struct report* report) {
  if (!report->table) return;
  printf("%6s  %-16s  %-17s  %22s  %22s  %s\n", "line", "shapes", "query", "answer", "known", "id");
}

static void print_answer(const struct pair* pair, long number, double answer, int wrong) {
  char kinds[40], known[40] = "?";
  snprintf(kinds, sizeof kinds, "%s-%s", vesica_kind_name(pair->a.kind), vesica_kind_name(pair->b.kind));
  if (pair->has_known) snprintf(known, sizeof known, "%.17g", pair->known);
  printf("%6ld  %-16s  %-17s  %22.17g  %22s  ", number, kinds, pair->query->name, answer, known);
  put_printable(stdout, pair->id, (int)sizeof pair->id);
  puts(wrong ? "  WRONG" : "");
}

int report_answer(struct report* report, const struct pair* pair, long number, double answer) {
  struct tally* tally = &report->tally[pair->query - queries];
  const int wrong = pair->has_known && !(fabs(answer - pair->known) <= pair->tolerance);
  tally->pairs++;
  tally->wrong += wrong;
  tally->right += pair->has_known && !wrong;
  tally->unknown += !pair->has_known;
  if (report->table || wrong) print_answer(pair, number, answer, wrong);
  return wrong;
}

void report_fault(struct report* report, const char* path, long number, const char* reason) {
  report->faults++;
  fflush(stdout);
  fprintf(stderr, "%s:%ld: %s\n", path, number, reason);
}

struct tally total(const struct report* report) {
  struct tally sum = {0, 0, 0, 0};
  for (int i = 0; i < query_count; i++) {
    sum.pairs += report->tally[i].pairs;
    sum.right += report->tally[i].right;
    sum.wrong += report->tally[i].wrong;
    sum.unknown += report->tally[i].unknown;
  }
  return sum;
}

static void print_tally(const char* name, const struct tally* tally) {
  printf("%-17s  %8ld  %8ld  %8ld  %9ld\n", name, tally->pairs, tally->right, tally->wrong, tally->unknown);
}

void print_summary(const struct report* report) {
  const struct tally sum = total(report);
  if (report->table || sum.wrong > 0) puts("");
  printf("%-17s  %8s  %8s  %8s  %9s\n", "query", "answered", "right", "wrong", "not known");
  for (int i = 0; i < query_count; i++) {
    if (report->tally[i].pairs > 0) print_tally(queries[i].name, &report->tally[i]);
  }
  print_tally("all", &sum);
  printf("lines with errors: %ld\n", report->faults);
}
