// SPDX-License-Identifier: Apache-2.0
/// A file of shapes: lines of text, GeoJSON, or arrays of numpy's.
#ifndef SOURCE_H
#define SOURCE_H

#include <stdio.h>

#include "npy_header.h"
#include "shapes.h"

enum { any_kind = -1, most_complaints = 20, record_separator = 0x1e };

struct source {
  char* path;
  char name;     ///< A or B, as complaints call its shapes
  int32_t kind;  ///< of all shapes, or any_kind where lines and fields tell
  FILE* file;
  int64_t bytes;   ///< of the file, or 0 where it has no length
  int64_t faults;  ///< bad shapes; the first most_complaints are named on standard error
  struct shapes shapes;
  struct vertices vertices;  ///< the vertices of the shape that is being read
};

/// Reads the file at source->path. Returns 1, or 0 after saying why it cannot be used: what is not a shape is not a
/// reason, but counted.
int read_source(struct source* source);

/// For readers: the next shape, at that line or row ("shapes.csv:3"), or the reason why it is none. If it has vertices,
/// they are in source->vertices. Returns 1, or 0 where memory is short, which is said.
int take_shape(struct source* source, const char* where, const struct shape* shape, const struct fault* fault);

/// For readers: is it valid? Vertices are in source->vertices. Returns 1, or 0 with the reason in `fault`.
int is_valid(const struct source* source, const struct shape* shape, struct fault* fault);

/// For readers: says why the file cannot be used, and returns 0.
int refuse_source(const struct source* source, const char* reason);

/// For readers: how far the file has been read, on a terminal.
void show_reading(const struct source* source);

/// Reads shapes from text; read_source calls it.
int read_text(struct source* source);

/// Reads shapes from an array of numpy's; read_source calls it. `offsets` is NULL, or paths of offsets between commas:
/// where rings begin among the vertices and, if there is a second array, where shapes begin among the rings, and so on.
/// Then the shapes are polygons, or polylines if source->kind says so.
int read_npy(struct source* source, char* offsets);

/// The rows that follow that header are vertices; read_npy calls it.
int read_paths(struct source* source, const struct npy_header* header, char* offsets);

/// Reads geometries from GeoJSON; read_source calls it.
int read_geojson(struct source* source);

#endif
