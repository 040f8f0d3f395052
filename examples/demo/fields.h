// SPDX-License-Identifier: Apache-2.0
/// The pieces a scene line is made of. Functions that take a `fault` return 1, or 0 with the reason in it.
#ifndef FIELDS_H
#define FIELDS_H

#include "scene.h"

/// Writes a reason into `fault` in the manner of printf and returns 0. Whatever is not printable becomes '?'.
int fail(struct fault* fault, const char* format, ...);

/// Cuts off and returns the text before the next `separator`, without spaces around it; NULL when `*rest` is NULL.
/// `*rest` becomes what follows the separator, or NULL when there was none.
char* take_field(char** rest, char separator);

/// Cuts off and returns the next word between spaces, tabs and commas; NULL at the end.
char* take_word(char** rest);

/// The kind of that name, or VESICA_E_KIND.
int32_t find_kind(const char* name);

/// A number in decimal or hexadecimal, all of the text. `name` is what to call it in the reason.
int parse_number(const char* text, const char* name, double* out, struct fault* fault);

/// The numbers of a shape whose kind is known, in words. `name` is A or B.
int parse_numbers(char** rest, char name, struct shape* shape, struct fault* fault);

/// A kind, which may be NULL at the end of a line, and its numbers in words.
int parse_shape(const char* kind, char** rest, char name, struct shape* shape, struct fault* fault);

/// The known answer to pair->query, which is a number, and 0 or 1 where the query is a yes-no one.
int parse_known(const char* text, struct pair* pair, struct fault* fault);

/// Asks the library whether the shape is valid. `name` is A or B.
int check_shape(const struct shape* shape, char name, struct fault* fault);

#endif
