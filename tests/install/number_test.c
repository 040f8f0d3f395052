// SPDX-License-Identifier: Apache-2.0
/// parse_decimal beside strtod: the same bits and the same end, for random decimals, for midpoints of two doubles, and
/// for random marks.
#include "number.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state = 88172645463325252u;
static int failures;

static uint64_t draw(void) {
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return state;
}

static int below(int limit) { return (int)(draw() % (uint64_t)limit); }

// A whole number of any length.
static unsigned long long whole(void) { return draw() >> below(64); }

static void check(const char* text) {
  double found, expected;
  char* expected_end;
  const char* const end = parse_decimal(text, &found);
  expected = strtod(text, &expected_end);
  if (end == expected_end && memcmp(&found, &expected, sizeof found) == 0) return;
  printf("'%s' is %.17g up to %d and should be %.17g up to %d\n", text, found, (int)(end - text), expected,
         (int)(expected_end - text));
  failures++;
}

static void check_random(void) {
  static const char marks[] = "0123456789.eE+-xX 00,)0\t\n";
  static const char* const quarters[] = {".00", ".25", ".5", ".75"};
  // A number of 54 bits whose last is 1 is the midpoint of two doubles.
  const unsigned long long midpoint = (draw() >> 10 | (uint64_t)1 << 53) | 1;
  const uint64_t bits = draw();
  char text[512];
  double any;
  int length = 0;
  memcpy(&any, &bits, sizeof any);
  switch (below(7)) {
    case 0:
      snprintf(text, sizeof text, "%.*g", 1 + below(18), any);
      break;
    case 1:
      snprintf(text, sizeof text, "%s%llu.%llu", below(2) ? "-" : "", whole(), whole());
      break;
    case 2:
      snprintf(text, sizeof text, "%llue%d", whole(), below(64) - 32);
      break;
    case 3:
      snprintf(text, sizeof text, "%llu", midpoint);
      break;
    case 4:
      snprintf(text, sizeof text, "%llu%s", midpoint / 4, quarters[midpoint % 4]);
      break;
    case 5:  // beside a midpoint, above and below
      snprintf(text, sizeof text, "%llu.%s", midpoint, below(2) ? "01" : "00");
      if (below(2)) snprintf(text, sizeof text, "%llu.99", midpoint - 1);
      break;
    default:
      length = below(14);
      for (int i = 0; i < length; i++) text[i] = marks[below(sizeof marks - 1)];
      text[length] = '\0';
  }
  check(text);
}

int main(void) {
  static const char* const cases[] = {"",
                                      "-",
                                      "+",
                                      ".",
                                      "+-1",
                                      " 1",
                                      "\t1",
                                      " ,1",
                                      "1.",
                                      "-.5",
                                      ".e1",
                                      "1e",
                                      "1e+",
                                      "0x10",
                                      "0x",
                                      "1e5x",
                                      "0e99999999999",
                                      "1e-400",
                                      "1e400",
                                      "infinity",
                                      "-inf",
                                      "i",
                                      "1_000",
                                      "1,5",
                                      "9007199254740993",
                                      "9007199254740992.5",
                                      "9007199254740993.0000000000",
                                      "9223372036854775807",
                                      "9999999999999999999",
                                      "18446744073709551615",
                                      "18446744073709551616",
                                      "99999999999999999999",
                                      "0.000000000000000000000000000001",
                                      "00000000000000000000000000000001",
                                      "1e27",
                                      "1e28",
                                      "1e-27",
                                      "1e-28",
                                      "-0",
                                      "-0.0e5",
                                      "7450580596923828125e-27",
                                      "9007199254740993e-22",
                                      "4503599627370497.5",
                                      "2.2250738585072011e-308",
                                      "0.1",
                                      "123456789012345678e-17"};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) check(cases[i]);
  for (int i = 0; i < 1000000; i++) check_random();
  return failures != 0;
}
