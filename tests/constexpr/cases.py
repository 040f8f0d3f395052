#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes C++ whose static assertions are the overlap lines of the corpus and the vectors that every host answers.

usage: cases.py CORPUS VECTORS [--spoil]      --spoil writes one of them, with a wrong answer: it must not compile
"""
import csv
import struct
import sys

KINDS = ('point', 'segment', 'circle', 'aabb', 'rect', 'ellipse')
FIELDS = {'point': 2, 'segment': 4, 'circle': 3, 'aabb': 4, 'rect': 6, 'ellipse': 6}
SPECIAL = {'inf': 'infinity', '-inf': '-infinity', 'nan': 'not_a_number'}


def number(value):
    return SPECIAL.get(str(value), value.hex())


def shape(kind, numbers, scalar):
    listed = ', '.join(f'static_cast<{scalar}>({number(x)})' for x in numbers[:FIELDS[kind]])
    return f'vesica::{kind.capitalize()}<{scalar}>{{{listed}}}'


def of_corpus(path):
    with open(path, newline='', encoding='utf-8') as lines:
        for row in csv.DictReader(lines):
            if row['query'] != 'overlap':
                continue
            operands = [(row[f'kind_{s}'], [float(row[f'{s}{i}'] or 0) for i in range(6)]) for s in 'ab']
            yield row['id'], 'double', operands, int(row['expected'])


def of_vectors(path):
    with open(path, encoding='utf-8') as lines:
        for place, line in enumerate(lines, 1):
            words = line.split()
            if not words or words[0] not in ('f64', 'f32'):
                continue
            operands = []
            for word in (2, 9):
                numbers = [struct.unpack('>d', bytes.fromhex(bits))[0] for bits in words[word + 1:word + 7]]
                if not 0 <= int(words[word]) < len(KINDS):
                    break
                operands.append((KINDS[int(words[word])], numbers))
            else:
                yield f'vectors.txt:{place}', 'double' if words[0] == 'f64' else 'float', operands, int(words[1])


def main(corpus, vectors, spoil):
    print('#include <limits>\n#include <vesica/overlap.hpp>\n')
    print('constexpr double infinity = std::numeric_limits<double>::infinity();')
    print('constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();')
    cases = [*of_corpus(corpus), *of_vectors(vectors)]
    written = [cases[len(cases) // 2]] if spoil else cases
    for name, scalar, operands, expected in written:
        a, b = (shape(kind, numbers, scalar) for kind, numbers in operands)
        print(f'static_assert(vesica::overlap_or_error({a}, {b}) == {1 - expected if spoil else expected}, "{name}");')
    if spoil:
        return
    print(f'static_assert({len(cases)} >= 250);')


if __name__ == '__main__':
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2], '--spoil' in sys.argv[3:])
