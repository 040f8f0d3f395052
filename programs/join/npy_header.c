// SPDX-License-Identifier: Apache-2.0
#include "npy_header.h"

#include <stdlib.h>
#include <string.h>
#include <vesica.h>

#include "shapes.h"

enum { most_extents = 3, most_fields = 64, most_header = 65535, most_name = 32 };

struct field {
  char name[most_name];  // empty in an array of plain numbers
  int is_number;         // a float or double
  int is_integer;        // of 4 or 8 bytes
  struct npy_number number;
};

struct record {
  int count;
  struct field fields[most_fields];
  size_t bytes;
};

// The dictionary as text, without the magic number and version in front of it.
static int read_dictionary(FILE* file, char* text, struct fault* fault) {
  unsigned char start[8], more[2];
  size_t length;
  if (fread(start, 1, 8, file) != 8 || memcmp(start, "\x93NUMPY", 6) != 0) return fail(fault, "not a file of numpy's");
  if (start[6] < 1 || start[6] > 3) return fail(fault, "version %d of numpy's format", start[6]);
  if (fread(more, 1, 2, file) != 2) return fail(fault, "its header is cut off");
  length = more[0] + 256u * more[1];
  // From version 2 on the length has four bytes; the upper two must be 0 here.
  if (start[6] > 1 && (fread(more, 1, 2, file) != 2 || more[0] || more[1]))
    return fail(fault, "its header is too long");
  if (fread(text, 1, length, file) != length) return fail(fault, "its header is cut off");
  text[length] = '\0';
  return 1;
}

// Returns the value that follows a key, or NULL.
static const char* find_value(const char* dictionary, const char* key) {
  const char* at = strstr(dictionary, key);
  if (!at) return NULL;
  at += strlen(key);
  return at + strspn(at, " ");
}

// A string between quotes that fits; moves behind it.
static int take_quoted(const char** text, char out[most_name]) {
  size_t length;
  if (**text != '\'') return 0;
  length = strcspn(++*text, "'");
  if (length >= most_name || !(*text)[length]) return 0;
  memcpy(out, *text, length);
  out[length] = '\0';
  *text += length + 1;
  return 1;
}

// '<f8' and the like: order of bytes, letter, size.
static int take_type(const char** text, struct record* record, struct field* field) {
  char type[most_name], *end;
  long size;
  if (!take_quoted(text, type) || !type[0] || !type[1]) return 0;
  size = strtol(type + 2, &end, 10);
  if (end == type + 2 || size < 1 || size > most_row_bytes) return 0;
  if (type[1] == 'U') size *= 4;
  field->is_number = type[1] == 'f' && (size == 4 || size == 8) && (type[0] == '<' || type[0] == '>');
  field->is_integer = (type[1] == 'i' || type[1] == 'u') && (size == 4 || size == 8) && type[0] != '|';
  field->number.is_unsigned = type[1] == 'u';
  field->number.big = type[0] == '>';
  field->number.bytes = (int)size;
  field->number.offset = record->bytes;
  record->bytes += (size_t)size;
  record->count++;
  return record->bytes <= most_row_bytes;
}

// [('cx', '<f8'), ...]
static int take_fields(const char** text, struct record* record) {
  do {
    struct field* field = &record->fields[record->count];
    ++*text;
    *text += strspn(*text, " ");
    if (**text == ']' && record->count > 0) break;
    if (record->count == most_fields || *(*text)++ != '(' || !take_quoted(text, field->name)) return 0;
    *text += strspn(*text, ", ");
    if (!take_type(text, record, field) || *(*text)++ != ')') return 0;
  } while (**text == ',');
  return **text == ']';
}

// (rows,), (rows, columns) or (rows, positions, 2)
static int parse_extents(const char* text, int64_t extents[most_extents]) {
  int count = 0;
  while (count < most_extents) {
    char* end;
    text += strspn(text, "(, ");
    if (*text < '0' || *text > '9') break;
    extents[count++] = strtoll(text, &end, 10);
    text = end;
  }
  text += strspn(text, ", ");
  return *text == ')' ? count : 0;
}

static int locate_in_record(const struct record* record, const char* columns, int32_t kind, struct npy_header* header,
                            struct fault* fault) {
  const char* names[most_fields];
  struct layout layout;
  for (int i = 0; i < record->count; i++) names[i] = record->fields[i].name;
  if (!find_layout(columns, kind, names, record->count, &layout, fault)) return 0;
  if (layout.form->count == 0) return fail(fault, "a column of an array is no well-known text");
  for (int i = 0; i < layout.form->count; i++) {
    const struct field* field = &record->fields[layout.columns[i]];
    if (!field->is_number) return fail(fault, "field '%s' is not of float64 or float32", field->name);
    header->numbers[i] = field->number;
  }
  header->form = layout.form;
  header->row_bytes = record->bytes;
  return 1;
}

static int locate_in_row(const struct field* field, int64_t count, const char* columns, int32_t kind,
                         struct npy_header* header, struct fault* fault) {
  struct layout layout;
  if (count > most_fields) return fail(fault, "more than %d columns", most_fields);
  if (!find_layout(columns, kind, NULL, (int)count, &layout, fault)) return 0;
  if (layout.form->count != count) return fail(fault, "%d columns, but --shape has others", (int)count);
  if (!field->is_number) return fail(fault, "its numbers are not float64 or float32");
  for (int i = 0; i < count; i++) {
    header->numbers[i] = field->number;
    header->numbers[i].offset = (size_t)layout.columns[i] * (size_t)field->number.bytes;
  }
  header->form = layout.form;
  header->row_bytes = (size_t)count * (size_t)field->number.bytes;
  return 1;
}

static uint64_t bits_at(const unsigned char* row, const struct npy_number* number) {
  uint64_t bits = 0;
  for (int i = 0; i < number->bytes; i++) {
    bits = bits << 8 | row[number->offset + (size_t)(number->big ? i : number->bytes - 1 - i)];
  }
  return bits;
}

double npy_number(const unsigned char* row, const struct npy_number* number) {
  const uint64_t bits = bits_at(row, number);
  const uint32_t narrow = (uint32_t)bits;
  double wide;
  float single;
  memcpy(&wide, &bits, sizeof wide);
  memcpy(&single, &narrow, sizeof single);
  return number->bytes == sizeof wide ? wide : (double)single;
}

int64_t npy_integer(const unsigned char* row, const struct npy_number* number) {
  const uint64_t bits = bits_at(row, number);
  return number->bytes == 4 && !number->is_unsigned ? (int32_t)bits : (int64_t)bits;
}

// Polygons or polylines of as many vertices each.
static int spread_positions(const int64_t shape[most_extents], struct npy_header* header, struct fault* fault) {
  if (shape[2] != 2 || shape[1] < 1 || shape[1] > INT32_MAX || shape[0] > INT64_MAX / shape[1]) {
    return fail(fault, "of three dimensions the last must be 2, and the middle one the number of vertices");
  }
  header->each = shape[1];
  header->rows = shape[0] * shape[1];
  return 1;
}

int read_npy_integers_header(FILE* file, struct npy_header* header, struct fault* fault) {
  static char dictionary[most_header + 1];
  struct record record = {.count = 0};
  const char *type, *extents;
  int64_t shape[most_extents];
  if (!read_dictionary(file, dictionary, fault)) return 0;
  type = find_value(dictionary, "'descr':");
  extents = find_value(dictionary, "'shape':");
  if (!type || !extents || !take_type(&type, &record, &record.fields[0]) || !record.fields[0].is_integer ||
      parse_extents(extents, shape) != 1) {
    return fail(fault, "not an array of offsets, int32 or int64, of one dimension");
  }
  header->rows = shape[0];
  header->numbers[0] = record.fields[0].number;
  header->row_bytes = record.bytes;
  return 1;
}

int read_npy_header(FILE* file, const char* columns, int32_t kind, struct npy_header* header, struct fault* fault) {
  static char dictionary[most_header + 1];
  static struct record record;
  const char *type, *order, *extents;
  int64_t shape[most_extents];
  int is_record, count, is_path;
  memset(&record, 0, sizeof record);
  if (!read_dictionary(file, dictionary, fault)) return 0;
  type = find_value(dictionary, "'descr':");
  order = find_value(dictionary, "'fortran_order':");
  extents = find_value(dictionary, "'shape':");
  if (!type || !order || !extents) return fail(fault, "its header is not numpy's");
  is_record = *type == '[';
  if (!(is_record ? take_fields(&type, &record) : take_type(&type, &record, &record.fields[0]))) {
    return fail(fault, "a type of elements that cannot be read here");
  }
  count = parse_extents(extents, shape);
  if (is_record ? count != 1 : count != 2 && (count != 3 || (kind >= 0 && !has_vertices(kind)))) {
    return fail(fault, "not an array of %s", is_record ? "records in one row" : "two dimensions");
  }
  is_path = count == 3 || has_vertices(kind);
  if (is_path) {
    kind = VESICA_POINT;
    columns = NULL;
  }
  header->rows = shape[0];
  header->each = 0;
  if (count == 3 && !spread_positions(shape, header, fault)) return 0;
  if (!is_record && *order == 'T') return fail(fault, "its columns lie one after the other: save it row by row");
  return is_record ? locate_in_record(&record, columns, kind, header, fault)
                   : locate_in_row(&record.fields[0], shape[count - 1], columns, kind, header, fault);
}
