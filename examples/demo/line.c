// SPDX-License-Identifier: Apache-2.0
#include "line.h"

#include <stdlib.h>
#include <string.h>

// Some editors begin UTF-8 files with a byte order mark.
static void drop_byte_order_mark(char* text) {
  if (memcmp(text, "\xEF\xBB\xBF", 3) == 0) memmove(text, text + 3, strlen(text + 3) + 1);
}

// Room for one more than `length` characters and the end.
static int make_room(struct line* line, size_t length) {
  size_t room = line->room;
  char* text;
  if (!line->grows) return length <= line_limit;
  if (length + 2 <= room) return 1;
  room = room < line_limit ? line_limit + 2 : 2 * room;
  text = realloc(line->text, room);
  if (!text) return 0;
  line->text = text;
  line->room = room;
  return 1;
}

int read_line(FILE* file, struct line* line) {
  size_t length = 0, kept = 0;
  int c = fgetc(file);
  if (c == EOF || !make_room(line, 0)) return 0;
  line->number++;
  line->fault = NULL;
  for (; c != EOF && c != '\n'; c = fgetc(file), length++) {
    if (c == '\0') line->fault = "a NUL byte: this is not a text file";
    // One more than the limit, which may be a CR.
    if (kept == length && make_room(line, length)) line->text[kept++] = (char)c;
  }
  if (ferror(file)) return 0;
  if (length == kept && length > 0 && line->text[length - 1] == '\r') kept = --length;
  if (line->grows ? length > kept : length > line_limit) {
    if (!line->fault) line->fault = line->grows ? "line longer than memory" : "line longer than 4095 bytes";
  }
  line->text[kept] = '\0';
  if (line->number == 1 && length >= 3) drop_byte_order_mark(line->text);
  return 1;
}

void put_printable(FILE* file, const char* text, int limit) {
  int i;
  for (i = 0; i < limit && text[i]; i++) fputc(text[i] >= ' ' && text[i] <= '~' ? text[i] : '?', file);
  if (text[i]) fputs("...", file);
}
