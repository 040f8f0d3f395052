#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""versions.py: every file that names the release has the version of CMakeLists.txt, and those with its date one date.

versions.py VERSION DATE: writes these into all of them, the date as 2026-11-21, and opens an entry of Debian's changelog.
CHANGELOG.md is left to you; tools/refresh.sh then writes what follows from vesica.h.
"""
import datetime
import email.utils
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
VERSION = r"(\d+\.\d+\.\d+)"
# Where the version stands, in a group of each match.
PLACES = {
    "CMakeLists.txt": rf"^project\(vesica VERSION {VERSION}",
    "CITATION.cff": rf"^version: {VERSION}$",
    "bindings/csharp/Vesica.csproj": rf"<Version>{VERSION}</Version>",
    "bindings/java/README.md": rf"vesica-{VERSION}\.jar",
    "bindings/javascript/package.json": rf'"version": "{VERSION}"',
    "bindings/rust/vesica-sys/Cargo.toml": rf'^version = "{VERSION}"',
    "bindings/rust/vesica-sys/build.rs": rf'VERSION: &str = "{VERSION}"',
    "bindings/rust/vesica/Cargo.toml": rf'^(?:vesica-sys = {{ )?version = "{VERSION}"',
    "bindings/rust/Cargo.lock": rf'^version = "{VERSION}"',
    "docs/guide.md": rf"/vesica-{VERSION}\.tar",
    "packaging/conan/conandata.yml": rf'(?:^  "|/vesica-){VERSION}(?:":$|\.tar)',
    "packaging/conda/meta.yaml": rf'version = "{VERSION}"',
    "packaging/homebrew/vesica.rb": rf"/vesica-{VERSION}\.tar",
    "packaging/vcpkg/vcpkg.json": rf'"version": "{VERSION}"',
}
# These are written by other tools, or as a new entry.
OTHERS = {
    "capi/vesica.json": rf'"version": "{VERSION}"',
    "packaging/debian/changelog": rf"\Avesica \({VERSION}\)",
}
LEAST = {"packaging/conan/conandata.yml": 2, "bindings/rust/Cargo.lock": 2, "bindings/rust/vesica/Cargo.toml": 2}
HEADER, DEBIAN = "capi/include/vesica.h", "packaging/debian/changelog"
FLAGS = re.M | re.S


def text(name):
    return (ROOT / name).read_text()


def in_header(version):
    """The lines of vesica.h, as patterns with what the version wants in the place of the number."""
    major, minor, patch = map(int, version.split("."))
    numbers = {"_MAJOR": major, "_MINOR": minor, "_PATCH": patch, "": major * 10000 + minor * 100 + patch}
    return {rf"(?m)^(#define VESICA_VERSION{part}) \d+": rf"\g<1> {number}" for part, number in numbers.items()}


def faults():
    (wanted,) = re.findall(PLACES["CMakeLists.txt"], text("CMakeLists.txt"), FLAGS)
    for name, pattern in {**PLACES, **OTHERS}.items():
        versions = re.findall(pattern, text(name), FLAGS)
        if len(versions) < LEAST.get(name, 1):
            yield f"{name} names no version where one is expected"
        yield from (f"{name} is of {version}, not {wanted}" for version in versions if version != wanted)
    if not re.search(rf"(?m)^## {re.escape(wanted)}\b", text("CHANGELOG.md")):
        yield f"CHANGELOG.md has no heading {wanted}"
    header = text(HEADER)
    for pattern, line in in_header(wanted).items():
        if re.subn(pattern, line, header) != (header, 1):
            yield f"{HEADER} is not of {wanted}: {re.search(pattern, header)[0]}"
    citation = re.search(r"^date-released: (\S+)$", text("CITATION.cff"), re.M)[1]
    debian = re.search(r"^ -- .*>  (.*)$", text(DEBIAN), re.M)[1]
    if email.utils.parsedate_to_datetime(debian).date().isoformat() != citation:
        yield f"{DEBIAN} has the date {debian}, CITATION.cff {citation}"


def write(version, date):
    day = datetime.datetime.combine(datetime.date.fromisoformat(date), datetime.time(), datetime.timezone.utc)
    for name, pattern in PLACES.items():
        new = re.sub(pattern, lambda match: match[0].replace(match[1], version), text(name), flags=FLAGS)
        (ROOT / name).write_text(new)
    (ROOT / "CITATION.cff").write_text(re.sub(r"(?m)^(date-released:) .*", rf"\1 {date}", text("CITATION.cff")))
    header = text(HEADER)
    for pattern, line in in_header(version).items():
        header = re.sub(pattern, line, header)
    (ROOT / HEADER).write_text(header)
    if not text(DEBIAN).startswith(f"vesica ({version})"):
        maintainer = re.search(r"^ -- (.*>)  ", text(DEBIAN), re.M)[1]
        entry = f"vesica ({version}) unstable; urgency=medium\n\n  * New upstream release.\n\n -- {maintainer}  "
        (ROOT / DEBIAN).write_text(f"{entry}{email.utils.format_datetime(day)}\n\n{text(DEBIAN)}")
    else:
        dated = re.sub(r"(?m)^( -- .*>)  .*", rf"\1  {email.utils.format_datetime(day)}", text(DEBIAN), count=1)
        (ROOT / DEBIAN).write_text(dated)


if __name__ == "__main__":
    if len(sys.argv) == 3 and re.fullmatch(VERSION, sys.argv[1]):
        write(*sys.argv[1:])
    elif len(sys.argv) != 1:
        sys.exit(__doc__)
    found = list(faults())
    print("\n".join(found) or f"{len(PLACES) + len(OTHERS) + 2} files name one version and one date")
    sys.exit(bool(found))
