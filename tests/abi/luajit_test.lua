-- SPDX-License-Identifier: Apache-2.0
-- luajit_test.lua LIBRARY CDEF: LuaJIT reads capi/vesica.cdef as it stands, finds every function, and calls.
local ffi = require("ffi")
local file = assert(io.open(arg[2]))
local cdef = file:read("*a")
file:close()
ffi.cdef(cdef)
local vesica = ffi.load(arg[1])

local functions = 0
for name in cdef:gmatch("[ *](vesica_[%w_]+)%(") do
  assert(vesica[name] ~= nil)
  functions = functions + 1
end
assert(functions >= 93, functions)
local constants = 0
for name, value in cdef:gmatch("(VESICA_[%w_]+) = (%-?%d+),") do
  assert(vesica[name] == tonumber(value), name)
  assert(vesica[name:lower()]() == tonumber(value), name)
  constants = constants + 1
end
assert(constants >= 19, constants)
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
assert(ffi.string(vesica.vesica_strerror(status)):find("a shape is invalid", 1, true) == 1)
print(jit.version, "finds", functions, "functions")
