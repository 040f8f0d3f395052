# SPDX-License-Identifier: Apache-2.0
"""Calls that are divided among threads: the interpreter's lock is released while the C library works."""
import ctypes
import os
from collections import deque
from threading import Thread

from . import _declarations
from ._library import whole

#: Up to so many elements one thread works alone: starting another one takes longer than it saves.
LEAST = 100_000
# Parts begin at multiples of this, as the library's blocks do.
_BLOCK = 1024
_PARTS_A_THREAD = 4
_LEAST_PART = 16 * _BLOCK


def available():
    """How many processors this process may use."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def count_of(threads, elements):
    """How many threads work on so many elements, if the caller asks for `threads`.

    None stands for all processors, but no more than have half of LEAST each.
    """
    asked = None if threads is None else whole(threads, "threads", 1)
    if elements <= LEAST:
        return 1
    return min(available(), elements // (LEAST // 2)) if asked is None else min(asked, -(-elements // _BLOCK))


def parts_of(threads):
    """How many parts a join is cut into."""
    return 1 if threads == 1 else 2 * _PARTS_A_THREAD * threads


def in_order(call, parts, threads):
    """[call(part) for each part], by so many threads, this one among them. The first part's exception is raised.

    A pool of concurrent.futures takes six times as long to start.
    """
    if threads == 1 or len(parts) == 1:
        return [call(part) for part in parts]
    results, errors, left, awake = [None] * len(parts), {}, deque(range(len(parts))), set()

    def work(number):
        awake.add(number)
        while left:
            try:
                i = left.popleft()
            except IndexError:  # another thread took the last one
                return
            try:
                results[i] = call(parts[i])
            except BaseException as error:
                errors[i] = error
                left.clear()  # parts before this one are under way

    helpers = []
    try:
        for number in range(1, min(threads, len(parts))):
            helper = Thread(target=work, args=[number])
            helper.start()
            helpers.append(helper)
    except RuntimeError:  # the system has no more threads: those that there are do the work
        pass
    work(0)
    for number, helper in enumerate(helpers, 1):
        if number in awake:  # one that awakes only now finds no part
            helper.join()
    if errors:
        raise errors[min(errors)]
    return results


def ranges(count, threads):
    """[(begin, end)] of so many elements, more of them than threads, as some take longer than others."""
    if threads == 1:
        return [(0, count)]
    step = -(-count // (threads * _PARTS_A_THREAD * _BLOCK)) * _BLOCK
    step = max(step, min(_LEAST_PART, -(-count // (threads * _BLOCK)) * _BLOCK))
    return [(begin, min(begin + step, count)) for begin in range(0, count, step)]


def cut(view, begin, end):
    """The C struct of a part of an array of shapes. A single shape stands for as many as it is asked about."""
    if view.count == 1:
        return view
    part = type(view).from_buffer_copy(view)
    part.count = end - begin
    for k, address in enumerate(view.field):
        if address is not None:
            part.field[k] = address + begin * view.stride
    return part


def divided(ask, views, columns, count, threads):
    """The code of ask(views, addresses): that of the call with all elements, which threads answer part by part.

    columns: the address of each array of numbers, and the bytes from one element to the next.
    """
    if count_of(threads, count) == 1:
        return ask(*map(ctypes.byref, views), *(address for address, _ in columns))

    def answer(begin, end):
        parts = [ctypes.byref(cut(view, begin, end)) for view in views]
        return ask(*parts, *(address + begin * step for address, step in columns))

    return by_ranges(answer, count, threads)


def by_ranges(ask, count, threads):
    """The code of ask(0, count), which threads answer by ask(begin, end)."""
    threads = count_of(threads, count)
    return worst(in_order(lambda span: ask(*span), ranges(count, threads), threads))


def worst(codes):
    """The code of a whole call: an invalid shape before any other error, else the last one, as in the library."""
    if _declarations.E_SHAPE in codes:
        return _declarations.E_SHAPE
    return next((code for code in reversed(codes) if code < 0), codes[0])
