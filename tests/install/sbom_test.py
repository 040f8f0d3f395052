#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""sbom_test.py MOVED: the installed list of parts is SPDX 2.3: each field that must be there is, and each name leads to
a part; its version is that of the pkg-config file."""
import json
import pathlib
import re
import sys

moved = pathlib.Path(sys.argv[1])
document = json.loads((moved / "share/vesica/vesica.spdx.json").read_text())
text = next(moved.rglob("vesica.pc")).read_text()
version = re.search(r"^Version: (.*)$", text, re.M)[1]

assert document["spdxVersion"] == "SPDX-2.3" and document["dataLicense"] == "CC0-1.0"
assert document["SPDXID"] == "SPDXRef-DOCUMENT" and document["name"] == f"vesica-{version}"
assert re.fullmatch(r"https://[^\s#@]+", document["documentNamespace"])
assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", document["creationInfo"]["created"])
assert all(re.match("(Person|Organization|Tool): .", each) for each in document["creationInfo"]["creators"])

packages = {each["SPDXID"]: each for each in document["packages"]}
assert len(packages) == len(document["packages"])
for name, package in packages.items():
    assert re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name), name
    for field in ("name", "downloadLocation", "licenseConcluded", "licenseDeclared", "copyrightText"):
        assert package[field], (name, field)
    assert package["filesAnalyzed"] is False  # else a code of all files would be needed
    assert "@" not in json.dumps(package), package
library = packages["SPDXRef-vesica"]
assert library["versionInfo"] == version and library["licenseDeclared"] == "Apache-2.0"

said = {(each["spdxElementId"], each["relationshipType"]) for each in document["relationships"]}
assert ("SPDXRef-DOCUMENT", "DESCRIBES") in said
for each in document["relationships"]:
    for end in ("spdxElementId", "relatedSpdxElement"):
        assert each[end] in packages or each[end] == document["SPDXID"], each
print(f"SPDX: {len(packages)} packages, {len(said)} relationships")
