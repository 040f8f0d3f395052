// SPDX-License-Identifier: Apache-2.0
#include "number.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifdef __SIZEOF_INT128__

__extension__ typedef unsigned __int128 wide;

// 19 digits fit into 64 bits, and so does 5^27.
enum { most_digits = 19, most_power = 27 };

struct decimal {
  uint64_t digits;
  int exponent;  // of 10
  int negative;
};

static int is_digit(char c) { return c >= '0' && c <= '9'; }

static const char* take_digits(const char* at, struct decimal* d, int* count) {
  for (; is_digit(*at); at++) {
    d->digits = 10 * d->digits + (uint64_t)(*at - '0');
    *count += *count > 0 || *at != '0';
  }
  return at;
}

static const char* take_exponent(const char* at, struct decimal* d) {
  const int negative = *at == '-';
  int exponent = 0;
  if (*at == '-' || *at == '+') at++;
  if (!is_digit(*at)) return NULL;
  for (; is_digit(*at); at++) {
    if (exponent < 1000) exponent = 10 * exponent + (*at - '0');
  }
  d->exponent += negative ? -exponent : exponent;
  return at;
}

// Returns the end, or NULL for what is left to strtod.
static const char* take_decimal(const char* at, struct decimal* d) {
  const char* begin;
  int count = 0;
  d->digits = 0;
  d->exponent = 0;
  d->negative = *at == '-';
  if (*at == '-' || *at == '+') at++;
  begin = at;
  at = take_digits(at, d, &count);
  if (at - begin > most_power) return NULL;  // so many zeros too
  if (*at == '.') {
    const char* const point = at++;
    at = take_digits(at, d, &count);
    if (at - point > 2 * most_power) return NULL;
    d->exponent = (int)(point + 1 - at);
    begin++;  // a point alone is no number
  }
  if (at == begin || count > most_digits || *at == 'x' || *at == 'X') return NULL;
  if (*at == 'e' || *at == 'E') at = take_exponent(at + 1, d);
  return at && d->exponent >= -most_power && d->exponent <= most_power ? at : NULL;
}

static uint64_t power_of_5(int power) {
  uint64_t result = 1, square = 5;
  for (; power > 0; power /= 2, square *= square) {
    if (power % 2) result *= square;
  }
  return result;
}

// m 2^e, rounded to nearest; bit 0 of m may stand for anything below it. m is at least 2^62.
static double round_once(uint64_t m, int e, int negative) {
  uint64_t bits, rest;
  double result;
  if (!(m >> 63)) {
    m <<= 1;
    e--;
  }
  bits = m >> 11;
  rest = m & 0x7ff;
  bits += rest > 0x400 || (rest == 0x400 && bits & 1);
  // The leading bit adds 1 to the exponent, and so does a carry.
  bits += (uint64_t)(e + 11 + 52 + 1022) << 52;
  bits |= (uint64_t)negative << 63;
  memcpy(&result, &bits, sizeof result);
  return result;
}

// The quotient or the product in 64 bits; what lies below them is in bit 0.
static double to_double(const struct decimal* d) {
  const int shift = __builtin_clzll(d->digits);
  const uint64_t digits = d->digits << shift;
  const uint64_t power = power_of_5(abs(d->exponent));
  const int power_shift = __builtin_clzll(power);
  const uint64_t divisor = power << power_shift;
  uint64_t m;
  if (d->exponent < 0) {
    const wide dividend = (wide)digits << 63;
    m = (uint64_t)(dividend / divisor);
    m |= m * (wide)divisor != dividend;
    return round_once(m, d->exponent + power_shift - shift - 63, d->negative);
  } else {
    const wide product = (wide)digits * divisor;
    m = (uint64_t)(product >> 64);
    m |= (uint64_t)product != 0;
    return round_once(m, d->exponent - power_shift - shift + 64, d->negative);
  }
}

const char* parse_decimal(const char* text, double* out) {
  struct decimal d;
  char* end;
  const char* at = text;
  while (*at == ' ' || (*at >= '\t' && *at <= '\r')) at++;
  if (*at == ',' || *at == ')' || !*at) {
    *out = 0;
    return text;
  }
  at = take_decimal(at, &d);
  if (at) {
    *out = d.digits > 0 ? to_double(&d) : d.negative ? -0.0 : 0.0;
    return at;
  }
  *out = strtod(text, &end);
  return end;
}

#else

const char* parse_decimal(const char* text, double* out) {
  char* end;
  *out = strtod(text, &end);
  return end;
}

#endif
