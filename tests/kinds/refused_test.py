# SPDX-License-Identifier: Apache-2.0
"""refused_test.py LIBRARY DESCRIPTION [--dummy KIND]: every function that takes kinds refuses kinds that it does not
know: it returns VESICA_E_KIND and touches no memory that it is given but the structs with the kinds, and an index.

The functions come from the description, capi/vesica.json, so that none can be forgotten. All other pointers lead to a
page that may be neither read nor written. --dummy: the library has a kind that overlap alone answers (dummy.hpp).
"""

import argparse
import ctypes
import faulthandler
import itertools
import json
import mmap
import os
import sys
import tempfile

E_KIND = -3
GOOD = 4  # VESICA_RECT
BAD = [-1, 10, 127, -(2**31), 2**31 - 1]
PATHS = [8, 9]  # polygons and polylines; the functions that take them:
OF_PATHS = ("vesica_field_count", "vesica_kind_name", "vesica_check", "vesica_shapes_from_records", "vesica_bounds_",
            "vesica_overlap_", "vesica_interiors_overlap_", "vesica_relation_", "vesica_contains_", "vesica_nearest_",
            "vesica_boundary_distance_", "vesica_signed_distance_",
            "vesica_within_", "vesica_cast_f", "vesica_depth_", "vesica_cast_many_", "vesica_sweep_bounds_",
            "vesica_index_build_", "vesica_index_step_", "vesica_index_select_", "vesica_index_nearest_", "vesica_index_cast_", "vesica_index_impact_time_",
            "vesica_join_f", "vesica_join_within_", "vesica_join_ratio_", "vesica_join_nearest_", "vesica_shape_area_", "vesica_area_", "vesica_iou_",
            "vesica_ratio_", "vesica_volume_ratio_", "vesica_nms_", "vesica_suppress_", "vesica_polygon_boxes_", "vesica_crossings_",
            "vesica_de9im_f", "vesica_min_area_rect_many_", "vesica_min_perimeter_rect_many_",
            "vesica_intersection_", "vesica_coverage_", "vesica_impact_time_", "vesica_manifold_")
# These know a kind before any query does; overlap is the first query.
OF_EVERY_KIND = ("vesica_field_count", "vesica_kind_name", "vesica_check", "vesica_shapes_from_records")
OVERLAP = [f"vesica_{name}{form}_{scalar}" for name in ("overlap", "interiors_overlap")
           for form in ("", "_many", "_matrix", "_select") for scalar in ("f64", "f32")]
NUMBERS = {
    "int32_t": ctypes.c_int32, "int64_t": ctypes.c_int64, "ptrdiff_t": ctypes.c_ssize_t, "uint8_t": ctypes.c_uint8,
    "uint32_t": ctypes.c_uint32, "double": ctypes.c_double, "float": ctypes.c_float, "char": ctypes.c_char,
}


def forbidden_page():
    libc = ctypes.CDLL(None, use_errno=True)
    libc.mmap.restype = ctypes.c_void_p
    libc.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, ctypes.c_int, ctypes.c_int, ctypes.c_int, ctypes.c_ssize_t]
    page = libc.mmap(None, mmap.PAGESIZE, 0, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS, -1, 0)
    assert page not in (None, ctypes.c_void_p(-1).value), "no memory for a page"
    return page


class Caller:
    def __init__(self, library, description):
        self.library = ctypes.CDLL(library)
        self.structs = {s["name"]: s for s in description["structs"]}
        self.forbidden = forbidden_page()
        self.index = self.built_index()

    def shapes(self, struct, kind, count=1, numbers=None):
        """The struct of an array, its pointers forbidden or, for the index, those of the numbers."""
        memory = (ctypes.c_uint8 * self.structs[struct]["size"])()
        for field in self.structs[struct]["fields"]:
            at = ctypes.addressof(memory) + field["offset"]
            if field["name"] == "kind":
                ctypes.c_int32.from_address(at).value = kind
            elif field["name"] == "count":
                ctypes.c_int64.from_address(at).value = count
            elif field["name"] == "field":
                for k in range(field["count"]):
                    address = self.forbidden if numbers is None else ctypes.addressof(numbers) + 8 * k
                    ctypes.c_void_p.from_address(at + 8 * k).value = address
        return memory

    def built_index(self):
        """An index of one valid rectangle."""
        numbers = (ctypes.c_double * 8)(0, 0, 1, 0, 1, 1)
        shapes = self.shapes("vesica_shapes_f64", GOOD, numbers=numbers)
        memory = []
        for name in ("vesica_index_size", "vesica_index_scratch"):
            function = getattr(self.library, name)
            function.restype, function.argtypes = ctypes.c_int64, [ctypes.c_int64]
            size = function(1)
            memory.append((mmap.mmap(-1, size), size))
        arguments = []
        for block, size in memory:
            arguments += [ctypes.c_void_p(ctypes.addressof(ctypes.c_uint8.from_buffer(block))), ctypes.c_int64(size)]
        build = self.library.vesica_index_build_f64
        build.restype = ctypes.c_int64
        assert build(shapes, ctypes.c_int32(1), *arguments) > 0, "no index"
        self.memory = memory
        return arguments[0].value

    def arguments(self, function, kinds):
        """Arguments with these kinds, one for each parameter that holds a kind; `memory` keeps them."""
        kinds, memory, arguments = iter(kinds), [], []
        for p in function["parameters"]:
            name, kind_of_number = p["name"], NUMBERS.get(p["type"])
            if holds_kind(p):
                kind = next(kinds)
                if kind_of_number is None:
                    memory.append(self.shapes(p["type"].replace("const", "").strip(" *"), kind))
                    arguments.append(ctypes.c_void_p(ctypes.addressof(memory[-1])))
                else:
                    arguments.append(ctypes.c_int32(kind))
            elif p["type"] == "const void *" and name.startswith("index"):
                arguments.append(ctypes.c_void_p(self.index))
            elif kind_of_number is None or "count" in p:
                arguments.append(ctypes.c_void_p(self.forbidden))
            else:
                arguments.append(kind_of_number(0 if name == "query" else 1))
        return arguments, memory

    def call(self, function, kinds):
        print(function["name"], *kinds, file=log, flush=True)
        called = getattr(self.library, function["name"])
        called.restype = NUMBERS.get(function["returns"], ctypes.c_void_p)
        arguments, memory = self.arguments(function, kinds)
        before = [bytes(m) for m in memory]
        result = called(*arguments)
        assert [bytes(m) for m in memory] == before, "an input was written"
        return result


def holds_kind(parameter):
    return parameter["type"].startswith("const vesica_shapes_") or (
        parameter["name"].startswith("kind") and parameter["type"] == "int32_t")


def numbers_of_kinds(function, bad):
    """Each place of a kind bad, and all of them."""
    places = sum(map(holds_kind, function["parameters"]))
    return [k for k in itertools.product((GOOD, bad), repeat=places) if bad in k]


def check_dummy(caller, kind, functions):
    """What the functions answer that know the dummy."""
    library = caller.library
    assert caller.call(functions["vesica_field_count"], [kind]) == 5
    library.vesica_kind_name.restype = ctypes.c_char_p
    assert library.vesica_kind_name(ctypes.c_int32(kind)) == b"dummy"
    for scalar, number in (("f64", ctypes.c_double), ("f32", ctypes.c_float)):
        for count in (1, 100):
            numbers, out = (number * (8 * count))(*[1.0] * (8 * count)), (ctypes.c_int64 * count)()
            assert getattr(library, f"vesica_check_{scalar}")(kind, numbers) == 0
            shapes = caller.shapes(f"vesica_shapes_{scalar}", kind)
            make = getattr(library, f"vesica_shapes_from_records_{scalar}")
            size = ctypes.sizeof(number)
            assert make(kind, ctypes.c_int64(count), numbers, ctypes.c_ssize_t(5 * size), shapes) == 0
            for other in range(kind + 1):
                others = caller.shapes(f"vesica_shapes_{scalar}", other)
                stride = library.vesica_field_count(other) * size
                assert make(other, ctypes.c_int64(1), numbers, ctypes.c_ssize_t(stride), others) == 0
                assert getattr(library, f"vesica_overlap_{scalar}")(kind, numbers, other, numbers) == 0
                assert getattr(library, f"vesica_overlap_many_{scalar}")(shapes, others, out) == 0
                assert getattr(library, f"vesica_overlap_many_{scalar}")(others, shapes, out) == 0
                row = ctypes.c_ssize_t(count)
                assert getattr(library, f"vesica_overlap_matrix_{scalar}")(others, shapes, out, row) == 0
                select = getattr(library, f"vesica_overlap_select_{scalar}")
                assert select(others, shapes, out, ctypes.c_int64(count)) == 0
            numbers[3] = float("nan")
            assert getattr(library, f"vesica_check_{scalar}")(kind, numbers) == -5
            assert getattr(library, f"vesica_overlap_{scalar}")(kind, numbers, kind, numbers) == -2


parser = argparse.ArgumentParser()
parser.add_argument("library")
parser.add_argument("description")
parser.add_argument("--dummy", type=int)
options = parser.parse_args()
faulthandler.enable()
# Its last line is the call that crashed.
log = open(os.path.join(tempfile.gettempdir(), f"vesica_refused_test.{os.getpid()}.log"), "w", encoding="utf-8")
with open(options.description, encoding="utf-8") as file:
    description = json.load(file)
functions = [f for f in description["functions"] if any(map(holds_kind, f["parameters"]))]
assert len(functions) >= 100, f"only {len(functions)} functions take kinds"
caller = Caller(options.library, description)
calls, wrong = 0, []
for function in functions:
    name = function["name"]
    # A dummy takes the place of the polygons' kinds, which then follow it.
    refused = BAD + (PATHS if not name.startswith(OF_PATHS) else []) if options.dummy is None else [options.dummy]
    for bad in refused:
        if bad == options.dummy and (name in OVERLAP or name.startswith(OF_EVERY_KIND)):
            continue
        for kinds in numbers_of_kinds(function, bad):
            calls += 1
            result = caller.call(function, kinds)
            if result != (None if name == "vesica_kind_name" else E_KIND):
                wrong.append(f"{name} of kinds {kinds} returns {result}")
if options.dummy is not None:
    check_dummy(caller, options.dummy, {f["name"]: f for f in functions})
print(*wrong, sep="\n", end="\n" if wrong else "")
log.close()
os.remove(log.name)
print(f"{calls} calls of {len(functions)} functions, {len(wrong)} wrong")
sys.exit(1 if wrong else 0)
