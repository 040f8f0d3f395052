# SPDX-License-Identifier: Apache-2.0
"""Whatever is passed, the answer is a result or an exception of Python's: the process survives."""
import math
import os
import random
import unittest
import warnings

import numpy
import vesica


def any_value(draw):
    numbers = [0, 1, -1, 0.5, math.nan, math.inf, -0.0, 5e-324, 1.7e308, 1e-200]
    size = draw.choice([0, 1, 2, 3, 4, 5, 6, 7])
    count = draw.choice([0, 1, 2, 3])
    array = numpy.array([[draw.choice(numbers) for _ in range(size)] for _ in range(count)])
    kind = draw.choice(list(vesica.Kind))
    fields = len(vesica.FIELDS[kind])
    rows = [[draw.choice(numbers) for _ in range(fields)] for _ in range(count)]
    with numpy.errstate(all="ignore"):
        made = vesica.shapes(kind, numpy.array(rows, draw.choice(["f8", "f4"])).reshape(count, fields))
    frozen = numpy.zeros(count, draw.choice([bool, "u1", "f8", "f4"]))
    frozen.flags.writeable = draw.random() < 0.7
    values = [made, made, made, made, made[0] if count else made, made[::-1]]
    values += [array, array[::-1], array.tolist(), frozen, (1, 0)]
    values += [numpy.zeros((count, count)), None, "text", b"bytes", -1, 3, 2**70, kind, draw.choice(numbers), object()]
    return draw.choice(values)


class AnyArguments(unittest.TestCase):
    def test_functions(self):
        seed = random.randrange(1 << 30)
        draw = random.Random(seed)
        calls = int(os.environ.get("VESICA_CALLS", 5_000))
        names = [name for name in vesica.__all__ if callable(getattr(vesica, name)) and name.islower() and name != "c"]
        answered = 0
        for _ in range(calls):
            function = getattr(vesica, draw.choice([*names, "Index"]))
            arguments = [any_value(draw) for _ in range(draw.choice([1, 2, 2, 2, 3]))]
            try:
                with numpy.errstate(all="ignore"), warnings.catch_warnings():
                    warnings.simplefilter("ignore")
                    result = function(*arguments)
                    if isinstance(result, vesica.Index):
                        result.join()
                        result.select(arguments[0])
                        result.cast(*arguments)
                answered += 1
            except (TypeError, ValueError, OverflowError):
                pass
            except BaseException as error:
                raise AssertionError(f"seed {seed}: {function.__name__}{arguments}") from error
        self.assertGreater(answered, calls // 100)


if __name__ == "__main__":
    unittest.main()
