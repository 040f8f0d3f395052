<?php
// SPDX-License-Identifier: Apache-2.0
declare(strict_types=1);

/** An error of the library: its meaning and its code. */
final class VesicaException extends InvalidArgumentException
{
}

/** Exact overlap queries between plain 2D shapes. Touching counts. Copy this file and capi/vesica.cdef beside it. */
final class Vesica
{
    /** Of the declarations below. */
    const VERSION = 100;

    const POINT = 0, SEGMENT = 1, CIRCLE = 2, AABB = 3, RECT = 4, ELLIPSE = 5, CAPSULE = 6, ROUND_RECT = 7;

    /** Every function, constant and struct, as in vesica.h: $vesica->c->vesica_version(). */
    public readonly FFI $c;

    public function __construct(string $library = 'libvesica.so.0')
    {
        $version = FFI::cdef('int32_t vesica_version(void);', $library)->vesica_version();
        if ($version < self::VERSION) {
            throw new RuntimeException("vesica $version is older than " . self::VERSION);
        }
        // Numbers that are read are declared as void: then a packed string can be passed, as well as FFI's arrays.
        $declarations = file_get_contents(__DIR__ . '/vesica.cdef');
        $declarations = preg_replace('/const (double|float|uint8_t) \*/', 'const void *', $declarations);
        $this->c = FFI::cdef($declarations, $library);
    }

    /** Do two shapes, lists of their numbers, share a point? */
    public function overlap(int $kindA, array $a, int $kindB, array $b): bool
    {
        [$a, $b] = [$this->packed('d*', $kindA, $a), $this->packed('d*', $kindB, $b)];
        return $this->checked($this->c->vesica_overlap_f64($kindA, $a, $kindB, $b)) === 1;
    }

    /** The same of floats. */
    public function overlapFloat(int $kindA, array $a, int $kindB, array $b): bool
    {
        [$a, $b] = [$this->packed('f*', $kindA, $a), $this->packed('f*', $kindB, $b)];
        return $this->checked($this->c->vesica_overlap_f32($kindA, $a, $kindB, $b)) === 1;
    }

    /** How far apart are two shapes, and where? ['distance' => ..., 'ax' => ..., 'ay', 'bx', 'by']. */
    public function nearest(int $kindA, array $a, int $kindB, array $b): array
    {
        [$a, $b] = [$this->packed('d*', $kindA, $a), $this->packed('d*', $kindB, $b)];
        $out = $this->c->new('vesica_closest_points_f64');
        $this->checked($this->c->vesica_nearest_f64($kindA, $a, $kindB, $b, FFI::addr($out)));
        $numbers = [$out->distance, $out->ax, $out->ay, $out->bx, $out->by];
        return array_combine(['distance', 'ax', 'ay', 'bx', 'by'], $numbers);
    }

    /**
     * Two arrays of shapes in step; an array of one is repeated. An array is a string, pack('d*', ...), or made by
     * FFI::new('double[...]'); neither is copied. $out, of FFI::new('uint8_t[...]'), gets 1 where they overlap, else 0;
     * returns how many do. Where a shape is invalid, $out has 0 for it and every other answer, and the error is thrown.
     */
    public function overlapMany(int $kindA, string|FFI\CData $a, int $kindB, string|FFI\CData $b, FFI\CData $out): int
    {
        [$viewA, $viewB] = [$this->view($kindA, $a), $this->view($kindB, $b)];
        $count = $viewA->count === 0 || $viewB->count === 0 ? 0 : max($viewA->count, $viewB->count);
        if (FFI::sizeof($out) < $count) {
            throw new LengthException("\$out is shorter than $count");
        }
        return $this->checked($this->c->vesica_overlap_many_f64(FFI::addr($viewA), FFI::addr($viewB), $out));
    }

    private function packed(string $format, int $kind, array $numbers): string
    {
        if (count($numbers) < $this->c->vesica_field_count($kind)) {
            throw new LengthException("too few numbers for a shape of kind $kind");
        }
        return pack($format, ...$numbers);
    }

    private function view(int $kind, string|FFI\CData $numbers): FFI\CData
    {
        $size = $this->checked($this->c->vesica_field_count($kind)) * 8;
        $count = intdiv(is_string($numbers) ? strlen($numbers) : FFI::sizeof($numbers), $size);
        $view = $this->c->new('vesica_shapes_f64');
        $this->checked($this->c->vesica_shapes_from_records_f64($kind, $count, $numbers, $size, FFI::addr($view)));
        return $view;
    }

    private function checked(int $answer): int
    {
        if ($answer < 0) {
            throw new VesicaException($this->c->vesica_strerror($answer), $answer);
        }
        return $answer;
    }
}
