-- What users see: answers, plans, errors. expected/vesica.out is what psql prints.
CREATE EXTENSION vesica;

-- ---- Words that keep every bit ----
SELECT 'rect 0 0 0.8 0.6 2 1'::vshape, vs_circle(2, 1, 0.5), vs_point(0.1, '-0');
SELECT 'ellipse 0.1,1e-300 4.94065645841247e-324 1.7976931348623157e308 0.30000000000000004 0'::vshape;
SELECT vshape_send('point 1 -0');
SELECT vs_round_rect(0, 0, 1, 0, 1, 2, 0.5), 'round_rect 0 0 1 0 1 2 0.5' && 'point 1.5 0'::vshape AS touching,
  vs_capsule(0, 0, 1, 0, 0.5) <-> 'point 2 0' AS distance;

-- ---- Questions ----
SELECT vs_overlap('circle 0 0 1', 'circle 2 0 1') AS touching, 'circle 0 0 1' && 'circle 2.0000000000000004 0 1'::vshape AS apart,
  'circle 0 0 1' @> 'point 1 0'::vshape AS holds, 'point 1 0' <@ 'circle 0 0 1'::vshape AS is_in,
  vs_relation('circle 0 0 1', 'circle 0 0 2'), 'point 0 0' <-> 'point 3 4'::vshape AS distance;
SELECT vs_area('aabb 0 0 2 2'), vs_area('aabb 0 0 2 2', 'aabb 1 1 3 3') AS shared, vs_iou('aabb 0 0 2 2', 'aabb 1 0 2 2'),
  vs_iou('point 0 0', 'point 0 0') IS NULL AS no_area, vs_bounds('circle 0 0 1');

-- ---- NULL ----
SELECT vs_overlap(NULL, 'point 0 0') IS NULL AS a, (NULL::vshape <-> 'point 0 0') IS NULL AS b, vs_valid(NULL) IS NULL AS c;

-- ---- Bad input ----
\set VERBOSITY sqlstate
SELECT 'circle nan 0 1'::vshape;
SELECT vs_circle(0, 'NaN', 1);
SELECT 'point -1e308 0' <-> 'point 1e308 0'::vshape;
\set VERBOSITY default
SELECT 'circle nan 0 1'::vshape;
SELECT 'circle 0 0 -1'::vshape;
SELECT 'rect 0 0 0 0 1 1'::vshape;
SELECT 'aabb 1 0 0 0'::vshape;
SELECT 'round_rect 0 0 1 0 1 2'::vshape;
SELECT 'square 1 2'::vshape;
SELECT ''::vshape;
SELECT 'point 1'::vshape;
SELECT 'point 1 2x'::vshape;
SELECT 'point 1 2 3'::vshape;
SELECT vs_circle(0, 'NaN', 1);
SELECT vs_ellipse(0, 0, 0, 0, 1, 1);
SELECT 'point -1e308 0' <-> 'point 1e308 0'::vshape;
SELECT vs_area('circle 0 0 1e200');

-- ---- Good rows among bad ones ----
CREATE TABLE words (id int, line text);
INSERT INTO words VALUES (0, 'point 1 2'), (1, 'point nan 2'), (2, NULL), (3, 'point 3 4'), (4, 'nothing');
SELECT id, CASE WHEN vs_valid(line) THEN line::vshape END AS shape FROM words ORDER BY id;

-- ---- Plans ----
CREATE TABLE a (id int, shape vshape);
INSERT INTO a SELECT i, vs_circle(i % 100, i / 100, 0.3) FROM generate_series(0, 9999) i;
INSERT INTO a VALUES (-1, NULL);
CREATE INDEX ON a USING gist (shape);
ANALYZE a;
EXPLAIN (COSTS OFF) SELECT * FROM a x JOIN a y ON x.shape && y.shape;
EXPLAIN (COSTS OFF) SELECT id FROM a WHERE shape <@ 'aabb 0 0 2 1';
EXPLAIN (COSTS OFF) SELECT id FROM a ORDER BY shape <-> 'point 5.2 7.1' LIMIT 3;
SELECT id FROM a WHERE shape <@ 'aabb -0.3 -1 2.3 1' ORDER BY id;
SELECT id FROM a WHERE shape @> 'segment 5 7 5.3 7';
SELECT id, shape <-> 'point 5.5 7' AS distance FROM a WHERE shape IS NOT NULL ORDER BY shape <-> 'point 5.5 7', id LIMIT 3;

-- ---- Join ----
CREATE TABLE b (id int, "the shape" vshape);
INSERT INTO b VALUES (0, 'segment 0 0 2 0'), (1, NULL), (2, 'point 3.3 4');
SELECT a.id, b.id FROM vesica_join('a', 'b') j JOIN a ON a.ctid = j.a JOIN b ON b.ctid = j.b ORDER BY 1, 2;
SELECT count(*) FROM vesica_join('a', 'a');
SELECT * FROM vesica_join('a', NULL);
SELECT * FROM vesica_join('a', 'words');
CREATE TABLE two (x vshape, y vshape);
SELECT * FROM vesica_join('two', 'a');
CREATE VIEW seen AS SELECT * FROM a;
SELECT * FROM vesica_join('seen', 'a');
CREATE TABLE nothing (shape vshape);
SELECT count(*) FROM vesica_join('nothing', 'a');
CREATE MATERIALIZED VIEW kept AS SELECT * FROM b;
SELECT count(*) FROM vesica_join('a', 'kept');
BEGIN;
INSERT INTO nothing VALUES ('circle 0 0 1');
SELECT count(*) FROM vesica_join('nothing', 'a');
ROLLBACK;

-- ---- Polygons and lines, in well-known text, of any length ----
CREATE TABLE zones (id int, shape vshape);
INSERT INTO zones VALUES (0, 'POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))'),
  (1, 'MULTIPOLYGON (((20 0, 21 0, 20 1, 20 0)), ((3 3, 5 3, 4 5, 3 3)))'), (2, 'LINESTRING (0 -1, 4 -1, 4 0.1)'),
  (3, 'MULTILINESTRING ((9 9, 9 10), (11 11, 12 12, 13 11))'), (4, 'MULTIPOINT (1 2, 3 4)'), (5, 'LINESTRING (0 0, 1 1)'),
  (6, 'POLYGON ((0 0, 0 3, 2 3, 2 0, 0 0))'), (7, 'POINT (4 4)');
INSERT INTO zones SELECT 8, ('POLYGON ((' || string_agg(format('%s %s', i, 100 + i % 2), ', ' ORDER BY i) || ', 5000 200, 1 200))')::vshape
  FROM generate_series(1, 5000) i;
SELECT id, shape FROM zones WHERE id < 8;
SELECT md5(shape::text), vs_bounds(shape), vs_area(shape) FROM zones WHERE id = 8;
SELECT z.id, z.shape::text::vshape && z.shape AS same, z.shape && 'point 4 4' AS at_four, z.shape <-> 'circle 4 4 1' AS distance,
  vs_relation(z.shape, 'circle 4 4 1') FROM zones z;
CREATE INDEX ON zones USING gist (shape);
SET enable_seqscan = off;
SELECT x.id, y.id FROM zones x JOIN zones y ON x.shape && y.shape AND x.id < y.id ORDER BY 1, 2;
SELECT x.id, y.id FROM vesica_join('zones', 'zones') j JOIN zones x ON x.ctid = j.a JOIN zones y ON y.ctid = j.b ORDER BY 1, 2;
SELECT id FROM zones WHERE shape @> 'point 3000 150' OR shape <@ 'aabb 0 0 3 4' ORDER BY id;
SET enable_seqscan = on;
SELECT vshape_send('LINESTRING (0 1, 2 3, 4 5)');
SELECT 'POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))'::vshape;
SELECT 'POLYGON ((0 0, 2 nan, 2 0))'::vshape;
SELECT 'POLYGON ((0 0, 2 2, 2 0)'::vshape;
SELECT vs_from_wkb('\x0103000000020000000500000000000000000000000000000000000000000000000000204000000000000000000000000000002040000000000000204000000000000000000000000000002040000000000000000000000000000000000400000000000000000000400000000000000040000000000000184000000000000000400000000000001040000000000000184000000000000000400000000000000040'), vs_from_wkb('\x00a0000001000010e63ff000000000000040000000000000004022000000000000');
SELECT vs_from_wkb('\x0107');
SELECT 'CURVE (0 0, 2 2)'::vshape;
SELECT vs_valid('POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))'), vs_valid('POLYGON ((0 0, 2 2, 2 0))');
