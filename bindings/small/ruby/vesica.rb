# frozen_string_literal: true

# SPDX-License-Identifier: Apache-2.0
require 'fiddle/import'
require_relative 'vesica_declarations'

# Exact overlap queries between plain 2D shapes. Touching counts.
module Vesica
  extend Fiddle::Importer
  dlload 'libvesica.so.0'

  extern 'int vesica_version()'
  raise LoadError, "vesica #{vesica_version} is older than #{VERSION}" if vesica_version < VERSION

  DECLARATIONS.each { |declaration| extern declaration }

  # A distance, the point (ax, ay) of a, and the point (bx, by) of b.
  ClosestPoints = Struct.new(:distance, :ax, :ay, :bx, :by)

  # A vesica_shapes_f64 is filled in and read by the library alone.
  SHAPES_SIZE = 112

  # An error of the library.
  class Error < ArgumentError
    attr_reader :code

    def initialize(code)
      super(Vesica.vesica_strerror(code).to_s)
      @code = code
    end
  end

  class << self
    # Do two shapes, arrays of their numbers, share a point?
    def overlap(kind_a, a, kind_b, b)
      checked(vesica_overlap_f64(kind_a, packed('d*', kind_a, a), kind_b, packed('d*', kind_b, b))) == 1
    end

    # The same of floats.
    def overlap_float(kind_a, a, kind_b, b)
      checked(vesica_overlap_f32(kind_a, packed('f*', kind_a, a), kind_b, packed('f*', kind_b, b))) == 1
    end

    # How far apart are two shapes, and which of their points are closest?
    def nearest(kind_a, a, kind_b, b)
      out = "\0" * 40
      checked(vesica_nearest_f64(kind_a, packed('d*', kind_a, a), kind_b, packed('d*', kind_b, b), out))
      ClosestPoints.new(*out.unpack('d5'))
    end

    # Two arrays of shapes in step, each a string of their numbers as [...].pack('d*') makes it, which is not copied; an
    # array of one shape is repeated. `out`, a string, gets a byte 1 where they overlap, else 0; returns how many do.
    # Where a shape is invalid, `out` has 0 for it and every other answer, and the error is raised.
    def overlap_many(kind_a, a, kind_b, b, out)
      count_a, view_a = view(kind_a, a)
      count_b, view_b = view(kind_b, b)
      count = [count_a, count_b].min.zero? ? 0 : [count_a, count_b].max
      raise ArgumentError, "out is shorter than #{count}" if out.bytesize < count

      out.setbyte(0, 0) if count.positive? # not frozen, and its bytes are shared with no other string
      checked(vesica_overlap_many_f64(view_a, view_b, out))
    end

    private

    def packed(format, kind, numbers)
      raise ArgumentError, "too few numbers for a shape of kind #{kind}" if numbers.size < vesica_field_count(kind)

      numbers.pack(format)
    end

    def view(kind, numbers)
      size = checked(vesica_field_count(kind)) * Fiddle::SIZEOF_DOUBLE
      count = numbers.bytesize / size
      bytes = "\0" * SHAPES_SIZE
      checked(vesica_shapes_from_records_f64(kind, count, numbers, size, bytes))
      [count, bytes]
    end

    def checked(answer)
      raise Error, answer if answer.negative?

      answer
    end
  end
end
