# SPDX-License-Identifier: Apache-2.0
"""The README's example runs, and gives what its comments say."""
import pathlib
import re
import unittest


class Readme(unittest.TestCase):
    def test_example(self):
        text = pathlib.Path(__file__).with_name("README.md").read_text()
        (example,) = re.findall(r"```python\n(.*?)```", text, re.DOTALL)
        names = {}
        exec(example, names)
        for line in example.splitlines():
            code, _, said = line.partition("#")
            if said.startswith((" True", " 5.33", " array([ True,  True])", " (0, Impact(t=")):
                given = repr(eval(code, names))
                self.assertTrue(given.startswith(re.split(r"\.\.\.|: ", said.strip())[0]), f"{line}: {given}")


if __name__ == "__main__":
    unittest.main()
