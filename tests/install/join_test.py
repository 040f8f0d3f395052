# SPDX-License-Identifier: Apache-2.0
"""join_test.py PROGRAM: what vesica-join answers for files good and bad, in the folder it is called in."""
import contextlib
import csv
import ctypes
import json
import os
import pty
import random
import resource
import subprocess
import sys
import time

import numpy

FIELDS = {
    "point": ("x", "y"),
    "segment": ("x0", "y0", "x1", "y1"),
    "circle": ("cx", "cy", "r"),
    "aabb": ("min_x", "min_y", "max_x", "max_y"),
    "rect": ("cx", "cy", "ux", "uy", "hx", "hy"),
    "ellipse": ("cx", "cy", "ux", "uy", "a", "b"),
    "capsule": ("x0", "y0", "x1", "y1", "r"),
    "round_rect": ("cx", "cy", "ux", "uy", "hx", "hy", "r"),
}
KINDS = tuple(FIELDS)
library = ctypes.CDLL("libvesica.so.0")
HEADER = "a_from_0,b_from_0"
failures = 0


def check(what, expected, found):
    global failures
    if found != expected:
        print(f"{what} is\n{found}\nand should be\n{expected}")
        failures += 1


def run(*arguments, memory=None):
    """Exit status, standard output and standard error of a join."""
    limit = (lambda: resource.setrlimit(resource.RLIMIT_AS, (memory, memory))) if memory else None
    done = subprocess.run([sys.argv[1], *arguments], capture_output=True, text=True, preexec_fn=limit)
    return done.returncode, done.stdout, done.stderr


def write(path, content):
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())
    return path


def pairs(what, *arguments):
    """The pairs of a join that goes well."""
    status, out, err = run(*arguments)
    lines = out.splitlines()
    check(f"{what}: status and header", (0, HEADER), (status, lines[0] if lines else err))
    found = [tuple(map(int, line.split(","))) for line in lines[1:]]
    check(f"{what}: pairs that come twice", len(set(found)), len(found))
    check(f"{what}: pairs said", f"{len(found)} pairs", err.split("; ")[0].split(", ")[-1])
    check(f"{what}: --count", (0, f"{len(found)}\n"), run("--count", *arguments)[:2])
    return sorted(found)


def refused(what, complaint, *arguments):
    """A join that goes wrong: nothing on standard output, this on standard error."""
    check(what, (2, "", complaint), run(*arguments))


# ---- All pairs ----------------------------------------------------------------------------------------------------
def draw(kind, rng, dtype="f8"):
    """A random shape whose numbers are short, so that many touch."""
    x, y, h, k = rng.randrange(40), rng.randrange(40), rng.randrange(5) / 2, rng.randrange(5) / 2
    ux, uy = rng.choice([(1, 0), (0, 1), (0.75, 0.5), (-1, 1)])
    numbers = {
        "point": (x, y),
        "segment": (x, y, x + h, y + k),
        "circle": (x, y, h),
        "aabb": (x, y, x + h, y + k),
        "rect": (x, y, ux, uy, h, k),
        "ellipse": (x, y, ux, uy, h, k),
        "capsule": (x, y, x + h, y + k, 0.5),
        "round_rect": (x, y, ux, uy, h, k, 0.25),
    }[kind]
    return kind, numbers


def all_pairs(a, b=None):
    def overlap(one, other):
        a, b = ((ctypes.c_double * len(numbers))(*numbers) for _, numbers in (one, other))
        answer = library.vesica_overlap_f64(KINDS.index(one[0]), a, KINDS.index(other[0]), b)
        assert answer in (0, 1), (one, other, answer)
        return answer == 1

    if b is None:
        return [(i, j) for i in range(len(a)) for j in range(i + 1, len(a)) if overlap(a[i], a[j])]
    return [(i, j) for i in range(len(a)) for j in range(len(b)) if overlap(a[i], b[j])]


def text(shapes, separator=" ", end="\n"):
    return "".join(separator.join((kind, *map(repr, numbers))) + end for kind, numbers in shapes)


rng = random.Random(1)
shapes_a = [draw(rng.choice(KINDS), rng) for _ in range(180)]
shapes_b = [draw(rng.choice(KINDS), rng) for _ in range(150)]
expected, expected_self = all_pairs(shapes_a, shapes_b), all_pairs(shapes_a)
a, b = write("a.txt", text(shapes_a)), write("b.txt", text(shapes_b))
check("mixed kinds", expected, pairs("mixed kinds", a, b))
check("of one file", expected_self, pairs("of one file", a))
c = write("c.csv", "kind,a0,a1\r\n# comment\r\n\r\n" + text(shapes_a, ",", " # comment\r\n").rstrip())
check("CR LF, commas, comments, names of columns, no last line end", expected, pairs("CR LF", c, b))
check(
    "byte order mark",
    expected,
    pairs("byte order mark", write("m.txt", b"\xef\xbb\xbf" + text(shapes_a).encode()), b),
)

# ---- Other questions ----------------------------------------------------------------------------------------------
nested = write("nested.txt", "point 1 1\ncircle 0 0 9\naabb -1 -1 2 2\npoint 1 1\ncircle 8 8 4\n")
check("--contains", [(0, 3), (1, 0), (1, 2), (1, 3), (2, 0), (2, 3), (3, 0)], pairs("--contains", "--contains", nested))
check("--inside", [(0, 1), (0, 2), (0, 3), (2, 1), (3, 0), (3, 1), (3, 2)], pairs("--inside", "--inside", nested))
point = write("point.txt", "point 1 1")
check("--contains of two", [(0, 0), (1, 0), (2, 0), (3, 0)], pairs("--contains of two", nested, point, "--contains"))
check("--inside of two", [(0, 0), (3, 0)], pairs("--inside of two", "--inside", nested, point))
touching = write("touching.txt", "aabb 0 0 1 1\naabb 1 0 2 1\naabb 0.5 0 1 1\n")
check("--interiors", [(0, 2)], pairs("--interiors", "--interiors", touching))
corner = write("corner.txt", "circle 0 0 1\npoint 0.9 0.9\n")
check("overlap beside a box", [], pairs("overlap beside a box", corner))
check("--bounds", [(0, 1)], pairs("--bounds", "--bounds", corner))

# ---- Well-known text, and numbers alone ---------------------------------------------------------------------------
known = "POINT (1 2)\nLINESTRING(0 0, 1e1 -5)\nPOLYGON ((0 0, 2 0, 2 3, 0 3, 0 0))\nPOLYGON((2 3,2 0,0 0,0 3,2 3))\n"
same = "point 1 2\nsegment 0 0 10 -5\naabb 0 0 2 3\naabb 0 0 2 3\n"
check("well-known text", pairs("in words", write("w.txt", same), b), pairs("as it is", write("k.txt", known), b))
zones = write(
    "zones.wkt",
    "POLYGON ((0 0, 8 0, 8 8, 0 8, 0 0), (2 2, 6 2, 6 6, 2 6, 2 2))\n"  # with a hole
    "MULTIPOLYGON (((20 0, 21 0, 20 1, 20 0)), ((3 3, 5 3, 4 5, 3 3)))\n"
    "LINESTRING (0 -1, 4 -1, 4 4)\n"
    "MULTILINESTRING ((9 9, 9 10), (11 11, 12 12, 13 11))\n",
)
spots = write("spots.txt", "point 1 1\npoint 4 3.5\npoint 2.5 2.5\npoint 20.25 0.25\ncircle 12 12 0.5\npoint 4 0\n")
known_spots = write("spots.wkt", "POINT (1 1)\nPOINT (4 3.5)\nPOINT (2.5 2.5)\nPOINT (20.25 0.25)\nPOINT (12 12)\nPOINT (4 0)\n")
of_zones = [(0, 0), (0, 5), (1, 1), (1, 3), (2, 1), (2, 5), (3, 4)]
check("zones", of_zones, pairs("zones", zones, spots))
check("zones among themselves", [(0, 2), (1, 2)], pairs("zones among themselves", zones))
coast = ", ".join(f"{i} {i % 2}" for i in range(20000))
long = write("long.wkt", f"POLYGON (({coast}, 19999 9, 0 9, 0 0))\n")
check("a line longer than any buffer", [(0, 0), (0, 1), (0, 2), (0, 3), (0, 5)], pairs("long", long, spots))
more = write(
    "more.wkt",
    "MULTIPOINT (1 1, 4 4)\nMULTIPOINT ((2.5 2.5), (7 7))\nMultiPoint Z ((4 0 9))\n"
    "polygon 0 0 8 0 8 8\npolyline 0 -1, 4 -1, 4 4\n",
)
check(
    "points, and vertices in words",
    [(0, 0), (1, 2), (2, 5), (3, 0), (3, 1), (3, 2), (3, 5), (4, 1), (4, 5)],
    pairs("more", more, spots),
)
check(
    "vertices alone",
    [(0, 0), (0, 2)],
    pairs("vertices alone", write("alone.txt", "0 0 1 1 3 3\n"), known_spots, "--kind", "polyline"),
)
boxes = [draw("aabb", rng) for _ in range(80)]
alone = write("alone.csv", "min_x,min_y,max_x,max_y\n" + "".join(",".join(map(str, n)) + "\n" for _, n in boxes))
check("numbers alone", all_pairs(boxes), pairs("numbers alone", "--kind", "aabb", alone))

# ---- Arrays of numpy's --------------------------------------------------------------------------------------------
for dtype in ("<f8", ">f8", "<f4", ">f4"):
    rows = numpy.array([numbers for _, numbers in boxes], dtype)
    numpy.save("rows.npy", rows)
    check(f"rows of {dtype}", all_pairs(boxes), pairs(dtype, "rows.npy", "--kind", "aabb"))
for kind, fields in FIELDS.items():
    shapes = [draw(kind, rng) for _ in range(40)]
    records = numpy.zeros(40, [("id", "<i2"), *((name, "<f4") for name in fields), ("label", "<U3")])
    for name, column in zip(fields, zip(*(numbers for _, numbers in shapes))):
        records[name] = column
    numpy.save("records.npy", records)
    check(f"records of {kind}", all_pairs(shapes, shapes_b), pairs(kind, "records.npy", b))
numpy.save("aligned.npy", numpy.zeros(2, numpy.dtype([("c", "i1"), ("x", "f8"), ("y", "f8")], align=True)))
check("padded records", [(0, 1)], pairs("padded records", "aligned.npy"))
# A number that a float cannot hold is rounded when it is saved, and not once more.
numpy.save("tenth.npy", numpy.array([[0.1, 0.1]], "f4"))
wide = write("wide.txt", f"point {float(numpy.float32(0.1))!r} {float(numpy.float32(0.1))!r}\npoint 0.1 0.1\n")
check("floats", [], pairs("floats", "tenth.npy", write("narrow.txt", "0.1 0.1"), "--kind", "point"))
check(
    "floats, wide",
    [(0, 0)],
    pairs("wide", "tenth.npy", write("wide.csv", open(wide).read().replace("point ", "")), "--kind", "point"),
)

# Polygons in arrays: quads, and vertices with offsets.
quads = numpy.array([[[0, 0], [8, 0], [8, 8], [0, 8]], [[20, 0], [21, 0], [21, 1], [20, 1]], [[9, 9], [9, 9], [9, 9], [9, 9]]], "f4")
numpy.save("quads.npy", quads)
of_quads = [(0, 0), (0, 1), (0, 2), (0, 5), (1, 3)]
check("quads", of_quads, pairs("quads", "quads.npy", spots))
check("open quads", [(0, 5)], pairs("open quads", "quads.npy", known_spots, "--kind", "polyline"))
# The zones above, with a vertex before and behind them that no ring has.
numpy.save(
    "vertices.npy",
    [[9, 9], [0, 0], [8, 0], [8, 8], [0, 8], [2, 2], [6, 2], [6, 6], [2, 6], [20, 0], [21, 0], [20, 1], [3, 3], [5, 3], [4, 5], [9, 9.0]],
)
for dtype in ("<i4", "<i8", ">i4", "<u4"):
    numpy.save("rings.npy", numpy.array([1, 5, 9, 12, 15], dtype))
    numpy.save("parts.npy", numpy.array([0, 2, 3, 4], dtype))
    numpy.save("zones.npy", numpy.array([0, 1, 3], dtype))
    numpy.save("sole.npy", numpy.array([0, 2, 4], dtype))
    check(
        f"rings of {dtype}",
        [(0, 0), (0, 1), (0, 2), (0, 5), (1, 1), (1, 2), (2, 3), (3, 1)],
        pairs("rings", "vertices.npy,rings.npy", spots),
    )
    check(f"zones of {dtype}", of_zones[:4], pairs("two arrays", "vertices.npy,rings.npy,sole.npy", spots))
    check(f"three arrays of {dtype}", of_zones[:4], pairs("three", "vertices.npy,rings.npy,parts.npy,zones.npy", spots))
check(
    "lines by offsets",
    [(0, 5)],
    pairs("lines by offsets", "vertices.npy,rings.npy", known_spots, "--kind", "polyline"),
)

# ---- GeoJSON ------------------------------------------------------------------------------------------------------
geometries = [
    {"type": "Polygon", "coordinates": [[[0, 0], [8, 0], [8, 8], [0, 8], [0, 0]], [[2, 2], [6, 2], [6, 6], [2, 6], [2, 2]]]},
    {"type": "MultiPolygon", "coordinates": [[[[20, 0], [21, 0], [20, 1], [20, 0]]], [[[3, 3], [5, 3], [4, 5], [3, 3]]]]},
    {"coordinates": [[0, -1], [4, -1], [4, 4]], "type": "LineString"},
    {"type": "MultiLineString", "coordinates": [[[9, 9, 5], [9, 10, 5]], [[11, 11], [12, 12], [13, 11]]]},
]
misleading = {"type": "Point", "coordinates": [1, 1], "features": [{"a}": '"]}\\'}], "n": None, "t": [True, 1e3, -2.5]}
features = [{"type": "Feature", "properties": misleading, "geometry": g, "id": 7} for g in geometries]
for what, document in (
    ("a collection", json.dumps({"name": "\u00fc", "features": features, "type": "FeatureCollection", "bbox": [0, 0, 1, 1]}, indent=1)),
    ("geometries", json.dumps({"type": "GeometryCollection", "geometries": geometries})),
    ("a line each", "\n".join(map(json.dumps, features))),
    ("a sequence", "".join("\x1e" + json.dumps(g) + "\n" for g in geometries)),
    ("collections", json.dumps({"type": "Feature", "properties": None, "geometry": {"type": "GeometryCollection", "geometries": geometries}})),
):
    check(what, of_zones, pairs(what, write("zones.geojson", document), spots))
whole = json.dumps({"type": "FeatureCollection", "features": features})
for length in range(1, len(whole), 3):
    status, out, err = run(write("cut.json", whole[:length]), spots)
    check(f"{length} bytes of GeoJSON", (2, "", "cut.json: line 1: "), (status, out, err[:18]))
unplaced = [{"type": "Feature", "geometry": None}, {"type": "Feature", "geometry": {"type": "Point", "coordinates": []}}]
numbered = write("numbered.json", json.dumps({"type": "FeatureCollection", "features": [*unplaced, *features]}))
check("shapes without a place keep a number", [(i + 2, j) for i, j in of_zones], pairs("unplaced", numbered, spots))
points = write("points.json", '{"type":"MultiPoint","coordinates":[[1,1],[4,4]]}{"type":"Point","coordinates":[4,0,7]}')
check("points of GeoJSON", [(0, 0), (1, 5)], pairs("points of GeoJSON", points, spots))
for geometry, complaint in (
    ('{"type":"Polygon","coordinates":[[0,0],[1,0],[1,1]]}', "coordinates of no Polygon"),
    ('{"type":"Point","coordinates":[[0,0]]}', "coordinates of no Point"),
    ('{"type":"Point","coordinates":[0]}', "not positions of two numbers"),
    ('{"type":"Point","coordinates":["a",0]}', "coordinates are not numbers"),
    ('{"type":"Point","coordinates":{"a":[0,0]}}', "coordinates are not numbers"),
    ('{"type":"Point","coordinates":[0,null]}', "coordinates are not numbers"),
    ('{"type":"Point","coordinates":[1e999,0]}', "shape A (point) is invalid: a number is NaN or infinite"),
    ('{"type":"LineString","coordinates":[[0,0],[[1,1]]]}', "positions at unlike depths"),
    ('{"type":"Polygon","coordinates":[[[0,0],[2,2],[2,0],[0,2]]]}', "shape A (polygon) is invalid: edges of a polygon cross or overlap"),
    ('{"type":"Circle","coordinates":[0,0]}', "'Circle' is no Point, LineString or Polygon"),
    ('{"type":"Point"}', "a Point without coordinates"),
    ('{"type":"Point","coordinates":[0,0],"geometries":[]}', "coordinates beside other geometries"),
    ("{}", "'' is no Point, LineString or Polygon"),
):
    feature = '{"type":"Feature","geometry":\n%s}' % geometry
    collection = write("bad.json", '{"type":"FeatureCollection","features":[\n{"type":"Feature","geometry":null},%s]}' % feature)
    refused(geometry, f"bad.json:3: feature 1: {complaint}\nvesica-join: nothing is written: --skip-bad goes on without bad shapes\n", collection)
    check(f"{geometry}, skipped", [], pairs(geometry, "--skip-bad", collection))
for document, complaint in (
    ('{"type":"Point","coordinates":[0,0]} [1]', "line 1: '{' is missing"),
    ('{"type" "Point"}', "line 1: ':' is missing"),
    ('{"type":"Feature",\n"geometry":null "id":1}', "line 2: ',' or '}' is missing"),
    ('{"features":[{} {}]}', "line 1: ',' or ']' is missing"),
    ('{"features":{}}', "line 1: '[' is missing"),
    ('{"a":}', "line 1: a value is missing"),
    ('{"type":"GeometryCollection","geometries":[' * 65 + "]}" * 65, "line 1: objects in more than 64 objects"),
):
    status, out, err = run(write("bad.json", document), "--skip-bad")
    check(document[:50], (2, "", f"bad.json: {complaint}\n"), (status, out, "".join(line for line in err.splitlines(True) if ": line " in line)))

# ---- Files with nothing in them -----------------------------------------------------------------------------------
numpy.save("none.npy", numpy.zeros((0, 3)))
for empty in (write("empty.txt", ""), write("comments.txt", "# nothing\n\n")):
    for files in ((empty,), (empty, a), (a, empty)):
        check(f"{files}", [], pairs(f"{files}", *files))
check("an array of no rows", [], pairs("no rows", "none.npy", "--kind", "circle"))

# ---- Bad shapes: named by their line, and skipped only when that is asked for; others keep their numbers -----------
bad = write("bad.txt", "point 0 0\ncircle 0 0 -1\nsquare 1 2\npoint 0\npoint 0 0 0\npoint nan 0\npoint 0 0\n")
complaints = """bad.txt:2: shape A (circle) is invalid: a size is negative
bad.txt:3: shape A: unknown kind 'square'
bad.txt:4: shape A, number 2 of 2 is missing
bad.txt:5: '0' after the shape
bad.txt:6: shape A (point) is invalid: a number is NaN or infinite
"""
skipping = "vesica-join: nothing is written: --skip-bad goes on without bad shapes\n"
refused("bad lines", complaints + skipping, bad)
check("--skip-bad", [(0, 6)], pairs("--skip-bad", "--skip-bad", bad))
check("what --skip-bad says", complaints, "".join(run("--skip-bad", bad)[2].splitlines(True)[:5]))
refused("bad lines of B", complaints.replace("shape A", "shape B") + skipping, a, bad)
many = write("many.txt", "x\n" * 50)
check("many bad lines", 22, len(run(many)[2].splitlines()))
check("how many more", "many.txt: and 30 more like these", run(many)[2].splitlines()[20])
for line, complaint in (
    ("point 0 0\0", "a NUL byte: this is not a text file"),
    ("POINT 1 2)", "unknown kind 'POINT'"),
    ("POINT (1)", "not positions of two numbers in parentheses"),
    ("POINT (1 2) x", "'x' after the shape"),
    ("POINT (1 2, 3 4)", "a point with 2 positions"),
    ("LINESTRING (1 2, 3)", "not positions of two numbers in parentheses"),
    ("POLYGON (0 0, 1 1, 0 1)", "not positions of two numbers in parentheses"),
    ("POLYGON ((0 0, 1 0, 1 1, 0 1)", "')' is missing"),
    ("POLYGON ((0 0, 1 nan, 1 1))", "shape A (polygon) is invalid: a number is NaN or infinite"),
    ("POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", "shape A (polygon) is invalid: edges of a polygon cross or overlap"),
    ("polygon 0 0 1 0 1", "y is missing"),
    ("polygon", "no vertices"),
    ("CURVE (0 0)", "'CURVE (0 0)' is no POINT, LINESTRING or POLYGON"),
):
    status, out, err = run(write("one.txt", "point 0 0\n" + line + "\n"))
    check(line[:50], (2, ""), (status, out))
    if complaint not in err or not err.startswith("one.txt:2: "):
        check(f"complaint of {line[:50]}", complaint, err)

rows = numpy.zeros((5, 3))
rows[3, 2] = -1
numpy.save("bad.npy", rows)
complaint = "bad.npy: row 3: shape A (circle) is invalid: a size is negative\n"
refused("a bad row", complaint + skipping, "bad.npy", "--kind", "circle")
check("rows left", 6, len(pairs("rows left", "bad.npy", "--kind", "circle", "--skip-bad")))

# ---- Tables --------------------------------------------------------------------------------------------------------
known_pairs = pairs("a table's shapes as lines", write("lines.txt", "circle 0 0 2\ncircle 9 9 1\ncircle 1 1 1\n"))
check("a table's shapes as lines", [(0, 2)], known_pairs)
table = "id,cx,name,cy,r\nx,0,none,0,2\ny,9,\"a, b\",9,1\n\"z \"\"3\"\"\",1,\"two\nlines\",1,1\n"
for what, content in (
    ("a table", table),
    ("CR LF", table.replace("\n", "\r\n")),
    ("no last line end", table.rstrip()),
    ("byte order mark", "\ufeff" + table),
    ("blank lines", table + "\n\n"),
    ("semicolons", "id;cx;name;cy;r\nx;0;a,b;0;2\ny;9;;9;1\n\"z \"\"3\"\"\";1;;1;1"),
    ("tabs and spaces", "id\tcx\tname\tcy\tr\nx\t 0 \t\t0\t2\ny\t9\t\t9\t1\n\"z \"\"3\"\"\"\t1\t\t1\t1"),
):
    circles = write("circles.csv", content)
    check(what, known_pairs, pairs(what, circles))
    check(f"{what}: ids", (0, 'a_id,b_id\nx,"z ""3"""\n'), run("--id", "id", circles)[:2])
check(
    "--delimiter",
    known_pairs,
    pairs("--delimiter", "--delimiter=|", write("bars.csv", table.replace("a, b", "ab").replace(",", "|"))),
)
own = write("own.csv", "e,n,radius\n0,0,2\n9,9,1\n1,1,1\n")
check("own names", known_pairs, pairs("own names", "--shape", "cx=e,cy=n,r=radius", own))
check("own names by kind", known_pairs, pairs("by kind", "--shape=e,n,radius", "--kind=circle", own))
in_text = "ID,Shape,note\n7,POLYGON ((0 0,8 0,8 8,0 8,0 0)),\n8,,empty\n9,POINT EMPTY,\n10,\"POINT (1 1)\",\n"
in_text = in_text.replace("POLYGON ((0 0,8 0,8 8,0 8,0 0))", '"POLYGON ((0 0,8 0,8 8,0 8,0 0))"')
check("well-known text in a table", [(0, 3)], pairs("text", "--shape", "Shape", write("text.csv", in_text)))
check("its ids", (0, "7,10\n"), run("--shape=Shape", "--id=ID", "--no-header", "text.csv")[:2])
check("by its usual name", [(0, 3)], pairs("usual", write("usual.csv", in_text.replace("Shape", "WKT"))))
write("one.csv", "wkt,ID\nPOINT(8 8),\n")
check(
    "ids of one file",
    (0, "a_id,b_from_0\n7,0\n"),
    run("text.csv", "one.csv", "--shape=Shape", "--shape=wkt", "--id=ID", "--id=")[:2],
)
# Rectangles by full size and angle: 4 x 2, a quarter turn of it, and the same upright.
boxes_by_angle = "cx,cy,w,h,angle_deg\n0,0,4,2,0\n0,0,4,2,90\n0,0,2,4,0\n"
corners = write("corners.txt", "point 2 1\npoint 1 2\npoint 2.0000000000000004 1\npoint 1 -2\n")
check(
    "degrees",
    [(0, 0), (1, 1), (1, 3), (2, 1), (2, 3)],
    pairs("degrees", write("boxes.csv", boxes_by_angle), corners),
)
check(
    "reversed columns",
    [(0, 0), (1, 1), (1, 3), (2, 1), (2, 3)],
    pairs("reversed", "--shape", "angle_deg,h,w,cy,cx", "--shape=", "boxes.csv", corners),
)
check(
    "upright",
    [(0, 0), (1, 0), (2, 1), (2, 3)],
    pairs("upright", "--shape=cx,cy,w,h", "--shape=", "boxes.csv", corners),
)
check(
    "half a turn in radians",
    [(0, 0), (0, 2)],
    pairs("radians", write("radians.csv", "cx,cy,w,h,angle\n0,0,4.1,2.1,3.141592653589793\n"), corners),
)
check(
    "ellipses",
    [(0, 0)],
    pairs("ellipses", write("ellipses.csv", "cx,cy,a,b,angle_deg\n0,0,4,2,90\n"), write("on.txt", "point 0 4\npoint 4 0\n")),
)
numpy.save("boxes.npy", numpy.array([[0, 0, 4, 2, 0], [0, 0, 4, 2, 90.0]]))
check(
    "degrees in an array",
    [(0, 0), (1, 1), (1, 3)],
    pairs("array", "--shape=cx,cy,w,h,angle_deg", "--shape=", "boxes.npy", corners),
)
for complaint, content, *arguments in (
    (":3: column 'r': 'big' is not a number", "cx,cy,r\n0,0,1\n0,0,big\n"),
    (":3: column 'r' is empty", "cx,cy,r\n0,0,1\n0,0,\n"),
    (":3: 4 fields, but 3 names in the first line", "cx,cy,r\n0,0,1\n0,0,1,1\n"),
    (":3: 2 fields, but 3 names in the first line", "cx,cy,r\n0,0,1\n0,0\n"),
    (":4: shape A (circle) is invalid: a size is negative", 'id,cx,cy,r\n"1\n2",0,0,1\n3,0,0,-1\n'),
    (":2: shape A (rect) is invalid: a size is negative", "cx,cy,w,h,angle\n0,0,-1,2,3\n"),
    (":2: shape A (rect) is invalid: a number is NaN or infinite", "cx,cy,w,h,angle\n0,0,1,2,inf\n"),
    (":3: a quote without end", 'cx,cy,r\n0,0,1\n0,0,"1\n0,0,1\n'),
    (":3: text after a quoted field", 'cx,cy,r\n0,0,1\n0,0,"1"1\n'),
    (":3: a NUL byte: this is not a text file", "cx,cy,r\n0,0,1\n0,0,1\0\n"),
    (":2: column 'wkt': ')' is missing", 'wkt,name\n"POLYGON ((0 0, 1 0, 1 1, 0 1)",a\n'),
    (":2: column 'wkt': 'CURVE (0 0)' is no POINT, LINESTRING or POLYGON", "wkt,name\nCURVE (0 0),a\n"),
    (": no column 'radius' among cx, cy, r", "cx,cy,r\n", "--shape", "cx,cy,r=radius"),
    (": no column 'text' among cx, cy, r", "cx,cy,r\n", "--shape", "text"),
    (": no column 'id'", "cx,cy,r\n", "--id", "id"),
    (": --shape: 'cx,cy' are the numbers of no kind (--help)", "cx,cy,r\n", "--shape", "cx,cy"),
    (": --shape: a name is missing or too long", "cx,cy,r\n", "--shape", "cx,,cy"),
    (": its columns (id, value) are those of no kind: --shape tells which", "id,value\n1,2\n"),
    (": its columns are those of point, but there is 'W': --shape or --kind tells which", "id,x,y,W,h\n1,2,3,4,5\n"),
    (": its columns are those of point, but there is 'radius': --shape or --kind tells which", "x,y,radius\n1,2,3\n"),
    (": its columns are those of aabb, but there is 'angle': --shape or --kind tells which", "min_x,min_y,max_x,max_y,angle\n1,2,3,4,5\n"),
    (": its columns (cx, cy, r) are not those of rect: --shape tells which", "cx,cy,r\n1,2,3\n", "--kind=rect"),
    (": more than 1024 columns", ",".join(map(str, range(1025))), "--shape=wkt"),
):
    name = write("bad.csv", content)
    refused(complaint, f"bad.csv{complaint}\n" + (skipping if complaint[1].isdigit() else ""), name, *arguments)

# ---- Ids of GeoJSON ------------------------------------------------------------------------------------------------
def feature(geometry, properties, **others):
    return {"type": "Feature", "geometry": geometry, "properties": properties, **others}


spot = {"type": "Point", "coordinates": [1, 1]}
collection = {"type": "FeatureCollection", "features": [
    feature(spot, {"n": {"name": "wrong"}, "name": 'Z\u00fcrich, "\U0001f600"\n'}, id=5),
    feature({"type": "GeometryCollection", "geometries": [spot, {"type": "Point", "coordinates": [9, 9]}]}, {"name": 2.50}, id="six"),
    feature(None, {"name": None}, id=7),
]}  # fmt: skip
for ascii_only in (True, False):
    write("ids.json", json.dumps(collection, ensure_ascii=ascii_only))
    check("ids of features", (0, "a_id,b_id\n5,six\n"), run("--id", "id", "ids.json")[:2])
    check(
        "ids of properties",
        (0, 'a_id,b_id\n"Z\u00fcrich, ""\U0001f600""\n",2.5\n'),
        run("--id", "name", "ids.json")[:2],
    )
refused("no id", "noid.json: shape 0: no 'name' in its feature\n", "--id=name", write("noid.json", json.dumps(feature(spot, {}))))
refused("ids of an array", "quads.npy: --id: arrays have none\n", "--id=name", "quads.npy")

# ---- Distances -----------------------------------------------------------------------------------------------------
def measured(one, other):
    a, b = ((ctypes.c_double * len(numbers))(*numbers) for _, numbers in (one, other))
    out = (ctypes.c_double * 8)()
    assert library.vesica_nearest_f64(KINDS.index(one[0]), a, KINDS.index(other[0]), b, out) == 0
    return out[0]


plain = [shape for shape in shapes_a if shape[0] in ("point", "circle", "aabb")]
others = [shape for shape in shapes_b if shape[0] in ("point", "circle", "aabb")]
one, two = write("plain.txt", text(plain)), write("others.txt", text(others))
distances = [[measured(p, q) for q in others] for p in plain]
within = [(i, j) for i, row in enumerate(distances) for j, distance in enumerate(row) if distance <= 1.5]
check("--within", within, pairs("--within", "--within", "1.5", one, two))


def neighbours(rows, count, most, alone):
    for i, row in enumerate(rows):
        found = sorted((distance, j) for j, distance in enumerate(row) if distance <= most and not (alone and i == j))
        yield from ((i, j, distance) for distance, j in found[:count])


def nearest(what, *arguments):
    status, out, err = run(*arguments)
    lines = out.splitlines()
    check(f"{what}: status and header", (0, "a_from_0,b_from_0,distance"), (status, lines[0] if lines else err))
    found = [(int(a), int(b), float(distance)) for a, b, distance in (line.split(",") for line in lines[1:])]
    check(f"{what}: --count", f"{len(found)}\n", run("--count", *arguments)[1])
    return sorted(found)


# Items are numbered kind by kind, so among equally near ones the file's order does not decide.
for count, most in ((1, 1e9), (4, 2.0), (1000, 1e9)):
    for rows, files in ((distances, (one, two)), ([[measured(p, q) for q in plain] for p in plain], (one,))):
        expected = list(neighbours(rows, count, most, len(files) == 1))
        found = nearest(f"{count} nearest", "--nearest", str(count), f"--within={most}", *files)
        check(
            f"{count} nearest: distances",
            sorted((i, d) for i, _, d in expected),
            sorted((i, d) for i, _, d in found),
        )
        check(f"{count} nearest: shapes", [], [each for each in found if rows[each[0]][each[1]] != each[2]])
        check(f"{count} nearest: twice", len(found), len({each[:2] for each in found}))

# ---- Standard input, and where output goes -------------------------------------------------------------------------
for name in (a, circles, "numbered.json", "aligned.npy"):
    with open(name, "rb") as file:
        expected_output = run(name, b)[1]
        check(
            f"{name} on standard input",
            expected_output,
            subprocess.run([sys.argv[1], "-", b], stdin=file, capture_output=True, text=True).stdout,
        )
    piped = subprocess.run([sys.argv[1], b, "-"], input=open(name, "rb").read(), capture_output=True).stdout
    check(f"{name} in a pipe", run(b, name)[1].encode(), piped)
complaint = subprocess.run([sys.argv[1], "-"], input="point 0\n", capture_output=True, text=True).stderr.splitlines()[0]
check("a complaint of standard input", "standard input:1: shape A, number 2 of 2 is missing", complaint)
check("--output", (0, ""), run("--output", "pairs.csv", a, b)[:2])
check("its file", run(a, b)[1], open("pairs.csv").read())
check("--quiet", "", run("--quiet", a, b)[2])
run("--binary", "--output=pairs.bin", a, b)
check("--binary", pairs("text", a, b), sorted(map(tuple, numpy.fromfile("pairs.bin", "i8").reshape(-1, 2).tolist())))
run("--binary", "--output=pairs.bin", "--nearest=2", one, two)
rows = numpy.fromfile("pairs.bin", [("a", "i8"), ("b", "i8"), ("distance", "f8")])
check("--binary with distances", nearest("text", "--nearest=2", one, two), sorted(map(tuple, rows.tolist())))

# ---- Threads: files of several pieces, the same bytes with any number ----------------------------------------------
many = [(f"n{i}", rng.random() * 300, rng.random() * 300, rng.random()) for i in range(60000)]
quoted = 'a "quote", \n and lines\n\n'
with open("many.csv", "w", newline="") as file:
    rows = csv.writer(file)
    rows.writerow(("name", "note", "cx", "cy", "r"))
    rows.writerows((name, quoted * rng.randrange(4), *numbers) for name, *numbers in many)
check("several pieces", True, os.path.getsize("many.csv") > 4 << 20)
with open("long.csv", "w") as file:  # a line of more than two pieces
    file.write(f'id,note,cx,cy,r\n1,,0,0,1\n2,"{quoted.replace(chr(34), chr(34) * 2) * 200000}",0,0,1\n3,,0,0,1\n4,,0,0,wide\n')
write("many.txt", "".join(f"circle {x!r} {y!r} {r!r}\n" for _, x, y, r in many))
write("many.wkt", "".join(f"POLYGON (({x!r} {y!r},{x + r!r} {y!r},{x!r} {y + r!r}))\n" for _, x, y, r in many))
names = [name for name, *_ in many]
in_lines = run("--threads=1", "many.txt")[1]
renamed = "a_id,b_id\n" + "".join(",".join(names[int(each)] for each in line.split(",")) + "\n" for line in in_lines.splitlines()[1:])
for threads in ("1", "2", "7"):
    use = ("--threads", threads)
    check(f"{threads} threads: lines", in_lines, run(*use, "many.txt")[1])
    check(f"{threads} threads: a table", in_lines, run(*use, "many.csv")[1])
    check(f"{threads} threads: ids", renamed, run(*use, "many.csv", "--id=name")[1])
    for question in (("--nearest=2",), ("--within=0.1",), ("--contains",), ("--binary", "--output=/dev/stdout")):
        check(f"{threads} threads: {question}", subprocess.run([sys.argv[1], "--threads=3", *question, "many.txt"], capture_output=True).stdout,
              subprocess.run([sys.argv[1], *use, *question, "many.csv"], capture_output=True).stdout)
    check(f"{threads} threads: polygons", run("--threads=3", "many.wkt")[1], run(*use, "many.wkt")[1])
    line = 2 + 2 + 3 * 200000
    refused(f"{threads} threads: a long line", f"long.csv:{line + 1}: column 'r': 'wide' is not a number\n" + skipping, *use, "long.csv")
    check(f"{threads} threads: the others", "3\n", run(*use, "--skip-bad", "--count", "long.csv")[1])

# ---- Arrays that are no shapes, cut off anywhere, or lie about their size ------------------------------------------
def unusable(what, complaint, array, *arguments):
    numpy.save("unusable.npy", array)
    refused(what, f"unusable.npy: {complaint}\n", "unusable.npy", *arguments)


unusable("integers", "its numbers are not float64 or float32", numpy.zeros((2, 2), int), "--kind", "point")
unusable("columns", "3 columns, but point has 2 numbers", numpy.zeros((2, 3)), "--kind", "point")
unusable("no kind", "plain numbers: --kind or --shape tells what a row is", numpy.zeros((2, 3)))
unusable("one dimension", "not an array of two dimensions", numpy.zeros(4), "--kind", "point")
unusable("column by column", "its columns lie one after the other: save it row by row", numpy.zeros((2, 2), order="F"), "--kind", "point")
unusable("no fields", "its columns (a) are those of no kind: --shape tells which", numpy.zeros(2, [("a", "f8")]))
unusable("another kind's", "its columns (cx, cy) are not those of circle: --shape tells which", numpy.zeros(2, [("cx", "f8"), ("cy", "f8")]), "--kind", "circle")
unusable("field of integers", "field 'x' is not of float64 or float32", numpy.zeros(2, [("x", "i8"), ("y", "f8")]))
unusable("nested", "a type of elements that cannot be read here", numpy.zeros(2, [("x", "f8", 2), ("y", "f8")]))
unusable("vertices alone", "an array of vertices: offsets tell which are of one shape (--help)", numpy.zeros((2, 2)), "--kind", "polygon")
unusable("positions of three", "of three dimensions the last must be 2, and the middle one the number of vertices", numpy.zeros((2, 4, 3)))
unusable("rows of circles", "not an array of two dimensions", numpy.zeros((2, 4, 2)), "--kind", "circle")
for what, path, complaint, array in (
    ("offsets that decrease", "offsets.npy", "offset 2 is negative or less than the one before", numpy.array([0, 4, 3])),
    ("a negative offset", "offsets.npy", "offset 0 is negative or less than the one before", numpy.array([-1, 4])),
    ("offsets beyond the vertices", "vertices.npy", "has fewer vertices than offsets say", numpy.array([0, 17])),
    ("no offset", "offsets.npy", "no offset: there is one more than there are shapes", numpy.array([], int)),
    ("offsets of two dimensions", "offsets.npy", "not an array of offsets, int32 or int64, of one dimension", numpy.zeros((2, 2), int)),
    ("offsets of floats", "offsets.npy", "not an array of offsets, int32 or int64, of one dimension", numpy.zeros(2)),
):
    numpy.save("offsets.npy", array)
    refused(what, f"{path}: {complaint}\n", "vertices.npy,offsets.npy")
numpy.save("offsets.npy", numpy.array([0, 5]))
refused("rings beyond the rings", "offsets.npy: an offset is beyond the array before it\n", "vertices.npy,rings.npy,offsets.npy")
refused("no file of offsets", "nowhere.npy: cannot read\n", "vertices.npy,nowhere.npy")
numpy.save("offsets.npy", numpy.array([0, 3, 3, 6]))
refused("an empty polygon", "vertices.npy: shape 1: shape A (polygon) is invalid: a polygon has no vertex, or its offsets are negative or decrease\n" + skipping, "vertices.npy,offsets.npy")
numpy.save("whole.npy", numpy.arange(12.0).reshape(4, 3))
whole = open("whole.npy", "rb").read()
for length in range(1, len(whole)):
    status, out, err = run(write("cut.npy", whole[:length]), "--kind", "circle")
    check(f"{length} bytes", (2, "", "cut.npy: "), (status, out, err[:9]))
huge = whole.replace(b"(4, 3)", b"(9000000000000000000, 3)").replace(b" " * 18 + b"\n", b"\n")
refused("more rows than there are", "lies.npy: ends in row 4 of 9000000000000000000\n", write("lies.npy", huge), "--kind", "circle")

# ---- Memory, files, arguments -----------------------------------------------------------------------------------
numpy.save("crowd.npy", numpy.random.default_rng(1).random((300000, 2)))
outcomes = set()
for megabytes in (12, 16, 20, 24, 28, 200):
    status, out, err = run("--count", "--kind", "point", "crowd.npy", memory=megabytes << 20)
    outcomes.add(status)
    if status == 2:
        check(f"{megabytes} MiB", ("", True), (out, "out of memory" in err))
check("outcomes with little memory", {0, 2}, outcomes)
refused("missing file", "nowhere: cannot read: No such file or directory\n", "nowhere")
refused("missing file after one with bad lines", "nowhere: cannot read: No such file or directory\n", bad, "nowhere")
refused("directory", ".: cannot read: Is a directory\n", ".")
for complaint, *arguments in (
    ("a file is missing (--help)",),
    ("--kind: its value is missing", "--kind"),
    ("--kind: unknown kind 'square'", "--kind", "square", a),
    ("unknown option '--all' (--help)", "--all", a),
    ("unknown option '-k' (--help)", "-k", a),
    ("unknown option '--contain': --contains?", "--contain", a),
    ("unknown option '--neares': --nearest?", "--neares=3", a),
    ("unknown option '--shpae': --shape?", "--shpae", "wkt", a),
    ("'b.txt' would be a third file", a, a, b),
    ("--count takes no value", "--count=3", a),
    ("--within: '1m' is not a number", "--within", "1m", a),
    ("--within: 'nan' is not a number", "--within=nan", a),
    ("--within: less than 0, beside --nearest", "--within=-1", "--nearest=1", a),
    ("--nearest: '0' is not a whole number from 1 to 2147483646", "--nearest", "0", a),
    ("--threads: '257' is not a whole number from 1 to 256", "--threads=257", a),
    ("--delimiter: '::' is not a character, or `tab`", "--delimiter=::", a),
    ("--id: more than two", "--id=a", "--id=b", "--id=c", a),
    ("more than one question: --contains, --inside, --interiors, --bounds, --within or --nearest", "--within=1", "--bounds", a),
    ("--binary writes numbers, and --id text", "--binary", "--id=x", a),
    ("standard input can be one file only", "-", "-"),
    ("nowhere/pairs: cannot write: No such file or directory", "--output=nowhere/pairs", a),
):
    refused(complaint, f"vesica-join: {complaint}\n", *arguments)
check("--help", (0, "usage: vesica-join", ""), (lambda done: (done[0], done[1][:18], done[2]))(run("--help")))
with open("/dev/full", "w") as full:
    done = subprocess.run([sys.argv[1], a], stdout=full, stderr=subprocess.PIPE, text=True)
check("a full disk", (2, "vesica-join: cannot write the pairs\n"), (done.returncode, done.stderr))

# ---- What a terminal shows ----------------------------------------------------------------------------------------
# Progress is shown after half a second: the pipe is full for longer, however quick the machine.
master, terminal = pty.openpty()
write("same.txt", "point 0 0\n" * 4000)
with subprocess.Popen([sys.argv[1], "same.txt"], stdout=subprocess.PIPE, stderr=terminal) as join:
    os.close(terminal)
    join.stdout.read(1)
    time.sleep(0.6)
    while join.stdout.read(1 << 20):
        pass
shown = ""
with contextlib.suppress(OSError):  # That is how a terminal ends. What was written comes in pieces.
    while piece := os.read(master, 65536):
        shown += piece.decode()
check("status", 0, join.returncode)
check("progress on a terminal", (True, True), ("joining: " in shown, shown.rstrip().endswith("a shape")))

sys.exit(failures != 0)
