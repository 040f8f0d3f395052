// SPDX-License-Identifier: Apache-2.0
#define _POSIX_C_SOURCE 200809L
#include "rows.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "wkt.h"
#include "work.h"

enum { piece_bytes = 1 << 20 };

struct named_fault {
  int64_t line;  // in the piece, from 0
  struct fault fault;
};

struct piece {
  int64_t begin, end;  // its lines
  int64_t quotes;      // between the same offsets, before the lines are known
  int64_t lines;
  int64_t faults;
  struct named_fault* named;  // the first ones
  int short_of_memory;
  struct shapes shapes;
  struct vertices vertices;
};

struct rows {
  struct source* source;
  int64_t line;
  int quotes;
  const void* context;
  enum meaning (*read)(const void* context, struct row* row);
  struct piece* pieces;
  int64_t count;
};

static int64_t count_quotes(const char* at, const char* end) {
  int64_t count = 0;
  while ((at = memchr(at, '"', (size_t)(end - at)))) {
    at++;
    count++;
  }
  return count;
}

char* find_row_end(char* at, char* end, int quotes, int64_t* lines) {
  int64_t count = 0;
  for (;;) {
    char* found = memchr(at, '\n', (size_t)(end - at));
    if (!found) found = end;
    ++*lines;
    if (quotes) count += count_quotes(at, found);
    if (found == end || count % 2 == 0) return found;
    at = found + 1;
  }
}

// ---- The lines of each piece ----

static void count_in_piece(void* context, int64_t number) {
  const struct rows* const rows = context;
  struct piece* const piece = &rows->pieces[number];
  piece->quotes = count_quotes(rows->source->text.at + piece->begin, rows->source->text.at + piece->end);
}

// Moves each begin to the next begin of a line, and each end to the next piece's begin.
static void settle_pieces(struct rows* rows) {
  char* const text = rows->source->text.at;
  char* const end = text + rows->source->text.size;
  int64_t quotes = 0, lines = 0;
  for (int64_t i = 1; i < rows->count; i++) {
    struct piece* const piece = &rows->pieces[i];
    char* at = text + piece->begin;
    quotes += rows->pieces[i - 1].quotes;
    if (rows->pieces[i - 1].begin > piece->begin) {
      piece->begin = rows->pieces[i - 1].begin;  // a line that goes through the whole piece
    } else if (at[-1] != '\n' || quotes % 2 != 0) {
      char* found = NULL;
      // Inside quotes a quote ends them before the line may end.
      if (quotes % 2 != 0) {
        char* const closing = memchr(at, '"', (size_t)(end - at));
        at = closing ? closing + 1 : end;
      }
      found = find_row_end(at, end, rows->quotes, &lines);
      piece->begin = found < end ? found + 1 - text : end - text;
    }
    rows->pieces[i - 1].end = piece->begin;
  }
}

static int divide(struct rows* rows, int64_t begin) {
  const int64_t size = rows->source->text.size;
  rows->count = (size - begin) / piece_bytes + 1;
  rows->pieces = calloc((size_t)rows->count, sizeof *rows->pieces);
  if (!rows->pieces) return 0;
  for (int64_t i = 0; i < rows->count; i++) {
    rows->pieces[i].begin = begin + i * piece_bytes;
    rows->pieces[i].end = i + 1 < rows->count ? begin + (i + 1) * piece_bytes : size;
  }
  if (rows->quotes) run_parts(rows->source->threads, shown_path(rows->source), rows->count, count_in_piece, rows);
  settle_pieces(rows);
  return 1;
}

// ---- Reading ----

static void note(struct piece* piece, int64_t line, const struct fault* fault) {
  if (piece->faults == 0) piece->named = malloc(most_complaints * sizeof *piece->named);
  if (!piece->named) piece->short_of_memory = 1;
  if (piece->named && piece->faults < most_complaints) {
    piece->named[piece->faults].line = line;
    piece->named[piece->faults].fault = *fault;
  }
  piece->faults++;
}

static enum meaning read_row(const struct rows* rows, struct row* row) {
  if (memchr(row->at, '\0', (size_t)(row->end - row->at))) {
    fail(&row->fault, "a NUL byte: this is not a text file");
    return bad_shape;
  }
  if (row->end > row->at && row->end[-1] == '\r') row->end--;
  *row->end = '\0';
  return rows->read(rows->context, row);
}

static int take_row(const struct rows* rows, struct piece* piece, struct row* row, int64_t line) {
  struct shapes* const shapes = &piece->shapes;
  const int64_t number = shapes->count;
  const enum meaning meaning = read_row(rows, row);
  if (meaning == no_shape) return 1;
  if (meaning == bad_shape) note(piece, line, &row->fault);
  if (meaning != good_shape) {
    shapes->count++;
  } else if (!add_shape(shapes, &row->shape, &piece->vertices)) {
    return 0;
  }
  return !row->source->id_name || set_ids(shapes, number, row->id);
}

static void read_piece(void* context, int64_t number) {
  const struct rows* const rows = context;
  struct piece* const piece = &rows->pieces[number];
  char *at = rows->source->text.at + piece->begin, *const end = rows->source->text.at + piece->end;
  struct row row = {.source = rows->source, .vertices = &piece->vertices, .is_first = number == 0};
  while (at < end && !piece->short_of_memory) {
    const int64_t line = piece->lines;
    row.at = at;
    row.end = find_row_end(at, end, rows->quotes, &piece->lines);
    at = row.end + 1;
    if (!take_row(rows, piece, &row, line)) piece->short_of_memory = 1;
    row.is_first = 0;
  }
  free_vertices(&piece->vertices);
}

// Names the first faults of all pieces, and counts them.
static int report(struct rows* rows) {
  struct source* const source = rows->source;
  int64_t line = rows->line;
  int good = 1;
  for (int64_t i = 0; i < rows->count; i++) {
    struct piece* const piece = &rows->pieces[i];
    for (int64_t j = 0; j < piece->faults && j < most_complaints && piece->named; j++) {
      complain_of_shape(source, &piece->named[j].fault, ":%lld", (long long)(line + piece->named[j].line));
    }
    if (piece->faults > most_complaints) source->faults += piece->faults - most_complaints;
    free(piece->named);
    line += piece->lines;
    if (piece->short_of_memory) good = 0;
  }
  return good;
}

static int merge(struct rows* rows) {
  struct shapes** const all = malloc((size_t)rows->count * sizeof *all);
  int good = all != NULL;
  for (int64_t i = 0; good && i < rows->count; i++) all[i] = &rows->pieces[i].shapes;
  good = good && join_pieces(&rows->source->shapes, all, rows->count, rows->source->threads);
  free(all);
  return good;
}

int read_rows(struct source* source, int64_t begin, int64_t line, int quotes, const void* context,
              enum meaning (*read)(const void* context, struct row* row)) {
  struct rows rows = {source, line, quotes, context, read, NULL, 0};
  int good = divide(&rows, begin);
  if (good) run_parts(source->threads, shown_path(source), rows.count, read_piece, &rows);
  good = good && report(&rows) && merge(&rows);
  free(rows.pieces);
  return good || refuse_source(source, "out of memory, or too many vertices");
}

enum meaning read_known_text(char* text, struct row* row) {
  char reason[geometry_fault_room];
  size_t length = strlen(text);
  while (length > 0 && (text[length - 1] == ' ' || text[length - 1] == '\t')) text[--length] = '\0';
  if (length == 0 || (length > 5 && strcasecmp(text + length - 5, "EMPTY") == 0)) return empty_shape;
  if (!parse_wkt(text, row->vertices, &row->shape.kind, row->shape.numbers, reason)) {
    fail(&row->fault, "%s", reason);
    return bad_shape;
  }
  return check_shape(&row->shape, row->vertices, row->source->name, &row->fault) ? good_shape : bad_shape;
}
