-- SPDX-License-Identifier: Apache-2.0
-- Vesica by LuaJIT's ffi: copy this file and capi/vesica.cdef beside it. `vesica.c` has every function and constant, as
-- in vesica.h.
local ffi = require("ffi")
local needed = 100 -- the least version that this file needs

local directory = debug.getinfo(1, "S").source:match("^@(.*/)") or ""
local cdef = assert(io.open(directory .. "vesica.cdef"))
ffi.cdef(cdef:read("*a"))
cdef:close()
local c = ffi.load("libvesica.so.0")
if c.vesica_version() < needed then
  error(("vesica %d is older than %d"):format(c.vesica_version(), needed))
end

local vesica = {c = c}

-- An error is a table: its code, and by tostring the meaning.
local failure = {__tostring = function(self) return ffi.string(c.vesica_strerror(self.code)) end}

-- The answer of any function as a Lua number, or its error raised.
function vesica.checked(answer)
  if answer < 0 then error(setmetatable({code = tonumber(answer)}, failure), 2) end
  return tonumber(answer)
end

local kinds = {}
for kind, name in pairs({[0] = "point", "segment", "circle", "aabb", "rect", "ellipse", "capsule", "round_rect"}) do
  for _, scalar in ipairs({"f64", "f32"}) do
    kinds[tonumber(ffi.typeof("vesica_" .. name .. "_" .. scalar))] = {kind = kind, scalar = scalar}
  end
end
local number = {f64 = ffi.typeof("const double *"), f32 = ffi.typeof("const float *")}

-- Do two shapes, structs of one scalar type such as ffi.new("vesica_rect_f64"), share a point? Touching counts.
function vesica.overlap(a, b)
  local of_a, of_b = kinds[tonumber(ffi.typeof(a))], kinds[tonumber(ffi.typeof(b))]
  assert(of_a and of_b and of_a.scalar == of_b.scalar, "two shapes of one scalar type are needed")
  local pointer = number[of_a.scalar]
  local call = c["vesica_overlap_" .. of_a.scalar]
  return vesica.checked(call(of_a.kind, ffi.cast(pointer, a), of_b.kind, ffi.cast(pointer, b))) == 1
end

-- How far apart are two shapes, and which of their points are closest? A vesica_closest_points of their scalar type.
function vesica.nearest(a, b)
  local of_a, of_b = kinds[tonumber(ffi.typeof(a))], kinds[tonumber(ffi.typeof(b))]
  assert(of_a and of_b and of_a.scalar == of_b.scalar, "two shapes of one scalar type are needed")
  local pointer, out = number[of_a.scalar], ffi.new("vesica_closest_points_" .. of_a.scalar)
  local call = c["vesica_nearest_" .. of_a.scalar]
  vesica.checked(call(of_a.kind, ffi.cast(pointer, a), of_b.kind, ffi.cast(pointer, b), out))
  return out
end

local arrays = setmetatable({}, {__mode = "k"}) -- A view only points to its array: so that lives as long.

-- The library's view of `count` structs in an array such as ffi.new("vesica_rect_f64[?]", n).
function vesica.shapes_f64(kind, array, count)
  local view = ffi.new("vesica_shapes_f64")
  vesica.checked(c.vesica_shapes_from_records_f64(kind, count, array, ffi.sizeof(array[0]), view))
  arrays[view] = array
  return view
end

-- Writes 1 or 0 for each of two views in step to out (uint8_t[?] of the larger count); a view of one shape is repeated.
-- Returns how many overlap. Where a shape is invalid, out has 0 for it and every other answer, and the error is raised.
function vesica.overlap_many_f64(a, b, out)
  return vesica.checked(c.vesica_overlap_many_f64(a, b, out))
end

return vesica
