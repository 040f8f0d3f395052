# SPDX-License-Identifier: Apache-2.0
"""The programs of docs/cookbook.md, detection.md and planning.md run, and print what the pages say."""
import doctest
import pathlib
import re
import unittest


class Pages(unittest.TestCase):
    def test_programs(self):
        for name in ("cookbook.md", "detection.md", "planning.md"):
            text = pathlib.Path(__file__).with_name(name).read_text()
            code = "\n".join(re.findall(r"```python\n(.*?)```", text, re.DOTALL))
            page = doctest.DocTestParser().get_doctest(code, {}, name, name, 0)
            printed = []
            failed, tried = doctest.DocTestRunner().run(page, out=printed.append)
            self.assertEqual(failed, 0, "".join(printed))
            self.assertGreater(tried, 20)


if __name__ == "__main__":
    unittest.main()
