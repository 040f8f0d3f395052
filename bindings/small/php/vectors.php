<?php
// SPDX-License-Identifier: Apache-2.0
// vectors.php FILE: the shared vectors (bindings/vectors) by Vesica.php. Exit status 0 when all answers are right.
declare(strict_types=1);

require __DIR__ . '/Vesica.php';

$allRight = true;
function check(int|string $line, int $answer, int $expected): void
{
    global $allRight;
    if ($answer !== $expected) {
        echo "line $line: $answer, not $expected\n";
        $allRight = false;
    }
}

/** What the call returns, or the code of its error. */
function answer(callable $call, mixed ...$arguments): int
{
    try {
        return (int) $call(...$arguments);
    } catch (VesicaException $e) {
        return $e->getCode();
    }
}

$vesica = new Vesica();
$numbers = fn (array $words) => array_map(fn ($word) => unpack('E', hex2bin($word))[1], $words);
[$calls, $batch] = [0, []];
foreach (file($argv[1], FILE_IGNORE_NEW_LINES) as $index => $text) {
    if ($text[0] === '#') {
        continue;
    }
    $words = explode(' ', $text);
    [$expected, $kindA, $kindB] = [(int) $words[1], (int) $words[2], (int) $words[9]];
    [$a, $b] = [$numbers(array_slice($words, 3, 6)), $numbers(array_slice($words, 10, 6))];
    if ($words[0] === 'many') {
        $batch[] = ['line' => $index + 1, 'expected' => $expected, 'a' => $a, 'b' => $b];
        continue;
    }
    $call = $words[0] === 'f64' ? $vesica->overlap(...) : $vesica->overlapFloat(...);
    check($index + 1, answer($call, $kindA, $a, $kindB, $b), $expected);
    ++$calls;
}

// Rectangles in an array of FFI's, ellipses in a string.
$many = function (int $count, FFI\CData $out) use ($vesica, $batch): int {
    $rects = FFI::new('double[' . 6 * $count . ']');
    foreach (array_merge(...array_column(array_slice($batch, 0, $count), 'a')) as $i => $number) {
        $rects[$i] = $number;
    }
    $ellipses = pack('d*', ...array_merge(...array_column(array_slice($batch, 0, $count), 'b')));
    return $vesica->overlapMany(Vesica::RECT, $rects, Vesica::ELLIPSE, $ellipses, $out);
};
$out = FFI::new('uint8_t[' . count($batch) . ']');
$expected = array_column($batch, 'expected');
$valid = array_search(-2, $expected, true);
check('count', $many($valid, $out), array_sum(array_slice($expected, 0, $valid)));
// With an invalid element, an error: and yet every valid one has its answer.
check('error', answer($many, count($batch), $out), -2);
foreach ($batch as $i => $row) {
    check($row['line'], $out[$i], max($row['expected'], 0));
}

try {
    $vesica->overlap(Vesica::POINT, [NAN, 0.0], Vesica::CIRCLE, [0.0, 0.0, 1.0]);
} catch (VesicaException $e) {
    echo "NaN: {$e->getMessage()}\n";
}
if (array_values($vesica->nearest(Vesica::AABB, [0, 0, 2, 2], Vesica::CIRCLE, [6, 1, 1])) == [3, 2, 1, 5, 1]) {
    echo "nearest: as in C\n";
}
echo "$calls calls, ", count($batch), " in a batch\n";
exit($allRight ? 0 : 1);
