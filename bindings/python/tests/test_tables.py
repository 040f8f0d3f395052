# SPDX-License-Identifier: Apache-2.0
"""Columns by name: dicts, and tables such as pandas and polars have. pandas itself is asked where VESICA_PANDAS is set."""
import importlib
import os
import unittest

import numpy
import vesica

X, Y, R = numpy.array([0.0, 4, 9]), numpy.array([0.0, 4, 9]), numpy.array([1.0, 1, 1])
DISC = vesica.circles([4, 5, 0.5])


class Table:
    """What a table of polars has of this."""

    def __init__(self, columns):
        self.given, self.columns = columns, list(columns)

    def __getitem__(self, name):
        return self.given[name]

    def __array__(self, *more, **named):
        return numpy.stack(list(self.given.values()), axis=-1)


class Tables(unittest.TestCase):
    def check(self, table, columns):
        circles = vesica.circles(table)
        self.assertEqual(vesica.overlap(circles, DISC).tolist(), [False, True, False])
        self.assertEqual([c.ctypes.data for c in circles.columns], [c.ctypes.data for c in columns])

    def test_by_name(self):
        for order in ({"cx": X, "cy": Y, "r": R}, {"name": ["a", "b", "c"], "r": R, "cy": Y, "cx": X}):
            self.check(order, [X, Y, R])
            self.check(Table(order), [X, Y, R])

    def test_by_order(self):
        self.assertEqual(vesica.circles(Table({"a": X, "b": Y, "c": R})).numbers.tolist()[1], [4, 4, 1])

    def test_wrong_ones(self):
        with self.assertRaisesRegex(ValueError, "circles need fields cx cy r; missing: r"):
            vesica.circles({"cx": X, "cy": Y})
        with self.assertRaisesRegex(ValueError, "circles need fields cx cy r; missing: cy r"):
            vesica.circles(Table({"name": ["a", "b", "c"], "cx": X}))
        with self.assertRaisesRegex(ValueError, "circles have columns of different lengths: cx 3, cy 2, r 3"):
            vesica.circles({"cx": X, "cy": Y[:2], "r": R})
        with self.assertRaisesRegex(TypeError, "all float64 or all float32"):
            vesica.circles({"cx": X, "cy": Y, "r": R.astype("f4")})
        with self.assertRaisesRegex(ValueError, "one dimension"):
            vesica.points({"x": numpy.ones((2, 2)), "y": numpy.ones((2, 2))})

    @unittest.skipUnless("VESICA_PANDAS" in os.environ, "pandas need not be there")
    def test_pandas(self):
        pandas = importlib.import_module("pandas")
        frame = pandas.DataFrame({"name": ["a", "b", "c"], "r": R, "cy": Y, "cx": X})
        self.check(frame, [frame[name].to_numpy() for name in ("cx", "cy", "r")])
        self.assertEqual(vesica.points(frame[["cx", "cy"]]).numbers.tolist(), [[0, 0], [4, 4], [9, 9]])
        frame["hit"] = vesica.overlap(vesica.circles(frame), DISC)
        self.assertEqual(frame[frame.hit].name.tolist(), ["b"])


if __name__ == "__main__":
    unittest.main()
