-- SPDX-License-Identifier: Apache-2.0
\echo Use "CREATE EXTENSION vesica" to load this file. \quit

-- ---- Type ----
CREATE TYPE vshape;

CREATE FUNCTION vshape_in(cstring) RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vshape_out(vshape) RETURNS cstring LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vshape_recv(internal) RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vshape_send(vshape) RETURNS bytea LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';

CREATE TYPE vshape (
  INTERNALLENGTH = VARIABLE,
  ALIGNMENT = int4,
  STORAGE = extended,
  INPUT = vshape_in,
  OUTPUT = vshape_out,
  RECEIVE = vshape_recv,
  SEND = vshape_send
);

CREATE FUNCTION vs_from_wkb(bytea) RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_valid(text) RETURNS bool LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
COMMENT ON FUNCTION vs_valid(text) IS 'are these the words of a valid shape?';

-- ---- Constructors ----
CREATE FUNCTION vs_point(x float8, y float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_segment(x0 float8, y0 float8, x1 float8, y1 float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_circle(cx float8, cy float8, r float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_aabb(min_x float8, min_y float8, max_x float8, max_y float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_rect(cx float8, cy float8, ux float8, uy float8, hx float8, hy float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_ellipse(cx float8, cy float8, ux float8, uy float8, a float8, b float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_capsule(x0 float8, y0 float8, x1 float8, y1 float8, r float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_round_rect(cx float8, cy float8, ux float8, uy float8, hx float8, hy float8, r float8)
  RETURNS vshape LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';

-- ---- Questions ----
CREATE FUNCTION vs_overlap(vshape, vshape)
  RETURNS bool LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 5 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_contains(vshape, vshape)
  RETURNS bool LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 10 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_inside(vshape, vshape)
  RETURNS bool LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 10 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_distance(vshape, vshape)
  RETURNS float8 LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_relation(vshape, vshape)
  RETURNS text LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 10 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_area(vshape)
  RETURNS float8 LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME', 'vs_shape_area';
CREATE FUNCTION vs_area(vshape, vshape)
  RETURNS float8 LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_iou(vshape, vshape)
  RETURNS float8 LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE COST 20 AS 'MODULE_PATHNAME';
CREATE FUNCTION vs_bounds(vshape)
  RETURNS box LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';

CREATE OPERATOR && (LEFTARG = vshape, RIGHTARG = vshape, FUNCTION = vs_overlap, COMMUTATOR = &&,
  RESTRICT = areasel, JOIN = areajoinsel);
CREATE OPERATOR @> (LEFTARG = vshape, RIGHTARG = vshape, FUNCTION = vs_contains, COMMUTATOR = <@,
  RESTRICT = contsel, JOIN = contjoinsel);
CREATE OPERATOR <@ (LEFTARG = vshape, RIGHTARG = vshape, FUNCTION = vs_inside, COMMUTATOR = @>,
  RESTRICT = contsel, JOIN = contjoinsel);
CREATE OPERATOR <-> (LEFTARG = vshape, RIGHTARG = vshape, FUNCTION = vs_distance, COMMUTATOR = <->);

-- ---- Index: keys are boxes, so the server's own functions on boxes split and join pages ----
CREATE FUNCTION vshape_gist_consistent(internal, vshape, smallint, oid, internal)
  RETURNS bool LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vshape_gist_compress(internal)
  RETURNS internal LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';
CREATE FUNCTION vshape_gist_distance(internal, vshape, smallint, oid, internal)
  RETURNS float8 LANGUAGE C STRICT IMMUTABLE PARALLEL SAFE AS 'MODULE_PATHNAME';

CREATE OPERATOR CLASS vshape_ops DEFAULT FOR TYPE vshape USING gist AS
  OPERATOR 3 &&,
  OPERATOR 7 @>,
  OPERATOR 8 <@,
  OPERATOR 15 <-> FOR ORDER BY float_ops,
  FUNCTION 1 vshape_gist_consistent(internal, vshape, smallint, oid, internal),
  FUNCTION 2 gist_box_union(internal, internal),
  FUNCTION 3 vshape_gist_compress(internal),
  FUNCTION 5 gist_box_penalty(internal, internal, internal),
  FUNCTION 6 gist_box_picksplit(internal, internal),
  FUNCTION 7 gist_box_same(box, box, internal),
  FUNCTION 8 vshape_gist_distance(internal, vshape, smallint, oid, internal),
  STORAGE box;

-- ---- Join ----
-- Rows by their ctid, each pair once; of one table with itself, pairs of two different rows.
CREATE FUNCTION vesica_join(a regclass, b regclass) RETURNS TABLE (a tid, b tid)
  LANGUAGE C STRICT STABLE PARALLEL UNSAFE COST 1000000 ROWS 100000 AS 'MODULE_PATHNAME';
