#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every file that names the release has the version of CMakeLists.txt, and those with its date have one date."""
import email.utils
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
VERSION = r"(\d+\.\d+\.\d+)"
# Where the version stands, in a group of each match.
PLACES = {
    "CMakeLists.txt": rf"^project\(vesica VERSION {VERSION}",
    "CHANGELOG.md": rf"\A.*?^## {VERSION}",
    "CITATION.cff": rf"^version: {VERSION}$",
    "bindings/csharp/Vesica.csproj": rf"<Version>{VERSION}</Version>",
    "bindings/java/README.md": rf"vesica-{VERSION}\.jar",
    "bindings/javascript/package.json": rf'"version": "{VERSION}"',
    "bindings/rust/vesica-sys/Cargo.toml": rf'^version = "{VERSION}"',
    "bindings/rust/vesica-sys/build.rs": rf'VERSION: &str = "{VERSION}"',
    "bindings/rust/vesica/Cargo.toml": rf'^(?:vesica-sys = {{ )?version = "{VERSION}"',
    "bindings/rust/Cargo.lock": rf'^version = "{VERSION}"',
    "capi/vesica.json": rf'"version": "{VERSION}"',
    "packaging/conan/conandata.yml": rf'^  "{VERSION}":$|/vesica-{VERSION}\.tar',
    "packaging/conda/meta.yaml": rf'version = "{VERSION}"',
    "packaging/homebrew/vesica.rb": rf"/vesica-{VERSION}\.tar",
    "packaging/vcpkg/vcpkg.json": rf'"version": "{VERSION}"',
    "packaging/debian/changelog": rf"\Avesica \({VERSION}\)",
}
LEAST = {"packaging/conan/conandata.yml": 2, "bindings/rust/Cargo.lock": 2, "bindings/rust/vesica/Cargo.toml": 2}


def found(name):
    matches = re.finditer(PLACES[name], (ROOT / name).read_text(), re.M | re.S)
    return [next(filter(None, match.groups())) for match in matches]


wanted = found("CMakeLists.txt")
assert len(wanted) == 1, wanted
faults = []
for name in PLACES:
    versions = found(name)
    if len(versions) < LEAST.get(name, 1):
        faults.append(f"{name} names no version where one is expected")
    faults += [f"{name} is of {version}, not {wanted[0]}" for version in versions if version != wanted[0]]

citation = re.search(r"^date-released: (\S+)$", (ROOT / "CITATION.cff").read_text(), re.M)[1]
debian = re.search(r"^ -- .*>  (.*)$", (ROOT / "packaging/debian/changelog").read_text(), re.M)[1]
if email.utils.parsedate_to_datetime(debian).date().isoformat() != citation:
    faults.append(f"packaging/debian/changelog has the date {debian}, CITATION.cff {citation}")

print("\n".join(faults) or f"{len(PLACES)} files name {wanted[0]} of {citation}")
sys.exit(bool(faults))
