// SPDX-License-Identifier: Apache-2.0
/// A file of shapes: a table, lines of shapes, GeoJSON, or arrays of numpy's.
#ifndef SOURCE_H
#define SOURCE_H

#include <stdio.h>

#include "npy_header.h"
#include "shapes.h"
#include "text.h"

enum { any_kind = -1, most_complaints = 20, record_separator = 0x1e };

struct source {
  char* path;           ///< or "-"
  char name;            ///< A or B, as complaints call its shapes
  int32_t kind;         ///< of all shapes, or any_kind where lines and fields tell
  const char* columns;  ///< --shape, or NULL
  const char* id_name;  ///< --id, or NULL
  char delimiter;       ///< between the fields of a table, or 0
  int threads;          ///< to read with
  FILE* file;
  char* offsets;     ///< the paths of offsets behind that of an array, or NULL
  struct text text;  ///< of files of text; later only with ids, which lie in it
  int64_t bytes;     ///< of the file, or 0 where it has no length
  int64_t faults;    ///< bad shapes; the first most_complaints are named on standard error
  struct shapes shapes;
  struct vertices vertices;  ///< the vertices of the shape that is being read
};

/// Opens the file at source->path. Returns 1, or 0 after saying why it cannot be read.
int open_source(struct source* source);

/// Reads the open file. Returns 1, or 0 after saying why it cannot be used: what is not a shape is not a reason, but
/// counted.
int read_source(struct source* source);

/// For readers: the next shape, whose vertices are in source->vertices, or NULL for one that is bad or empty. Returns
/// 1, or 0 where memory is short, which is said.
int take_shape(struct source* source, const struct shape* shape);

/// For readers: counts a bad shape, and says where in the file it is, in the manner of printf, and why it is bad.
__attribute__((format(printf, 3, 4))) void complain_of_shape(struct source* source, const struct fault* fault,
                                                             const char* where, ...);

/// The path as messages have it.
const char* shown_path(const struct source* source);

/// For readers: says why the file cannot be used, and returns 0.
int refuse_source(const struct source* source, const char* reason);

/// For readers: how far a file that is read from its begin to its end has been read, on a terminal.
void show_reading(const struct source* source, int64_t bytes);

/// Reads lines of shapes.
int read_lines(struct source* source);

/// Reads a table with names in its first line, or lines of shapes if its names are those of no shape.
int read_table(struct source* source);

/// Reads geometries from GeoJSON.
int read_geojson(struct source* source);

/// Reads shapes from an array of numpy's. `offsets` is NULL, or paths of offsets between commas: where rings begin
/// among the vertices and, if there is a second array, where shapes begin among the rings, and so on. Then the shapes
/// are polygons, or polylines if source->kind says so.
int read_npy(struct source* source, char* offsets);

/// The rows that follow that header are vertices; read_npy calls it.
int read_paths(struct source* source, const struct npy_header* header, char* offsets);

#endif
