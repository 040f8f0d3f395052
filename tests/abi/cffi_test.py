# SPDX-License-Identifier: Apache-2.0
"""cffi_test.py LIBRARY METHODS: cffi reads capi/*.cdef, lays structs out as capi/vesica.json says, and calls."""
import json
import pathlib
import sys

try:
    import cffi
except ImportError:
    sys.exit("cffi_test: no cffi (Debian: python3-cffi): nothing can be checked")

CAPI = pathlib.Path(__file__).resolve().parents[2] / "capi"
ffi = cffi.FFI()
ffi.cdef((CAPI / "vesica.cdef").read_text())
ffi.cdef((CAPI / "vesica_methods.cdef").read_text())
vesica, methods = [ffi.dlopen(path) for path in sys.argv[1:3]]
description = json.loads((CAPI / "vesica.json").read_text())

for entry in description["constants"]:
    assert getattr(vesica, entry["name"]) == entry["value"], entry
for entry in description["structs"]:
    assert ffi.sizeof(entry["name"]) == entry["size"], entry
    assert ffi.alignof(entry["name"]) == entry["alignment"], entry
    for field in entry["fields"]:
        assert ffi.offsetof(entry["name"], field["name"]) == field["offset"], (entry["name"], field)
for entry in description["functions"]:
    library = methods if entry["header"] == "vesica_methods.h" else vesica
    function = getattr(library, entry["name"])
    assert len(ffi.typeof(function).args) == len(entry["parameters"]), entry

# A unit square about the origin; a disc that touches its right side from outside, and one a hair farther.
square = ffi.new("vesica_rect_f64 *", {"ux": 1, "hx": 0.5, "hy": 0.5})
disc = ffi.new("vesica_circle_f64 *", {"cx": 1.5, "r": 1})
assert vesica.vesica_overlap_circle_rect_f64(disc, square) == 1
disc.cx = 1.5000000000000002
assert vesica.vesica_overlap_circle_rect_f64(disc, square) == 0
disc.r = float("nan")
assert vesica.vesica_overlap_circle_rect_f64(disc, square) == vesica.VESICA_E_SHAPE
corners = ffi.new("double[8]")
assert methods.vesica_method_rect_corners_f64(square, corners) == 0
assert list(corners) == [-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5]
assert ffi.string(vesica.vesica_kind_name(vesica.VESICA_ELLIPSE)) == b"ellipse"

# A batch over structs in one C array: discs of radius 1 about 0, 1, 2 ... against the one about 0.
discs = ffi.new("vesica_circle_f64[5]", [{"cx": i, "r": 1} for i in range(5)])
one, many = ffi.new("vesica_shapes_f64 *"), ffi.new("vesica_shapes_f64 *")
size = ffi.sizeof("vesica_circle_f64")
assert vesica.vesica_shapes_from_records_f64(vesica.VESICA_CIRCLE, 1, discs, size, one) == 0
assert vesica.vesica_shapes_from_records_f64(vesica.VESICA_CIRCLE, 5, discs, size, many) == 0
out = ffi.new("uint8_t[5]")
assert vesica.vesica_overlap_many_f64(one, many, out) == 3
assert list(out) == [1, 1, 1, 0, 0]
print("cffi", cffi.__version__, "reads", len(description["functions"]), "functions")
