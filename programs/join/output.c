// SPDX-License-Identifier: Apache-2.0
#include "output.h"

#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

enum { number_room = 32, written_at_once = 1 << 18, most_bytes = 1 << 26 };

int begin_parts(struct output* output, int64_t parts) {
  output->next = 0;
  output->parts = parts;
  output->held = 0;
  output->done = calloc((size_t)parts, sizeof *output->done);
  return output->done && pthread_mutex_init(&output->lock, NULL) == 0 && pthread_cond_init(&output->turn, NULL) == 0;
}

// Not before the first row: a join that fails writes nothing.
static void write_header(struct output* output) {
  if (output->header && fputs(output->header, output->file) < 0) output->failed = 1;
  output->header = NULL;
}

void end_parts(struct output* output) {
  for (int64_t i = 0; output->done && i < output->parts; i++) free(output->done[i].at);
  free(output->done);
  write_header(output);
}

static void write_bytes(struct output* output, struct bytes* bytes) {
  if (bytes->count == 0) return;
  write_header(output);
  if (fwrite(bytes->at, 1, bytes->count, output->file) != bytes->count) output->failed = 1;
  bytes->count = 0;
}

static void await_turn(struct output* output, int64_t part) {
  while (output->next != part && !output->failed) pthread_cond_wait(&output->turn, &output->lock);
}

// Writes what a part has, if it is its turn, or waits for it where that is much.
static int write_some(struct output* output, int64_t part, struct bytes* bytes) {
  int good;
  pthread_mutex_lock(&output->lock);
  if (bytes->count > most_bytes) await_turn(output, part);
  if (output->next == part && !output->failed) write_bytes(output, bytes);
  good = !output->failed;
  pthread_mutex_unlock(&output->lock);
  return good;
}

void end_part(struct output* output, int64_t part, struct bytes* bytes) {
  pthread_mutex_lock(&output->lock);
  if (output->held > most_bytes) await_turn(output, part);
  output->done[part] = *bytes;
  output->done[part].ended = 1;
  output->held += bytes->count;
  if (output->next == part) {
    do {
      struct bytes* const done = &output->done[output->next];
      output->held -= done->count;
      if (!output->failed) write_bytes(output, done);
      free(done->at);
      done->at = NULL;
      output->next++;
    } while (output->next < output->parts && output->done[output->next].ended);
  }
  pthread_cond_broadcast(&output->turn);
  pthread_mutex_unlock(&output->lock);
}

// ---- Rows ----

static int make_room(struct bytes* bytes, size_t more) {
  const size_t room = 2 * bytes->room > bytes->count + more ? 2 * bytes->room : bytes->count + more + 4096;
  char* const grown = realloc(bytes->at, room);
  if (!grown) return 0;
  bytes->at = grown;
  bytes->room = room;
  return 1;
}

static char* put_integer(char* out, int64_t number) {
  char digits[number_room], *at = digits + number_room;
  do {
    *--at = (char)('0' + number % 10);
    number /= 10;
  } while (number > 0);
  memcpy(out, at, (size_t)(digits + number_room - at));
  return out + (digits + number_room - at);
}

// With the digits, 15 to 17, that give the same bits back.
static char* put_distance(char* out, double distance) {
  int length = 0;
  for (int digits = 15; digits <= 17; digits++) {
    length = snprintf(out, number_room, "%.*g", digits, distance);
    if (strtod(out, NULL) == distance) break;
  }
  return out + length;
}

static int is_special(char c) { return c == '"' || c == ',' || c == '\n' || c == '\r'; }

static char* put_id(char* out, const struct id* id) {
  int64_t plain = 0;
  while (plain < id->length && !is_special(id->at[plain])) plain++;
  if (plain == id->length) {
    memcpy(out, id->at, (size_t)plain);
    return out + plain;
  }
  *out++ = '"';
  for (int64_t i = 0; i < id->length; i++) {
    if (id->at[i] == '"') *out++ = '"';
    *out++ = id->at[i];
  }
  *out++ = '"';
  return out;
}

static size_t room_of(const struct id* id) { return 2 * (size_t)id->length + 2; }

static char* put_shape(const struct output* output, char* out, int side, int64_t number) {
  const struct id* const ids = output->ids[side];
  return ids ? put_id(out, &ids[number]) : put_integer(out, number);
}

static char* put_text_row(const struct output* output, char* out, int64_t a, int64_t b, const double* distance) {
  out = put_shape(output, out, 0, a);
  *out++ = ',';
  out = put_shape(output, out, 1, b);
  if (distance) {
    *out++ = ',';
    out = put_distance(out, *distance);
  }
  *out++ = '\n';
  return out;
}

static char* put_binary_row(char* out, int64_t a, int64_t b, const double* distance) {
  memcpy(out, &a, sizeof a);
  memcpy(out + sizeof a, &b, sizeof b);
  out += 2 * sizeof a;
  if (!distance) return out;
  memcpy(out, distance, sizeof *distance);
  return out + sizeof *distance;
}

int put_row(struct output* output, int64_t part, struct bytes* bytes, int64_t a, int64_t b, const double* distance) {
  size_t most = 3 * number_room;
  char* out;
  if (output->ids[0]) most += room_of(&output->ids[0][a]);
  if (output->ids[1]) most += room_of(&output->ids[1][b]);
  if (bytes->room - bytes->count < most && !make_room(bytes, most)) {
    pthread_mutex_lock(&output->lock);
    output->failed = 1;
    pthread_mutex_unlock(&output->lock);
    return 0;
  }
  out = bytes->at + bytes->count;
  out = output->binary ? put_binary_row(out, a, b, distance) : put_text_row(output, out, a, b, distance);
  bytes->count = (size_t)(out - bytes->at);
  return bytes->count < written_at_once || write_some(output, part, bytes);
}
