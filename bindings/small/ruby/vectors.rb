# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0
# vectors.rb FILE: the shared vectors (bindings/vectors) by vesica.rb. Exit status 0 when all answers are right.
require_relative 'vesica'

Row = Struct.new(:line, :expected, :a, :b)

def check(line, answer, expected)
  return if answer == expected

  puts "line #{line}: #{answer}, not #{expected}"
  $wrong = true
end

# What the block returns, or the code of its error.
def answer
  result = yield
  { true => 1, false => 0 }.fetch(result, result)
rescue Vesica::Error => e
  e.code
end

def numbers(words)
  words.map { |word| [word].pack('H16').unpack1('G') }
end

calls = 0
batch = []
File.foreach(ARGV[0]).with_index(1) do |text, line|
  next if text.start_with?('#')

  what, *words = text.split
  expected, kind_a, kind_b = words.values_at(0, 1, 8).map(&:to_i)
  a = numbers(words[2, 6])
  b = numbers(words[9, 6])
  if what == 'many'
    batch << Row.new(line, expected, a, b)
  else
    call = what == 'f64' ? :overlap : :overlap_float
    check(line, answer { Vesica.public_send(call, kind_a, a, kind_b, b) }, expected)
    calls += 1
  end
end

out = "\0" * batch.size
many = lambda do |rows|
  rects = rows.flat_map(&:a).pack('d*')
  ellipses = rows.flat_map(&:b).pack('d*')
  answer { Vesica.overlap_many(Vesica::RECT, rects, Vesica::ELLIPSE, ellipses, out) }
end
valid = batch.take_while { |row| row.expected >= 0 }
check('count', many.call(valid), valid.sum(&:expected))
# With an invalid element, an error: and yet every valid one has its answer.
check('error', many.call(batch), -2)
batch.each_with_index { |row, i| check(row.line, out.getbyte(i), [row.expected, 0].max) }

begin
  Vesica.overlap(Vesica::POINT, [Float::NAN, 0], Vesica::CIRCLE, [0, 0, 1])
rescue Vesica::Error => e
  puts "NaN: #{e.message}"
end
closest = Vesica.nearest(Vesica::AABB, [0, 0, 2, 2], Vesica::CIRCLE, [6, 1, 1])
puts 'nearest: as in C' if closest.to_a == [3, 2, 1, 5, 1]
puts "#{calls} calls, #{batch.size} in a batch"
exit !$wrong
