#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The folders of include/vesica include each other in one direction only, and each is a namespace of the same name."""
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1]) / 'vesica'
folders = sorted(path.name for path in root.iterdir() if path.is_dir())
# Stages and methods stand beside the questions, in vesica itself; the others are in vesica::detail.
spaces = {name: f'vesica::{name}' for name in ('exact', 'filter', 'methods')}
faults = []
uses = {name: set() for name in folders}
for folder in folders:
    for header in sorted((root / folder).glob('*.hpp')):
        text = header.read_text()
        uses[folder].update(name for name in re.findall(r'#include <vesica/(\w+)/', text) if name != folder)
        space = spaces.get(folder, f'vesica::detail::{folder}')
        if not any(f'namespace {form}' in text for form in (space, space.removeprefix('vesica::'))):
            faults.append(f'{header}: not in namespace {space}')


def circle(folder, way):
    """The first circle of folders met from the end of a way, as text, or nothing."""
    if folder in way:
        return ' -> '.join(way[way.index(folder):] + [folder])
    return next(filter(None, (circle(name, way + [folder]) for name in sorted(uses[folder]))), None)


faults += filter(None, (circle(folder, []) for folder in folders))
for fault in faults:
    print(fault)
if not folders or not uses['nearest']:
    sys.exit('no folders found')
sys.exit(1 if faults else 0)
