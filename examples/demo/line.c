// SPDX-License-Identifier: Apache-2.0
#include "line.h"

#include <string.h>

// Some editors begin UTF-8 files with a byte order mark.
static void drop_byte_order_mark(char* text) {
  if (memcmp(text, "\xEF\xBB\xBF", 3) == 0) memmove(text, text + 3, strlen(text + 3) + 1);
}

int read_line(FILE* file, struct line* line) {
  size_t length = 0, kept;
  int c = fgetc(file);
  if (c == EOF) return 0;
  line->number++;
  line->fault = NULL;
  for (; c != EOF && c != '\n'; c = fgetc(file), length++) {
    if (c == '\0') line->fault = "a NUL byte: this is not a text file";
    // One more than the limit, which may be a CR.
    if (length <= line_limit) line->text[length] = (char)c;
  }
  if (ferror(file)) return 0;
  kept = length <= line_limit ? length : line_limit + 1;
  if (length == kept && length > 0 && line->text[length - 1] == '\r') kept = --length;
  if (length > line_limit && !line->fault) line->fault = "line longer than 4095 bytes";
  line->text[kept] = '\0';
  if (line->number == 1 && length >= 3) drop_byte_order_mark(line->text);
  return 1;
}

void put_printable(FILE* file, const char* text, int limit) {
  int i;
  for (i = 0; i < limit && text[i]; i++) fputc(text[i] >= ' ' && text[i] <= '~' ? text[i] : '?', file);
  if (text[i]) fputs("...", file);
}
