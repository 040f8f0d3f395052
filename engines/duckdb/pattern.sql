-- SPDX-License-Identifier: Apache-2.0
-- All pairs of two tables (id, shape) that overlap, by DuckDB's own hash join: it uses all threads, and disk where memory
-- is short. Each shape is listed for the cells of a grid that its bounds meet; shapes of a common cell are candidates, and
-- vs_overlap decides. A pair with several common cells is taken in the lowest of them alone. `size` is the side of a
-- cell: two to four times that of most shapes. A shape is listed for each cell that it meets, so giants want a coarser
-- grid.
CREATE MACRO vs_cells(source, size) AS TABLE
  SELECT id, shape, x0, y0, x, unnest(range(y0, y1 + 1)) AS y
  FROM (SELECT id, shape, x0, y0, y1, unnest(range(x0, x1 + 1)) AS x
        FROM (SELECT id, shape,
                floor(vs_min_x(shape) / size)::BIGINT AS x0, floor(vs_max_x(shape) / size)::BIGINT AS x1,
                floor(vs_min_y(shape) / size)::BIGINT AS y0, floor(vs_max_y(shape) / size)::BIGINT AS y1
              FROM query_table(source) WHERE shape IS NOT NULL));

CREATE MACRO vs_join(source_a, source_b, size) AS TABLE
  SELECT a.id AS a, b.id AS b
  FROM vs_cells(source_a, size) AS a JOIN vs_cells(source_b, size) AS b ON a.x = b.x AND a.y = b.y
  WHERE a.x = greatest(a.x0, b.x0) AND a.y = greatest(a.y0, b.y0) AND vs_overlap(a.shape, b.shape);
