# SPDX-License-Identifier: Apache-2.0
"""Constructors of single descriptions: known answers, both types, and what is refused. Every C function has a form."""
import math
import pathlib
import re
import unittest

import numpy
import vesica


class Known(unittest.TestCase):
    def test_answers(self):
        for make, row, expected in (
            (vesica.aabbs_from_corners, [3, 1, 2, 4], [2, 1, 3, 4]),
            (vesica.capsules_from_width, [0, 0, 4, 0, 3], [0, 0, 4, 0, 1.5]),
            (vesica.capsules_from_angle, [1, 2, 4, 0, 3], [-1, 2, 3, 2, 3]),
            (vesica.ellipses_from_radius_vector, [1, 2, 3, 4, 0.5], [1, 2, 3, 4, 1, 0.5]),
        ):
            for dtype in ("f8", "f4"):
                made = make(numpy.array([row] * 2, dtype)[:, ::-1][:, ::-1])
                self.assertEqual((made.dtype, made.numbers.tolist()), (numpy.dtype(dtype), [expected] * 2))
            self.assertEqual(make(row).numbers.tolist(), expected)
            self.assertEqual(len(make([])), 0)
        made = vesica.ellipses_from_matrix([[1, 2]], [[[0.25, 0], [0, 1]]])
        self.assertEqual(made.numbers.tolist(), [[1, 2, 1, 0, 2, 1]])
        self.assertTrue(vesica.ellipses_from_matrix([1, 2], numpy.eye(2)).single)
        self.assertEqual(vesica.ellipses_from_matrix([1, 2], [[0.5, 0.25], [0.25, 1]]).dtype, numpy.float64)
        turned = vesica.capsules_from_angle([0, 0, 2, 0.5, 1]).numbers.tolist()
        for given, right in zip(turned, [-math.cos(0.5), -math.sin(0.5), math.cos(0.5), math.sin(0.5), 1]):
            self.assertAlmostEqual(given, right, delta=1e-15)

    def test_refused(self):
        for make, rows, words in (
            (vesica.aabbs_from_corners, [[0, 0, 1, 1], [0, math.nan, 1, 1]], "row 1: y0 is nan"),
            (vesica.capsules_from_width, [[0, 0, 4, 0, -3]], "row 0: width is -3"),
            (vesica.capsules_from_angle, [[0, 0, -4, 0, 3]], "row 0: length is -4"),
            (vesica.capsules_from_angle, [0, 0, 4, math.inf, 3], "angle is inf"),
            (vesica.ellipses_from_radius_vector, [[0, 0, 4, 0, -3]], "row 0: ratio is -3"),
        ):
            with self.assertRaisesRegex(vesica.VesicaError, f"^{words}$") as caught:
                make(rows)
            self.assertTrue(numpy.isnan(caught.exception.result.numbers[-1]).all())
        make = vesica.ellipses_from_matrix
        for matrix, words in (
            ([[1, 0], [0, -1]], "^the matrix 1 0 -1 .xx xy yy. is of no ellipse$"),
            ([[1, 0], [math.nan, 1]], "^mxy is nan$"),
            ([[1, 2], [0, 1]], "^matrices: row 0 is not symmetric: 2 and 0$"),
            ([1, 2], r"not \(2,\) and \(2,\)$"),
        ):
            with self.assertRaisesRegex(ValueError, words):
                make([0, 0], matrix)


# What another form of the package answers, or Python's own.
ELSEWHERE = (
    r"(overlap|cast)_(point|segment|circle|aabb|rect|ellipse)_\w+",  # overlap, cast
    r"(rect|ellipse|round_rect)_from_angle",  # rects, ellipses, round_rects
    r"(min_area_rect|min_perimeter_rect)",  # of arrays
    r"(field_count|kind_name|shapes_from_records)",  # FIELDS, Kind, Shapes
    r"version(_string)?",
)


class Complete(unittest.TestCase):
    def test_that_every_c_function_has_a_form(self):
        folder = pathlib.Path(vesica.__file__).parent
        sources = "\n".join(path.read_text() for path in folder.glob("*.py") if path.name != "_declarations.py")
        queries = set(re.findall(r'(?:_Query\(|_Matrix\(|by_scalar\(f)"(\w+)', sources))
        declared = re.findall(r'^    "vesica_(\w+)": \(', (folder / "_declarations.py").read_text(), re.MULTILINE)
        names = {re.sub("_f(64|32)$", "", name) for name in declared}
        self.assertGreater(len(names), 100)
        has_form = lambda name: (
            f'"{name}"' in sources
            or f"vesica_{name}" in sources
            or re.sub("_(many|matrix)$", "", name) in queries
            or any(re.fullmatch(pattern, name) for pattern in ELSEWHERE)
        )
        self.assertEqual(sorted(name for name in names if not has_form(name)), [])


if __name__ == "__main__":
    unittest.main()
