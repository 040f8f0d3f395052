-- SPDX-License-Identifier: Apache-2.0
-- luajit_test.lua LIBRARY CDEF METHODS CDEF: LuaJIT reads capi/*.cdef as they stand, finds every function, and calls.
local ffi = require("ffi")

-- A library with its declarations read; how many functions and constants these have.
local function load(path, declarations)
  local file = assert(io.open(declarations))
  local cdef = file:read("*a")
  file:close()
  ffi.cdef(cdef)
  local library, functions, constants = ffi.load(path), 0, 0
  for name in cdef:gmatch("[ *](vesica_[%w_]+)%(") do
    assert(library[name] ~= nil)
    functions = functions + 1
  end
  for name, value in cdef:gmatch("(VESICA_[%w_]+) = (%-?%d+),") do
    assert(library[name] == tonumber(value), name)
    constants = constants + 1
  end
  return library, functions, constants
end

local vesica, functions, constants = load(arg[1], arg[2])
assert(functions >= 121 and constants >= 27)
local methods, named, limits = load(arg[3], arg[4])
assert(named >= 42 and limits >= 8)
assert(ffi.sizeof("vesica_rect_f64") == 48)
assert(ffi.offsetof("vesica_shapes_f32", "field") == 24)

-- A unit square about the origin; a disc that touches its right side from outside, and one a hair farther.
local square = ffi.new("vesica_rect_f64", {ux = 1, hx = 0.5, hy = 0.5})
local disc = ffi.new("vesica_circle_f64", {cx = 1.5, r = 1})
assert(vesica.vesica_overlap_circle_rect_f64(disc, square) == 1)
disc.cx = 1.5000000000000002
assert(vesica.vesica_overlap_circle_rect_f64(disc, square) == 0)
disc.r = 0 / 0
local status = vesica.vesica_overlap_circle_rect_f64(disc, square)
assert(status == vesica.VESICA_E_SHAPE)
local corners = ffi.new("double[8]")
assert(methods.vesica_method_rect_corners_f64(square, corners) == 0 and corners[0] == -0.5 and corners[2] == 0.5)
assert(ffi.string(vesica.vesica_strerror(status)):find("a shape is invalid", 1, true) == 1)
print(jit.version, "finds", functions + named, "functions")
