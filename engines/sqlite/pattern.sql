-- SPDX-License-Identifier: Apache-2.0
-- Two tables of shapes with an R*Tree beside each, which triggers keep right. Sides of vs_min_x and the like are floats
-- rounded outward, as the R*Tree keeps them: no candidate is lost.
CREATE TABLE a (id INTEGER PRIMARY KEY, shape BLOB CHECK (vs_valid(shape)));
CREATE TABLE b (id INTEGER PRIMARY KEY, shape BLOB CHECK (vs_valid(shape)));

CREATE VIRTUAL TABLE a_bounds USING rtree (id, min_x, max_x, min_y, max_y);

CREATE TRIGGER a_inserted AFTER INSERT ON a WHEN new.shape IS NOT NULL BEGIN
  INSERT INTO a_bounds VALUES
    (new.id, vs_min_x(new.shape), vs_max_x(new.shape), vs_min_y(new.shape), vs_max_y(new.shape));
END;
CREATE TRIGGER a_deleted AFTER DELETE ON a BEGIN
  DELETE FROM a_bounds WHERE id = old.id;
END;
CREATE TRIGGER a_updated AFTER UPDATE ON a BEGIN
  DELETE FROM a_bounds WHERE id = old.id;
  INSERT INTO a_bounds
    SELECT new.id, vs_min_x(new.shape), vs_max_x(new.shape), vs_min_y(new.shape), vs_max_y(new.shape)
    WHERE new.shape IS NOT NULL;
END;

-- Candidates by the R*Tree, each asked exactly. CROSS JOIN keeps the order: b outside, the tree of a inside.
CREATE VIEW overlaps AS
  SELECT a.id AS a, b.id AS b
  FROM b CROSS JOIN a_bounds AS r CROSS JOIN a
  WHERE r.min_x <= vs_max_x(b.shape) AND r.max_x >= vs_min_x(b.shape)
    AND r.min_y <= vs_max_y(b.shape) AND r.max_y >= vs_min_y(b.shape)
    AND a.id = r.id AND vs_overlap(a.shape, b.shape);
