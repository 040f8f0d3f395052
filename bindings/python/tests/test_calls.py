# SPDX-License-Identifier: Apache-2.0
"""The calls that all packages answer alike (bindings/calls/calls.txt), and that wrong answers among them are found."""
import ctypes
import math
import pathlib
import unittest

import numpy
import vesica
from vesica import Kind

LINES = [
    line
    for line in pathlib.Path(__file__).with_name("calls.txt").read_text().splitlines()
    if not line.startswith("#")
]
DTYPES = {"f64": numpy.float64, "f32": numpy.float32}
ERRORS = {
    -1: "E_NULL",
    -2: "E_SHAPE",
    -3: "E_KIND",
    -4: "E_ARGUMENT",
    -5: "E_NOT_FINITE",
    -6: "E_NEGATIVE_SIZE",
    -7: "E_ZERO_AXIS",
    -8: "E_INVERTED",
    -9: "E_RANGE",
    -10: "E_INDEX",
}
QUERIES = list(vesica.index._QUERIES)
BOXES = ("rects_from_boxes", "ellipses_from_boxes", "boxes_from_shapes", "corners_of_shapes", "bounds_many")


def number(word):
    return float.fromhex(word) if "x" in word else float(word)


class Call:
    def __init__(self, left):
        name, *self.arguments = left.split(" | ")
        self.function, self.scalar = name.split()
        self.dtype = DTYPES[self.scalar]

    def numbers(self, i):
        return [number(word) for word in self.arguments[i].split()]

    def shapes(self, argument):
        kind, *words = argument.split()
        kind = Kind[kind.upper()]
        rows = numpy.array([number(word) for word in words], self.dtype).reshape(-1, len(vesica.FIELDS[kind]))
        return vesica.shapes(kind, rows)

    def single(self, i):
        return self.shapes(self.arguments[i])[0]

    def answer(self):
        """(result or None, values): a call that gives an array does not tell how many of it hold."""
        name = self.function
        if name in BOXES:
            return 0, self.of_boxes()
        if "cast" in name or name in ("sweep_bounds", "impact_time"):
            return self.of_motion()
        if name.startswith("ratio"):
            return self.of_ratios()
        if name.startswith(("within", "de9im", "intersection")) or name in ("join_within", "suppress_soft"):
            return self.of_topology()
        if name == "suppress":
            return 0, self.suppressed()
        if "_from_" in name:
            return self.constructed()
        if name == "rect_corners_misfit":
            corners = numpy.array(self.numbers(0), self.dtype).reshape(4, 2)
            return 0, [vesica.rect_corners_misfit(corners, self.single(1))]
        if name.startswith(("index_", "join")):
            return self.of_indexes()
        if name == "nms":
            scores, (threshold,) = self.numbers(1), self.numbers(2)
            return 0, vesica.nms(self.shapes(self.arguments[0]), scores, threshold)
        if name.endswith("overlap_select"):
            found = getattr(vesica, name)(self.single(0), self.shapes(self.arguments[1]))
            return len(found), found
        if name.endswith("_many"):
            return None, flat(getattr(vesica, name[:-5])(*map(self.shapes, self.arguments)))
        if name.endswith("_matrix"):
            return None, getattr(vesica, name)(*map(self.shapes, self.arguments)).ravel()
        return self.of_one_or_two()

    def of_boxes(self):
        name, first = self.function, self.arguments[0]
        if name == "bounds_many":
            return flat(vesica.bounds(self.shapes(first)))
        if name == "corners_of_shapes":
            return flat(vesica.corners(self.shapes(first)))
        unit = int(self.numbers(1)[0])
        how = {"degrees": unit & 3 == 1, "quarters": unit & 3 == 2, "reverse": unit >= 4}
        if name == "boxes_from_shapes":
            return flat(vesica.boxes(self.shapes(first), **how))
        rows = numpy.array(self.numbers(0), self.dtype).reshape(-1, 5)
        if name == "rects_from_boxes":
            return flat(vesica.rects(rows, **how))
        halves = rows.copy()
        halves[:, 2:4] /= 2
        whole = lambda: vesica.ellipses_in_boxes(rows, **how)
        return flat(same_or_raise(whole, lambda: vesica.ellipses(halves, **how)))

    def of_motion(self):
        name = self.function
        if name == "cast_many":
            a, b = map(self.shapes, self.arguments[:2])
            velocities = numpy.array([self.numbers(2), self.numbers(3)], self.dtype).T
            velocities = velocities[0] if len(velocities) == 1 else velocities
            return None, flat(vesica.cast(a, b, velocities, *self.numbers(4)))
        if name == "impact_time":
            (tolerance,) = self.numbers(4)
            turns = self.numbers(1), vesica.Turn(*self.numbers(3))
            found, impact, gap = vesica.impact_time(self.single(0), turns[0], self.single(2), turns[1], tolerance)
            return int(found), [*impact, gap]
        vx, vy, t_end = self.numbers(1 if name in ("sweep_bounds", "index_cast", "index_cast_first") else 2)
        if name == "cast":
            found, impact = vesica.cast(self.single(0), self.single(1), (vx, vy), t_end)
            return int(found), impact
        if name == "sweep_bounds":
            return 0, flat(vesica.sweep_bounds(self.single(0), (vx, vy), t_end))
        if name == "cast_first":
            many = self.shapes(self.arguments[1])
            return first(vesica.cast_first(self.single(0), many, (vx, vy), t_end), len(many))
        index = vesica.Index(*map(self.shapes, self.arguments[2:]))
        if name == "index_cast":
            items = index.cast(self.single(0), (vx, vy), t_end)
            return len(items), items
        return first(index.cast_first(self.single(0), (vx, vy), t_end), len(index))

    def of_topology(self):
        name = self.function
        if name == "de9im_match":
            return int(vesica.de9im_match(*self.arguments)), []
        if name == "de9im":
            matrix = vesica.de9im(self.single(0), self.single(1))
            return 0, [-1 if character == "F" else int(character) for character in matrix]
        if name == "intersection":
            vertices = vesica.intersection(self.single(0), self.single(1))
            return len(vertices), vertices.ravel()
        if name == "within":
            return int(vesica.within(self.single(0), self.single(1), *self.numbers(2))), []
        if name.startswith("within"):
            call = vesica.within if name == "within_many" else vesica.within_matrix
            return None, flat(call(*map(self.shapes, self.arguments[:2]), *self.numbers(2)))
        if name == "join_within":
            slash = self.arguments.index("/")
            sets = [list(map(self.shapes, part)) for part in (self.arguments[1:slash], self.arguments[slash + 1 :])]
            index = vesica.Index(*sets[0])
            other = vesica.Index(*sets[1]) if sets[1] else None
            pairs = numpy.array(index.join_within(other, *self.numbers(0))).T
            return len(pairs), pairs.ravel()
        ratio, decay, parameter, least, most = self.numbers(2)
        labels = numpy.array(self.numbers(3), "i4") if len(self.arguments) > 3 else None
        how = {"labels": labels, "ratio": ratio, "least_score": least, "most": int(most)}
        decay = ("linear", "gaussian")[int(decay)]
        return 0, flat(vesica.nms_soft(self.shapes(self.arguments[0]), self.numbers(1), parameter, decay=decay, **how))

    def of_ratios(self):
        (which,) = self.numbers(0)
        if self.function == "ratio":
            return 0, [vesica.ratio(which, self.single(1), self.single(2))]
        call = vesica.ratio if self.function == "ratio_many" else vesica.ratio_matrix
        return None, flat(call(which, *map(self.shapes, self.arguments[1:])))

    def suppressed(self):
        boxes, labels = self.shapes(self.arguments[0]), None
        ratio, threshold, least, most = self.numbers(2)
        if len(self.arguments) > 3:
            labels = numpy.array(self.numbers(3), "i4")
        how = {"labels": labels, "ratio": ratio, "least_score": least, "most": int(most)}
        return vesica.nms(boxes, self.numbers(1), threshold, **how)

    def of_one_or_two(self):
        shapes = [self.single(i) for i in range(len(self.arguments))]
        if self.function == "bounds":
            return 0, vesica.bounds(*shapes).numbers
        given = getattr(vesica, self.function)(*shapes)
        if self.function in ("overlap", "interiors_overlap", "relation", "contains"):
            return int(given), []
        if self.function == "crossings":
            return len(given.places), [given.shared, *given.places.ravel()]
        return 0, [] if given is None else flat(given)

    def constructed(self):
        """The package makes arrays, by functions of its own; those of the library for one shape are in vesica.c."""
        scalar = {"f64": ctypes.c_double, "f32": ctypes.c_float}[self.scalar]
        kind = vesica.Kind[self.function[: self.function.index("_from_")].upper()]
        given, made = self.numbers(0), (scalar * len(vesica.FIELDS[kind]))()
        function = getattr(vesica.c, f"vesica_{self.function}_{self.scalar}")
        if self.function == "rect_from_corners":
            given = [(scalar * 8)(*given)]
        code = function(*given, made)
        if code < 0:
            raise vesica.VesicaError(code)
        return code, list(made)

    def of_indexes(self):
        leading = {"index_nearest": 2, "index_select": 1, "join": 1, "join_nearest": 1}.get(self.function, 0)
        rest = self.arguments[leading:]
        slash = rest.index("/") if "/" in rest else len(rest)
        sets_a, sets_b = ([self.shapes(text) for text in part] for part in (rest[:slash], rest[slash + 1 :]))
        a = vesica.Index(*sets_a)
        a = vesica.Index.from_bytes(a.bytes, *sets_a)
        b = vesica.Index(*sets_b) if sets_b else a
        if self.function == "index_bounds":
            return 0, a.bounds()
        if self.function == "index_order":
            return len(a.order()), a.order()
        if self.function == "index_select":
            return len(a.select(self.single(0))), a.select(self.single(0))
        if self.function == "index_nearest":
            k, within = self.numbers(1)
            items, distances = a.nearest(self.single(0), int(k), within)
            return len(items), [*items, *distances]
        if self.function == "join":
            query = QUERIES[int(self.arguments[0])]
            pairs = a.join(b, query)
            return a.join_count(b, query), numpy.array(pairs).T.ravel()
        k, within = self.numbers(0)
        items, distances = b.nearest_of_each(*sets_a, k=int(k), within=within)
        return int((items >= 0).sum()), flat((items, distances))


def first(found, none):
    """What a cast at many found, as the library tells it."""
    return (none, [math.inf] + [math.nan] * 4) if found is None else found


def same_or_raise(call, other):
    """What both calls give alike, or raise."""
    try:
        answer = call()
    except vesica.VesicaError as error:
        answer = error.result
        try:
            other()
        except vesica.VesicaError as error_too:
            numpy.testing.assert_array_equal(error_too.result.numbers, answer.numbers)
        raise
    numpy.testing.assert_array_equal(other().numbers, answer.numbers)
    return answer


def flat(given):
    """A number, an array, shapes, or a tuple of columns, as values."""
    if isinstance(given, vesica.Shapes):
        return given.numbers.ravel()
    return numpy.concatenate([numpy.ravel(column) for column in (given if isinstance(given, tuple) else (given,))])


def same(values, words):
    values, expected = [float(value) for value in values], [number(word) for word in words]
    return len(values) == len(expected) and all(
        a == b and math.copysign(1, a) == math.copysign(1, b) or a != a and b != b for a, b in zip(values, expected)
    )


def is_right(line):
    left, right = line.split(" = ")
    expected, *words = right.split()
    try:
        result, values = Call(left).answer()
    except vesica.VesicaError as error:
        written = [] if error.result is None else flat(error.result)
        return expected == ERRORS[error.code] and (not words or same(written, words))
    return (result is None or str(result) == expected) and same(values, words)


class Calls(unittest.TestCase):
    def test_every_call_is_right(self):
        self.assertGreater(len(LINES), 700)
        self.assertEqual([line for line in LINES if not is_right(line)], [])

    def test_wrong_answers_are_found(self):
        """The first call of each function, with its last word made what no call gives."""
        first = {line.split()[0]: line for line in reversed(LINES)}
        self.assertGreaterEqual(len(first), 70)
        for line in first.values():
            self.assertFalse(is_right(line.rsplit(" ", 1)[0] + " 7.5"), line)


if __name__ == "__main__":
    unittest.main()
