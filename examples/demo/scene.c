// SPDX-License-Identifier: Apache-2.0
#include "scene.h"

#include <stdio.h>
#include <string.h>
#include <vesica.h>

#include "fields.h"
#include "query.h"

enum { row_fields = 20, kind_a_field = 2, kind_b_field = 9, query_field = 16, shape_columns = 6 };

static int parse_row_shape(char* const* fields, char name, struct shape* shape, struct fault* fault) {
  char column[] = {name, '0', '\0'};
  int used;
  shape->kind = find_kind(fields[0]);
  if (shape->kind < 0) return fail(fault, "kind_%c: unknown kind '%.40s'", name, fields[0]);
  used = vesica_field_count(shape->kind);
  if (used > shape_columns) return fail(fault, "%s has %d numbers, a row has %d", fields[0], used, shape_columns);
  for (int i = 0; i < shape_columns; i++) {
    const char* text = fields[1 + i];
    column[1] = (char)('0' + i);
    if (i < used && !parse_number(text, column, &shape->numbers[i], fault)) return 0;
    if (i >= used && *text) {
      return fail(fault, "%s: '%.40s', but %s has only %d numbers", column, text, fields[0], used);
    }
  }
  return 1;
}

static int parse_row_answer(char* const* fields, struct pair* pair, struct fault* fault) {
  pair->query = find_query(fields[0]);
  if (!pair->query) return fail(fault, "unknown query '%.40s'", fields[0]);
  if (*fields[1] && !parse_known(fields[1], pair, fault)) return 0;
  if (*fields[2] && !parse_number(fields[2], "tolerance", &pair->tolerance, fault)) return 0;
  if (!(pair->tolerance >= 0)) return fail(fault, "tolerance '%.40s' is not 0 or more", fields[2]);
  return 1;
}

static int parse_row(char* text, struct pair* pair, struct fault* fault) {
  char* fields[row_fields];
  for (int i = 0; i < row_fields; i++) fields[i] = take_field(&text, ',');
  snprintf(pair->id, sizeof pair->id, "%s", fields[0]);
  return parse_row_shape(fields + kind_a_field, 'a', &pair->a, fault) &&
         parse_row_shape(fields + kind_b_field, 'b', &pair->b, fault) &&
         parse_row_answer(fields + query_field, pair, fault);
}

static int parse_short(char* text, struct pair* pair, struct fault* fault) {
  char *known = text, *shapes = take_field(&known, '=');
  const char *word = take_word(&shapes), *junk;
  pair->query = word ? find_query(word) : NULL;
  if (pair->query) {
    word = take_word(&shapes);
  } else {
    pair->query = find_query("overlap");
  }
  if (!parse_shape(word, &shapes, 'A', &pair->a, fault)) return 0;
  if (!parse_shape(take_word(&shapes), &shapes, 'B', &pair->b, fault)) return 0;
  junk = take_word(&shapes);
  if (junk) return fail(fault, "'%.40s' after the two shapes", junk);
  return !known || parse_known(take_field(&known, '#'), pair, fault);
}

static int count_fields(const char* text) {
  int count = 1;
  for (; *text; text++) count += *text == ',';
  return count;
}

// A line of 20 fields is a row. Any other line is short, and begins with a query or a kind.
static int parse_pair(char* text, struct pair* pair, struct fault* fault) {
  const int fields = count_fields(text);
  char first[48];
  const size_t length = strcspn(text, " \t,");
  if (fields == row_fields) return parse_row(text, pair, fault);
  snprintf(first, sizeof first, "%.*s", (int)length, text);
  if (find_query(first) || find_kind(first) >= 0) return parse_short(take_field(&text, '#'), pair, fault);
  if (fields == 1) return fail(fault, "'%.40s' is neither a query nor a kind", first);
  return fail(fault, "'%.40s' is neither a query nor a kind, and a row has 20 fields, not %d", first, fields);
}

enum line_meaning parse_line(char* text, long number, struct pair* pair, struct fault* fault) {
  text += strspn(text, " \t");
  if (!*text || *text == '#' || strncmp(text, "id,source,kind_a,", 17) == 0) return line_empty;
  memset(pair, 0, sizeof *pair);
  snprintf(pair->id, sizeof pair->id, "line %ld", number);
  if (!parse_pair(text, pair, fault)) return line_fault;
  if (!check_shape(&pair->a, 'A', fault) || !check_shape(&pair->b, 'B', fault)) return line_fault;
  return line_pair;
}
