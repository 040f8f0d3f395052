# SPDX-License-Identifier: Apache-2.0
"""All pairs of shapes that overlap, of two Dask collections: overlap_join(left, right, folder).

A collection is a list of partitions: Slice of a .npy file, delayed arrays, futures; or a Dask array of one dimension.
Its elements are records of RECORD. A shape's number is its place among all of its collection, from 0.
"""
import dataclasses
import itertools
import math
import os
import pathlib
import shutil

import dask.array
import distributed
import numpy
import vesica

RECORD = numpy.dtype([("kind", "<i8"), ("numbers", "<f8", 7)])
_NUMBERED = numpy.dtype([("id", "<i8"), *((name, RECORD.fields[name][0]) for name in RECORD.names)])
_SAMPLE = 1024  # shapes a partition
_WORK = "pieces"  # the folder in the folder
_PARTS = 8  # of a join: their pairs are in memory one part at a time


@dataclasses.dataclass
class Slice:
    """Rows of a .npy file that all workers see, mapped where they are needed."""

    path: str
    begin: int
    end: int

    def __len__(self):
        return self.end - self.begin


def slices(path, rows):
    """The partitions of a .npy file, each of so many rows."""
    count = len(numpy.load(path, mmap_mode="r"))
    return [Slice(str(path), begin, min(begin + rows, count)) for begin in range(0, count, rows)]


@dataclasses.dataclass
class Pairs:
    """What a join found: a file for each two pieces that meet; `invalid` shapes were left out."""

    paths: list
    count: int
    invalid: int

    def __iter__(self):
        """The pairs file by file, as arrays of two columns."""
        return (numpy.fromfile(path, "<i8").reshape(-1, 2) for path in self.paths)


def overlap_join(left, right, folder, cells=None):
    """Writes all pairs (number in left, number in right) into a folder that all workers see, and tells the files.

    cells: into how many cells of the map shapes are laid first, by a plan from a sample; None where partitions are
    spatial already. A piece, of a partition or a cell, must fit into a worker. The folder must not be there yet. A worker
    that dies changes nothing: its tasks are run again, and a file gets its name when it is whole.
    """
    client = distributed.get_client()
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    work = folder / _WORK
    work.mkdir()
    sides = [_numbered(client, partitions) for partitions in (left, right)]
    if cells:
        plan = _plan(_all(client, _sample, *sides), cells)
        sides = [_shuffled(client, side, plan, work / name) for side, name in zip(sides, ("left", "right"))]
    indexes = [
        [_submit(client, _index, *piece, work / f"{name}.{i}.npy") for i, piece in enumerate(side)]
        for side, name in zip(sides, ("left", "right"))
    ]
    abouts = [client.gather([_submit(client, _about, index) for index in side]) for side in indexes]
    tasks = [
        _submit(client, _join, a, b, folder / f"pairs.{i}.{j}")
        for i, a in enumerate(indexes[0])
        for j, b in enumerate(indexes[1])
        if _meet(abouts[0][i]["bounds"], abouts[1][j]["bounds"])
    ]
    found = client.gather(tasks)
    invalid = sum(about["invalid"] for about in itertools.chain(*abouts))
    shutil.rmtree(work)
    return Pairs([path for path, _ in found], sum(count for _, count in found), invalid)


def _submit(client, function, *arguments):
    # Files of an earlier call are no result of this one.
    return client.submit(function, *arguments, pure=False)


def _all(client, function, *sides):
    return client.gather([_submit(client, function, *piece) for piece in itertools.chain(*sides)])


# ---- Partitions ----


def _numbered(client, partitions):
    """Each partition with the number of its first shape."""
    if isinstance(partitions, dask.array.Array):
        partitions = partitions.to_delayed().ravel().tolist()
    partitions = [client.compute(p) if hasattr(p, "dask") else p for p in partitions]
    lengths = client.gather([_submit(client, len, p) for p in partitions])
    return list(zip(partitions, itertools.accumulate(lengths, initial=0)))


def _records(partition, first):
    if isinstance(partition, Slice):
        partition = numpy.load(partition.path, mmap_mode="r")[partition.begin : partition.end]
    if partition.dtype == _NUMBERED:
        return partition
    if partition.dtype != RECORD:
        raise TypeError(f"a partition's records are {RECORD.descr}, not {partition.dtype}")
    records = numpy.empty(len(partition), _NUMBERED)
    records["id"] = numpy.arange(first, first + len(partition))
    for name in RECORD.names:
        records[name] = partition[name]
    return records


def _save(work, path, write):
    """A file is there when it is whole; who writes it again writes the same. What is not yet lies in `work`."""
    unfinished = work / f"{path.name}.{os.getpid()}.part"
    with open(unfinished, "wb") as file:
        write(file)
    os.replace(unfinished, path)
    return str(path)


# ---- Cells: columns of the map, each cut into rows, with as many of the sample in each ----


def _sample(partition, first):
    del first
    if isinstance(partition, Slice):
        partition = numpy.load(partition.path, mmap_mode="r")[partition.begin : partition.end]
    places = partition["numbers"][:: max(1, len(partition) // _SAMPLE), :2]
    return places[numpy.isfinite(places).all(axis=1)]


def _plan(samples, cells):
    places = numpy.concatenate([numpy.empty((0, 2)), *samples])
    columns = math.isqrt(cells)
    rows = cells // columns
    shares = numpy.arange(1, columns) / columns
    column_ends = numpy.quantile(places[:, 0], shares) if len(places) else shares
    column = numpy.searchsorted(column_ends, places[:, 0])
    shares = numpy.arange(1, rows) / rows
    row_ends = [numpy.quantile(y, shares) if len(y) else shares for y in (places[column == c, 1] for c in range(columns))]
    return column_ends, row_ends


def _cell_of(plan, places):
    """A shape's first two numbers are a point of it, for every kind: this point's cell."""
    column_ends, row_ends = plan
    column = numpy.searchsorted(column_ends, places[:, 0])
    cell = numpy.empty(len(places), numpy.int64)
    for c, ends in enumerate(row_ends):
        of_column = column == c
        cell[of_column] = c * (len(ends) + 1) + numpy.searchsorted(ends, places[of_column, 1])
    return cell


def _scatter(partition, first, plan, path):
    """Writes the shapes of a partition in the order of their cells; tells where each cell begins."""
    records = _records(partition, first)
    cell = _cell_of(plan, records["numbers"][:, :2])
    order = numpy.argsort(cell, kind="stable")
    _save(path.parent, path, lambda file: numpy.save(file, records[order]))
    cells = len(plan[1]) * (len(plan[1][0]) + 1)
    return numpy.searchsorted(cell[order], numpy.arange(cells + 1))


def _shuffled(client, pieces, plan, path):
    """Pieces that are cells: for each the slices of the files that the partitions were written to."""
    paths = [path.with_name(f"{path.name}.scattered.{i}.npy") for i in range(len(pieces))]
    starts = client.gather([_submit(client, _scatter, *piece, plan, path) for piece, path in zip(pieces, paths)])
    cells = len(plan[1]) * (len(plan[1][0]) + 1)
    return [
        ([Slice(str(path), start[cell], start[cell + 1]) for path, start in zip(paths, starts)], None) for cell in range(cells)
    ]


# ---- Indexes and joins ----


def _index(piece, first, path):
    """Writes a piece kind by kind; its index goes on as bytes."""
    parts = piece if isinstance(piece, list) else [piece]
    records = numpy.concatenate([numpy.empty(0, _NUMBERED), *(_records(part, first) for part in parts)])
    known = records[(records["kind"] >= 0) & (records["kind"] < len(vesica.FIELDS))]
    known = known[numpy.argsort(known["kind"], kind="stable")]
    index = vesica.Index(*_sets(known))
    indexed = len(index.order())
    _save(path.parent, path, lambda file: numpy.save(file, known))
    about = {"bounds": index.bounds(), "invalid": len(records) - indexed}
    return {"path": str(path), "bytes": index.bytes.tobytes(), "about": about}


def _about(index):
    return index["about"]


def _sets(records):
    ends = numpy.searchsorted(records["kind"], numpy.arange(len(vesica.FIELDS) + 1))
    numbers = records["numbers"]
    return [vesica.shapes(kind, numbers[ends[kind] : ends[kind + 1], : len(vesica.FIELDS[kind])]) for kind in vesica.FIELDS]


def _meet(a, b):
    return a[0] <= b[2] and b[0] <= a[2] and a[1] <= b[3] and b[1] <= a[3]


def _join(left, right, path):
    records = [numpy.load(side["path"], mmap_mode="r") for side in (left, right)]
    a, b = (vesica.Index.from_bytes(side["bytes"], *_sets(r)) for side, r in zip((left, right), records))
    count = 0

    def write(file):
        nonlocal count
        for part in range(_PARTS):
            items = a.join(b, part=part, parts=_PARTS)
            pairs = numpy.stack([r["id"][i] for r, i in zip(records, items)], axis=1)
            pairs.astype("<i8").tofile(file)
            count += len(pairs)

    return _save(path.parent / _WORK, path, write), count
