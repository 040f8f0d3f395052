#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the declarations for other languages, each with the headers' texts in its language's form, from
capi/vesica.json.

python3 bindings/declare [NAME...]  writes those of the named languages, or all
python3 bindings/declare --check    exits with 1 if one that is in the repository is not what the description says

A language is a module with files(description): the text of each path. Users of go, rust and small take the files from
the repository. The others are in packages alone, whose builds write them.
"""
import os
import sys

import csharp
import go
import java
import javascript
import python
import rust
import small
from description import DESCRIPTION, REPOSITORY, Description

IN_REPOSITORY = {"go": go, "rust": rust, "small": small}
LANGUAGES = {"csharp": csharp, "java": java, "javascript": javascript, "python": python, **IN_REPOSITORY}


def write(path, text):
    """Builds of several packages may write at once: each renames a file of its own."""
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_name(f"{path.name}.{os.getpid()}")
    new.write_text(text)
    new.replace(path)


def main(arguments):
    check = arguments == ["--check"]
    names = IN_REPOSITORY if check else arguments or LANGUAGES
    description = Description()
    files = {REPOSITORY / path: text for name in names for path, text in LANGUAGES[name].files(description).items()}
    stale = [path for path, text in files.items() if not path.exists() or path.read_text() != text]
    if check:
        for path in stale:
            print(f"{path} is not what {DESCRIPTION} says: run tools/refresh.sh", file=sys.stderr)
        return bool(stale)
    for path in stale:
        write(path, files[path])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
