-- SPDX-License-Identifier: Apache-2.0
-- vectors.lua FILE: the shared vectors (bindings/vectors) by vesica.lua. Exit status 0 when all answers are right.
local ffi = require("ffi")
local vesica = require("vesica")

local all_right = true
local function check(line, answer, expected)
  if answer ~= expected then
    print(("line %s: %d, not %d"):format(line, answer, expected))
    all_right = false
  end
end

-- What the call returns, or its error's code.
local function answer(call, ...)
  local success, result = pcall(call, ...)
  if not success then return assert(result.code, result) end
  return tonumber(result)
end

local function double(hex)
  local words = ffi.new("uint32_t[2]")
  words[ffi.abi("le") and 1 or 0] = tonumber(hex:sub(1, 8), 16)
  words[ffi.abi("le") and 0 or 1] = tonumber(hex:sub(9), 16)
  return ffi.cast("double *", words)[0]
end

-- Flat numbers, whose kinds are known at run time only, are passed as in C.
local function overlap(what, kind_a, a, kind_b, b)
  local array = what == "f64" and "double[6]" or "float[6]"
  local call = vesica.c["vesica_overlap_" .. what]
  return vesica.checked(call(kind_a, ffi.new(array, a), kind_b, ffi.new(array, b)))
end

local function check_batch(batch)
  local rects = ffi.new("vesica_rect_f64[?]", #batch)
  local ellipses = ffi.new("vesica_ellipse_f64[?]", #batch)
  local out = ffi.new("uint8_t[?]", #batch)
  local valid, hits = nil, 0
  for i, row in ipairs(batch) do
    rects[i - 1] = row.a
    ellipses[i - 1] = row.b
    if row.expected < 0 then valid = valid or i - 1 end
    if not valid then hits = hits + row.expected end
  end
  local function many(count)
    local a = vesica.shapes_f64(vesica.c.VESICA_RECT, rects, count)
    return vesica.overlap_many_f64(a, vesica.shapes_f64(vesica.c.VESICA_ELLIPSE, ellipses, count), out)
  end
  check("count", many(valid), hits)
  -- With an invalid element, an error: and yet every valid one has its answer.
  check("error", answer(many, #batch), vesica.c.VESICA_E_SHAPE)
  for i, row in ipairs(batch) do check(row.line, out[i - 1], math.max(row.expected, 0)) end
end

local calls, batch, line = 0, {}, 0
for text in io.lines(arg[1]) do
  line = line + 1
  if text:sub(1, 1) ~= "#" then
    local words = {}
    for word in text:gmatch("%S+") do table.insert(words, word) end
    local what, expected, kind_a, kind_b = words[1], tonumber(words[2]), tonumber(words[3]), tonumber(words[10])
    local a, b = {}, {}
    for i = 1, 6 do a[i], b[i] = double(words[3 + i]), double(words[10 + i]) end
    if what == "many" then
      table.insert(batch, {line = line, expected = expected, a = a, b = b})
    else
      check(line, answer(overlap, what, kind_a, a, kind_b, b), expected)
      calls = calls + 1
    end
  end
end
check_batch(batch)
local _, err = pcall(vesica.overlap, ffi.new("vesica_point_f64", 0 / 0, 0), ffi.new("vesica_circle_f64", 0, 0, 1))
print("NaN: " .. tostring(err))
local box, disc = ffi.new("vesica_aabb_f64", 0, 0, 2, 2), ffi.new("vesica_circle_f64", 6, 1, 1)
local p = vesica.nearest(box, disc)
if p.distance == 3 and p.ax == 2 and p.ay == 1 and p.bx == 5 and p.by == 1 then print("nearest: as in C") end
print(("%d calls, %d in a batch"):format(calls, #batch))
os.exit(all_right and 0 or 1)
