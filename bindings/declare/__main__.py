#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the declarations of every package, each with the headers' texts in its language's form, from capi/vesica.json.

python3 bindings/declare          writes them
python3 bindings/declare --check  exits with 1 if one is not what the description says

A language is a module with files(description): the text of each path.
"""
import sys

import csharp
import go
import java
import javascript
import python
import rust
import small
from description import DESCRIPTION, REPOSITORY, Description

LANGUAGES = (csharp, go, java, javascript, python, rust, small)


def main(arguments):
    description = Description()
    files = {REPOSITORY / path: text for language in LANGUAGES for path, text in language.files(description).items()}
    stale = [path for path, text in files.items() if not path.exists() or path.read_text() != text]
    if arguments == ["--check"]:
        for path in stale:
            print(f"{path} is not what {DESCRIPTION} says: run tools/refresh.sh", file=sys.stderr)
        return bool(stale)
    for path in stale:
        path.write_text(files[path])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
