# SPDX-License-Identifier: Apache-2.0
"""The programs of docs/detection.md run, and print what the page says."""
import doctest
import pathlib
import re
import unittest


class Pages(unittest.TestCase):
    def test_detection(self):
        text = pathlib.Path(__file__).with_name("detection.md").read_text()
        code = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
        page = doctest.DocTestParser().get_doctest(code, {}, "detection", "detection.md", 0)
        printed = []
        failed, tried = doctest.DocTestRunner().run(page, out=printed.append)
        self.assertEqual(failed, 0, "".join(printed))
        self.assertGreater(tried, 30)


if __name__ == "__main__":
    unittest.main()
