#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The kernels' loops as llvm-mca models them: cycles a vector, the busiest unit, and the ratio to the unfiltered kernel.

usage: model.py MCA OBJDUMP KERNELS YARDSTICKS PROCESSOR...

KERNELS and YARDSTICKS are two object files of one instruction set: src/isa/<set>.cpp and bench/batch/unfiltered/<set>.cpp.
The figures depend on the compiler and the model alone, on no machine. The model has no caches and predicts every jump.
"""
import json
import re
import subprocess
import sys

SHAPES = ('Rect', 'Ellipse', 'Circle')
PAIRS = (('Rect', 'Rect'), ('Rect', 'Ellipse'), ('Circle', 'Ellipse'), ('Ellipse', 'Ellipse'))
SCALARS = (('float', 'f32'), ('double', 'f64'))
KERNEL = re.compile(r'answer_vectors<.*?(\w+), vesica::(\w+), vesica::(\w+), (\w+), \(vesica::Repeat\)(\d)>')
CHECKED = re.compile(r'answer_checked<vesica::(\w+), vesica::(\w+), (\w+)>')
PACKED = re.compile(r'answer_packed<.*?(\w+), vesica::(\w+), (\w+), \(vesica::Repeat\)(\d)>')
YARDSTICK = re.compile(r'answer<vesica::(\w+), vesica::(\w+), (\w+), (\w+)>')
INSTRUCTION = re.compile(r'^\s*([0-9a-f]+):\s+(\S.*)$')
JUMP = re.compile(r'^(?:j\w+|b|b\.\w+|cbn?z|tbn?z)\s.*?\b([0-9a-f]+) <')


def functions(objdump, path):
    """Demangled name -> [(address, instruction)]."""
    comment = r'\s+//' if 'aarch64' in objdump else r'\s+#'
    text = subprocess.run([objdump, '-dC', '--no-show-raw-insn', path], check=True, capture_output=True, text=True).stdout
    found, code = {}, None
    for line in text.splitlines():
        if line.endswith('>:'):
            code = found.setdefault(line.split('<', 1)[1][:-2], [])
        elif code is not None and (match := INSTRUCTION.match(line)):
            code.append((int(match[1], 16), re.split(comment, match[2])[0].strip()))
    return found


def is_vector(text):
    return re.search(r'%[xyz]mm|\bv\d+\.|\bq\d+', text) is not None


def hot_loop(code):
    """The instructions of the smallest loop with nearly all of the vector operations, without loops inside and jumps.

    A jump back to a way out is no loop: such jumps are unconditional, and loops here end with a condition.
    """
    places = {address: i for i, (address, _) in enumerate(code)}
    loops = []
    for i, (_, text) in enumerate(code):
        if (match := JUMP.match(text)) and places.get(int(match[1], 16), i + 1) <= i:
            loops.append((places[int(match[1], 16)], i))
    loops = [loop for loop in loops if not re.match(r'(jmp|b)\s', code[loop[1]][1])] or loops
    count = {loop: sum(is_vector(text) for _, text in code[loop[0]:loop[1] + 1]) for loop in loops}
    most = max(count.values())
    first, last = min((loop for loop in loops if count[loop] >= 0.8 * most), key=lambda loop: loop[1] - loop[0])
    inner = [loop for loop in loops if first < loop[0] and loop[1] < last]
    return [text.split(' <')[0] for i, (_, text) in enumerate(code[first:last + 1], first)
            if not any(a <= i <= b for a, b in inner) and not JUMP.match(text) and 'nop' not in text]


def cycles(mca, architecture, processor, loop):
    """Cycles an iteration, and the unit that is busiest."""
    command = [mca, f'-mcpu={processor}', '-iterations=300', '--json', '--resource-pressure', *architecture]
    result = subprocess.run(command, input='\n'.join(loop) + '\n', check=True, capture_output=True, text=True)
    data = json.loads(result.stdout)
    region = data['CodeRegions'][0]
    units = data['TargetInfo']['Resources']
    whole = [use for use in region['ResourcePressureView']['ResourcePressureInfo']
             if use['InstructionIndex'] == len(loop)]
    busiest = max(whole, key=lambda use: use['ResourceUsage'])
    summary = region['SummaryView']
    return summary['TotalCycles'] / summary['Iterations'], units[busiest['ResourceIndex']]


def main(mca, objdump, kernels, yardsticks, *processors):
    is_arm = 'aarch64' in objdump
    architecture = ['-mtriple=aarch64'] if is_arm else ['-mtriple=x86_64']
    many_registers = is_arm or 'avx512' in kernels
    library, plain = {}, {}
    for name, code in functions(objdump, kernels).items():
        if match := KERNEL.search(name):
            library[match.groups()] = hot_loop(code)
        elif match := CHECKED.search(name):
            library['Checked', *match.groups(), '1'] = hot_loop(code)
        elif match := PACKED.search(name):
            _, shape, scalar, repeat = match.groups()
            library['Packed', shape, shape, scalar, repeat] = hot_loop(code)
    for name, code in functions(objdump, yardsticks).items():
        if match := YARDSTICK.search(name):
            plain[match.groups()] = hot_loop(code)
    for processor in processors:
        for a, b in PAIRS:
            for scalar, short in SCALARS:
                for repeat, one, layout in (('1', 'true', 'one against many'), ('0', 'false', 'in step')):
                    # Yardsticks take two vectors an iteration where there are registers: bench/batch/unfiltered/loop.hpp.
                    vectors = 2 if many_registers and (one == 'true' or b == 'Ellipse') else 1
                    base, _ = cycles(mca, architecture, processor, plain[a, b, scalar, one])
                    for policy in ('Checked', 'UnitAxes', 'Packed', 'General'):
                        loop = library.get((policy, a, b, scalar, repeat))
                        if loop is None:
                            continue
                        ours, unit = cycles(mca, architecture, processor, loop)
                        print(f'{processor:16} {a + "-" + b:16} {short} {layout:17} {policy:9} {ours:7.1f} '
                              f'{base / vectors:7.1f} {base / vectors / ours:6.2f}  {unit}')


if __name__ == '__main__':
    if len(sys.argv) < 6:
        sys.exit(__doc__)
    main(*sys.argv[1:])
