# SPDX-License-Identifier: Apache-2.0
"""What a filter kernel could reach on paper: pairs a second by its instructions, its arithmetic and the memory's bandwidth.

Published: multiprocessors, teraflops of float (two a lane and clock: this gives the clock) and the memory's bandwidth, all
of the data sheets; lanes a clock of a multiprocessor, of the CUDA programming guide's table of arithmetic throughput.
"""
import re
import subprocess
from dataclasses import dataclass


@dataclass
class Device:
    name: str
    multiprocessors: int
    teraflops: float
    fp32: int  # lanes a clock of a multiprocessor
    fp64: int
    bandwidth: float  # bytes a second
    other: int = 64  # of integers, comparisons and selections
    memory: int = 32
    special: int = 16
    issue: int = 128  # four warps' instructions a clock

    def clocks(self):
        """A second, of all multiprocessors."""
        return self.teraflops * 1e12 / (2 * self.fp32)


DEVICES = {80: Device('A100', 108, 19.5, 64, 32, 2.039e12),
           90: Device('H100', 132, 67, 128, 64, 3.35e12),
           100: Device('B200', 148, 75, 128, 64, 7.7e12)}
FIELDS = {'Point': 2, 'Segment': 4, 'Circle': 3, 'Aabb': 4, 'Rect': 6, 'Ellipse': 6}
SIZES = {'float': 4, 'double': 8}


def demangled(names):
    names = list(names)
    said = subprocess.run(['c++filt'], input='\n'.join(names), stdout=subprocess.PIPE, text=True, check=True).stdout
    return dict(zip(names, said.splitlines()))


def title_and_bytes(name):
    """Of a kernel's demangled name: what it asks, and the bytes that each pair moves between memory and device. The rows and
    columns of a matrix are looked at so often that they do not count."""
    parameters = name[name.index('<'):name.index('>(')]
    shapes = re.findall(r'(Column|One)<vesica::(\w+)(?:, |<)(\w+)', parameters)
    scalar = {'float': 'f32', 'double': 'f64'}[shapes[0][2]]
    form = 'matrix' if 'Matrix<' in parameters else 'one' if any(how == 'One' for how, _, _ in shapes) else 'in step'
    form = 'counts' if '::Counts' in parameters else form
    moved = 0 if form == 'counts' else 1
    if form in ('in step', 'one'):
        moved += sum(FIELDS[shape] * SIZES[kind] for how, shape, kind in shapes if how == 'Column')
    return f'{shapes[0][1].lower()}, {shapes[1][1].lower()}, {scalar}, {form}', moved


def rates(counts, moved, device):
    """Pairs a second, in thousand millions: by issue, by arithmetic, by memory."""
    per_clock = min(getattr(device, kind) / count for kind, count in counts.items() if kind != 'issue' and count)
    scale = device.clocks() / 1e9
    return (scale * device.issue / sum(counts.values()), scale * per_clock,
            device.bandwidth / moved / 1e9 if moved else float('inf'))


def print_table(found, architecture):
    """found: name -> counts by class."""
    device = DEVICES[architecture]
    names = demangled(found)
    print(f'  instructions a decided pair, and {device.name} on paper in thousand million pairs a second:')
    print(f'  {"":38} all fp32 fp64 other memory   issue arithm. memory')
    for name, counts in sorted(found.items(), key=lambda item: title_and_bytes(names[item[0]])):
        title, moved = title_and_bytes(names[name])
        issue, arithmetic, memory = rates(counts, moved, device)
        print(f'  {title:38} {sum(counts.values()):3.0f} {counts["fp32"]:4.0f} {counts["fp64"]:4.0f} {counts["other"]:5.0f} '
              f'{counts["memory"]:6.0f}   {issue:5.0f} {arithmetic:7.0f} {memory:6.0f}')
