# SPDX-License-Identifier: Apache-2.0
"""Machine code of NVIDIA devices from sm_80 on, as far as counting needs it: which instruction, and where a jump leads.

CUDA's disassemblers are not always there; an instruction is 16 bytes, and its lowest 12 bits are its number, of which three
say where operands come from. The rest of the numbers was learnt from code whose instructions are known: what the kernel
known_instructions of device.cu must give is checked in every run. An unknown number is an error.
"""
import struct

NAMES = {
    'fp32': {0x020: 'FMUL', 0x021: 'FADD', 0x023: 'FFMA'},
    'fp64': {0x028: 'DMUL', 0x029: 'DADD', 0x02a: 'DSETP', 0x02b: 'DFMA'},
    'other': {0x002: 'MOV', 0x007: 'SEL', 0x008: 'FSEL', 0x009: 'FMNMX', 0x00b: 'FSETP', 0x00c: 'ISETP', 0x010: 'IADD3',
              0x011: 'LEA', 0x012: 'LOP3', 0x016: 'PRMT', 0x019: 'SHF', 0x01c: 'PLOP3', 0x024: 'IMAD',
              0x025: 'IMAD.WIDE', 0x027: 'IMAD.HI', 0x031: 'HFMA2', 0x035: 'HFMA2.MMA', 0x036: 'VIADD'},
    'memory': {0x181: 'LDG', 0x186: 'STG', 0x18e: 'RED', 0x1a8: 'ATOMG'},
    # Conversions and rough reciprocals, at a quarter of the rate or less.
    'special': {0x100: 'FLO', 0x102: 'FCHK', 0x105: 'F2I', 0x106: 'I2F', 0x108: 'MUFU', 0x109: 'POPC', 0x110: 'F2F',
                0x111: 'F2I.64', 0x112: 'I2F.64', 0x189: 'SHFL'},
    # These take a place in the stream of instructions and no lane: constants, uniform registers, jumps.
    'issue': {0x005: 'CS2R', 0x082: 'UMOV', 0x086: 'VOTEU', 0x090: 'UIADD3', 0x0a4: 'UIMAD', 0x0b9: 'ULDC', 0x118: 'NOP',
              0x119: 'S2R', 0x141: 'BSYNC', 0x142: 'BREAK', 0x144: 'CALL', 0x145: 'BSSY', 0x146: 'YIELD', 0x147: 'BRA',
              0x148: 'WARPSYNC', 0x14d: 'EXIT', 0x150: 'RET', 0x182: 'LDC', 0x1ac: 'LDCU', 0x1c3: 'S2UR'},
}
CLASSES = tuple(NAMES)
KNOWN = {number: (name, kind) for kind, names in NAMES.items() for number, name in names.items()}
ALWAYS = 7  # the predicate of what is not conditional


class Instruction:
    def __init__(self, word, architecture):
        number = word & 0x1ff
        if number not in KNOWN:
            raise ValueError(f'an unknown instruction: {word & 0xfff:#x}')
        self.name, self.kind = KNOWN[number]
        self.conditional = (word >> 12 & 15) != ALWAYS
        # Where a jump leads, in instructions from here. From sm_90 on its lowest 8 bits stand apart.
        far = (word >> 34 & (1 << 48) - 1) - (word >> 81 & 1) * (1 << 48)
        self.jump = 1 + (far if architecture < 90 else far << 8 | word >> 16 & 0xff) // 4


def kernels(cubin, architecture, wanted):
    """Name -> instructions, of the kernels in an ELF file of device code whose names hold one of the words wanted."""
    data = cubin.read_bytes()
    table, = struct.unpack_from('<Q', data, 40)
    size, count, strings = struct.unpack_from('<HHH', data, 58)
    sections = [struct.unpack_from('<IIQQQQ', data, table + i * size) for i in range(count)]
    found = {}
    for section in sections:
        start = sections[strings][4] + section[0]
        name = data[start:data.index(b'\0', start)].decode()
        if name.startswith('.text.') and any(word in name for word in wanted):
            code = data[section[4]:section[4] + section[5]]
            words = [int.from_bytes(code[i:i + 16], 'little') for i in range(0, len(code), 16)]
            found[name[len('.text.'):]] = [Instruction(word, architecture) for word in words]
    return found


def successors(code, at):
    i = code[at]
    if i.name == 'BRA':
        return [at + i.jump] + ([at + 1] if i.conditional else [])
    if i.name in ('EXIT', 'RET'):
        return [at + 1] if i.conditional else []
    return [at + 1]


def longest_way(code, first, lasts, avoided):
    """The instructions on the longest way from the first one to one of the last that meets none of those avoided; or None."""
    longest = {}

    def longest_from(at):
        if at not in longest:
            longest[at] = None  # a way that comes here again is none
            if at in lasts:
                longest[at] = [at]
            elif code[at].name not in avoided:
                ways = [way for way in (longest_from(after) for after in successors(code, at)) if way]
                longest[at] = [at] + max(ways, key=len) if ways else None
        return longest[at]

    return longest_from(first)


def counts_a_pair(code, avoided=('ATOMG', 'CALL')):
    """Instructions a pair by class, in the loop of a kernel that has one store a pair: on the longest way round that meets
    nothing avoided, neither the list of open pairs, nor the slow division of numbers near the ends of the range. Where
    ptxas made of the loop one of several pairs a round, and another for the rest, the first is looked at."""
    loops = {}
    for at, i in enumerate(code):
        if i.name == 'BRA' and i.jump < 0:
            loops.setdefault(at + i.jump, set()).add(at)
    ways = [way for way in (longest_way(code, first, lasts, avoided) for first, lasts in loops.items()) if way]
    answers = {id(way): sum(code[at].name in ('STG', 'RED') for at in way) for way in ways}
    if not any(answers.values()):
        raise ValueError('no loop stores an answer')
    way = max(ways, key=lambda way: (answers[id(way)], len(way)))
    return {kind: sum(code[at].kind == kind for at in way) / answers[id(way)] for kind in CLASSES}
