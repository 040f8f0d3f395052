// SPDX-License-Identifier: Apache-2.0
/// Shapes in a table: names in the first line, a shape in each line after it. Fields are between commas, semicolons or
/// tabs, and in double quotes where they hold one of these, a quote (doubled) or a line end.
#include <stdlib.h>
#include <string.h>

#include "layout.h"
#include "number.h"
#include "rows.h"

enum { most_columns = 1024 };

struct field {
  char *at, *end;  // the end is a NUL
};

struct table {
  char delimiter;
  const char* names[most_columns];
  int count;
  struct layout layout;
  int id;  // column, or -1
};

// Takes away the quotes, and those that are doubled. Returns what follows, or NULL without an end.
static char* take_quoted(char* at, char* end, struct field* field) {
  char* out = at;
  field->at = at;
  for (;;) {
    char* const quote = memchr(at, '"', (size_t)(end - at));
    if (!quote) return NULL;
    if (out != at) memmove(out, at, (size_t)(quote - at));
    out += quote - at;
    if (quote + 1 == end || quote[1] != '"') {
      field->end = out;
      *out = '\0';
      return quote + 1;
    }
    *out++ = '"';
    at = quote + 2;
  }
}

static char* take_plain(char* at, char* end, char delimiter, struct field* field) {
  char* next = memchr(at, delimiter, (size_t)(end - at));
  if (!next) next = end;
  while (at < next && *at == ' ') at++;
  field->at = at;
  field->end = next;
  while (field->end > at && field->end[-1] == ' ') field->end--;
  return next;
}

// Returns how many fields there are, of which the first ones are in `fields`, or 0 with the reason.
static int split(char* at, char* end, char delimiter, struct field fields[most_columns], struct fault* fault) {
  int count = 0;
  for (;;) {
    struct field rest;
    struct field* const field = count < most_columns ? &fields[count] : &rest;
    char* const next = *at == '"' ? take_quoted(at + 1, end, field) : take_plain(at, end, delimiter, field);
    if (!next) return fail(fault, "a quote without end");
    if (next < end && *next != delimiter) return fail(fault, "text after a quoted field");
    count++;
    if (next == end) {
      *field->end = '\0';
      return count;
    }
    *next = '\0';
    *field->end = '\0';
    at = next + 1;
  }
}

// ---- Rows ----

static int read_numbers(const struct table* table, const struct field* fields, struct row* row) {
  const struct form* const form = table->layout.form;
  double values[most_numbers];
  for (int i = 0; i < form->count; i++) {
    const int column = table->layout.columns[i];
    const char* const at = fields[column].at;
    const char* const end = parse_decimal(at, &values[i]);
    if (end == at || *end) {
      return fail(&row->fault, *at ? "column '%.40s': '%.40s' is not a number" : "column '%.40s' is empty",
                  table->names[column], at);
    }
  }
  make_shape(form, values, &row->shape);
  return check_shape(&row->shape, row->vertices, row->source->name, &row->fault);
}

static enum meaning read_known(const struct table* table, const struct field* fields, struct row* row) {
  const int column = table->layout.columns[0];
  const enum meaning meaning = read_known_text(fields[column].at, row);
  if (meaning == bad_shape) {
    const struct fault inner = row->fault;
    fail(&row->fault, "column '%.40s': %.160s", table->names[column], inner.text);
  }
  return meaning;
}

static enum meaning read_row(const void* context, struct row* row) {
  const struct table* const table = context;
  struct field fields[most_columns];
  int count;
  if (row->at == row->end) return no_shape;
  row->id = (struct id){NULL, 0};
  count = split(row->at, row->end, table->delimiter, fields, &row->fault);
  if (count == 0) return bad_shape;
  if (count != table->count) {
    fail(&row->fault, "%d fields, but %d names in the first line", count, table->count);
    return bad_shape;
  }
  if (table->id >= 0) row->id = (struct id){fields[table->id].at, fields[table->id].end - fields[table->id].at};
  if (table->layout.form->count == 0) return read_known(table, fields, row);
  return read_numbers(table, fields, row) ? good_shape : bad_shape;
}

// ---- The first line ----

// The most frequent one outside quotes.
static char find_delimiter(const char* at) {
  static const char delimiters[] = {',', ';', '\t'};
  int counts[3] = {0, 0, 0}, best = 0, quoted = 0;
  for (; *at; at++) {
    quoted ^= *at == '"';
    for (int i = 0; i < 3 && !quoted; i++) counts[i] += *at == delimiters[i];
  }
  for (int i = 1; i < 3; i++) {
    if (counts[i] > counts[best]) best = i;
  }
  return delimiters[best];
}

// `line` is the first one, in memory of its own. Returns 1 if the table can be read.
static int read_names(const struct source* source, char* line, struct table* table, struct fault* fault) {
  struct field fields[most_columns];
  table->delimiter = source->delimiter ? source->delimiter : find_delimiter(line);
  table->count = split(line, line + strlen(line), table->delimiter, fields, fault);
  if (table->count > most_columns) table->count = fail(fault, "more than %d columns", most_columns);
  if (table->count == 0) return 0;
  for (int i = 0; i < table->count; i++) table->names[i] = fields[i].at;
  if (!find_layout(source->columns, source->kind, table->names, table->count, &table->layout, fault)) return 0;
  table->id = source->id_name ? find_column(source->id_name, table->names, table->count) : -1;
  return !source->id_name || table->id >= 0 || fail(fault, "no column '%.40s'", source->id_name);
}

// Names, but of no columns that make a shape: more than one word, the first of which begins no line of shapes.
static int has_other_names(const struct table* table, int32_t kind) {
  const char first = table->names[0][0];
  const int is_word = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z') || first == '_';
  return table->count > 1 && is_word && find_kind(table->names[0]) < 0 && !strchr(table->names[0], '(') &&
         !strchr(table->names[0], ' ') && (kind != any_kind || strcmp(table->names[0], "kind") != 0);
}

int read_table(struct source* source) {
  static struct table table;
  struct text* const text = &source->text;
  const size_t space = strspn(text->at, " ");  // that of a byte order mark
  int64_t lines = 0;
  char *const begin = text->at + space, *const end = text->at + text->size;
  char* const stop = find_row_end(begin, end, 1, &lines);
  const size_t length = (size_t)(stop - begin) - (stop > begin && stop[-1] == '\r');
  char* const line = malloc(length + 1);
  struct fault fault;
  int good;
  if (!line) return refuse_source(source, "out of memory");
  memcpy(line, begin, length);
  line[length] = '\0';
  if (read_names(source, line, &table, &fault)) {
    const int quotes = memchr(begin, '"', (size_t)(end - begin)) != NULL;
    const int64_t first = stop < end ? stop + 1 - text->at : text->size;
    good = read_rows(source, first, 1 + lines, quotes, &table, read_row);
  } else if (source->columns || source->id_name || source->delimiter ||
             (table.count > 0 && has_other_names(&table, source->kind))) {
    good = refuse_source(source, fault.text);
  } else {
    good = read_lines(source);
  }
  free(line);
  return good;
}
