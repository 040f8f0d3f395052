// SPDX-License-Identifier: Apache-2.0
/// Numbers in text, as strtod reads them and in less than half the time.
#ifndef NUMBER_H
#define NUMBER_H

/// Reads a number: the value and the end are those of strtod, bit for bit. Returns the end, or `text` where no number
/// begins. Numbers of more than 19 digits, hexadecimal ones, and exponents beyond 27 are left to strtod, which follows
/// the locale.
const char* parse_decimal(const char* text, double* out);

#endif
