# This file is part of the Line Space module for OpenCV.
# It is subject to the license terms in the LICENSE file found in the top-level directory
# of this distribution and at http://www.apache.org/licenses/LICENSE-2.0.

"""A model, not a measurement: what the OpenCL path's stages move and add, and the time to expect
from that on two GPUs. Prints the tables of doc/opencl.md from the plan's own numbers
(stage-work.csv of perf/run.sh):

    /usr/bin/python3 perf/benchmark/device_model.py perf/results/stage-work.csv
"""

import argparse
import collections
import pathlib
import sys

import pandas

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "common"))
from tables import Table, number  # noqa: E402

GROUP = 64  # work items
VECTOR = 16  # cells of an item
SECTOR = 32  # bytes that a cache fetches for one of them
INT = 4
SHORT = 2

PRUNED_LEVELS = 3
BLOCK = 8  # border points a side of a block of chords
# Shares of the blocks of these levels that are merged; of the last one 5 to 9 % on photographs,
# the others are a guess.
NEEDED = (0.4, 0.2, 0.1)
CANDIDATES = 8192
COUNTED_CHORDS = 50000  # around them (doc/performance.md: 43,600 to 68,400 at 512 x 512)

# Bytes per second of memory, of the first caches together and between the device and the processor;
# seconds to begin a kernel and to wait for it, which are assumptions.
Device = collections.namedtuple("Device", "name memory caches bus launch wait")
DEVICES = (
    # 192 bits of GDDR6 at 15 Gbit/s; 28 multiprocessors of 128 bytes per clock at 1.78 GHz; PCI
    # Express 3.0 x16.
    Device("GeForce RTX 3060", 360e9, 28 * 128 * 1.78e9, 12e9, 5e-6, 20e-6),
    # 64 bits of LPDDR5 at 6.4 Gbit/s, shared with the processor, which reads what was written; 14
    # cores of 64 bytes per clock at 0.85 GHz.
    Device("Mali-G78 MP14", 51.2e9, 14 * 64 * 0.85e9, 25e9, 30e-6, 100e-6),
)

# items: work items; moved: bytes read and written once; loaded: bytes that instructions load;
# worst: bytes moved if every load of a merge that is not beside the last one fetches a sector of its own.
Stage = collections.namedtuple("Stage", "kernel items read written loaded adds worst launches",
                               defaults=(1,))
# Bytes that are read from the device, and waited for.
READS = 2


def bytes_read_back(rows):
    """The candidates, and the edge pixels as bits for the refinement."""
    return 3 * INT * (CANDIDATES + 1) + rows["edge map"].bytes_read / 4


def stages_of(work):
    """The kernels of a warm detect in the order of their launches, from the rows of one size."""
    rows = {row.stage: row for row in work.itertuples()}
    last = len([name for name in rows if name.startswith("level ")]) - 1
    image, first, top = rows["edge map"], rows["level 0"], rows[f"level {last}"]
    yield Stage("gatherPixels", first.bytes_read, image.bytes_read, first.bytes_read,
                image.bytes_read, 0, image.bytes_read + first.bytes_read)
    entries = first.bytes_written / first.bytes_per_vote
    yield Stage("firstCells", entries / VECTOR, first.bytes_read, first.bytes_written,
                first.bytes_loaded, first.adds, first.bytes_read + first.bytes_written)
    base = last - PRUNED_LEVELS
    for level in range(1, base + 1):
        row = rows[f"level {level}"]
        cells = 2 ** (last - level)
        entries = row.bytes_written / row.bytes_per_vote
        child_bytes = row.bytes_read / entries_of(rows, level - 1)
        loads = row.bytes_loaded / child_bytes / cells
        yield Stage(f"mergeCells {level}", entries / cells, row.bytes_read, row.bytes_written,
                    row.bytes_loaded, row.adds,
                    row.bytes_written + loads * max(SECTOR, cells * child_bytes))
    whole = rows[f"level {base}"].bytes_written
    pools = entries_of(rows, base) / BLOCK ** 2 * SHORT
    yield Stage("poolBlocks", pools / SHORT, whole, pools, whole, 0, whole + pools)
    for level in range(base + 1, last + 1):
        row = rows[f"level {level}"]
        blocks = entries_of(rows, level) / BLOCK ** 2
        # A block's parts lie in two or three pools of either child.
        yield Stage(f"boundBlocks {level}", blocks, blocks * SHORT, blocks * SHORT,
                    blocks * 6 * SHORT, blocks * 4, blocks * SHORT + blocks * 6 * SECTOR)
    for level in range(last, base + 1, -1):
        blocks = entries_of(rows, level) / BLOCK ** 2
        yield Stage(f"requireBlocks {level}", blocks, blocks * INT, blocks * INT,
                    blocks * 6 * INT, 0, blocks * INT + blocks * 6 * SECTOR)
    for level in range(base + 1, last + 1):
        row = rows[f"level {level}"]
        entries, share = entries_of(rows, level), NEEDED[level - base - 1]
        # There are items for all chords; most find that their block is not needed.
        yield Stage(f"mergeBlocks {level}", entries / 2 ** (last - level),
                    row.bytes_read * share + entries / BLOCK ** 2 * INT, row.bytes_written * share,
                    row.bytes_loaded * share + entries * INT, row.adds * share,
                    row.bytes_written * share + 2 * row.adds * share * SECTOR)
    entries, share = entries_of(rows, last), NEEDED[-1]
    table = top.bytes_written * share
    runs = entries / 32
    yield Stage("searchBlocks", entries / 8, table + entries / BLOCK ** 2 * INT, runs * INT,
                table, 0, table + runs * INT)
    yield Stage("count, scan, write", 2 * runs / 64, runs * 2 * INT, runs / 8, runs * 2 * INT, 0,
                runs * 9, 5)
    pixels = image.bytes_read
    length = pixels ** 0.5
    yield Stage("packColumns, packRows", pixels / 512 + pixels / 32, 2 * pixels, pixels / 4,
                2 * pixels, 0, 2 * pixels + pixels / 4, 2)
    squares = entries / 64
    chords, visits = COUNTED_CHORDS, 1.3 * CANDIDATES
    yield Stage("wantNeighbours, markCounted, 4 times", 4 * (CANDIDATES + squares),
                4 * squares * 8, visits * 4 * 8, 4 * squares * 8, 0,
                4 * squares * 8 + visits * 4 * SECTOR, 9)
    yield Stage("countWanted, 4 times", 4 * squares * 64, 4 * squares * 16 + pixels / 4,
                chords * 2, chords * length * INT, chords * length,
                4 * squares * 16 + pixels / 4 + chords * SECTOR, 4)
    yield Stage("takeSteps, 4 times, climbOn", 5 * CANDIDATES, chords * 2, CANDIDATES * 12,
                visits * 25 * 2, 0, visits * 5 * SECTOR + CANDIDATES * 12, 5)


def entries_of(rows, level):
    row = rows[f"level {level}"]
    return row.bytes_written / row.bytes_per_vote


def seconds(stage, device, worst=False):
    moved = stage.worst if worst else stage.read + stage.written
    return max(moved / device.memory, stage.loaded / device.caches) + stage.launches * device.launch


def limit_of(stage, device):
    parts = {"memory": (stage.read + stage.written) / device.memory,
             "caches": stage.loaded / device.caches, "launch": stage.launches * device.launch}
    return max(parts, key=parts.get)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("work", help="stage-work.csv")
    work = pandas.read_csv(parser.parse_args().work)
    for (width, height), rows in work.groupby(["width", "height"], sort=False):
        columns = ["kernel", "groups", "MiB read", "MiB written", "10^6 adds"]
        for device in DEVICES:
            columns += [f"{device.name}: ms", "at worst", "limit"]
        table = Table(f"model-{width}x{height}", f"{width} x {height}", columns)
        sums = [0.] * (2 * len(DEVICES))
        for stage in stages_of(rows):
            cells = []
            for i, device in enumerate(DEVICES):
                least, most = seconds(stage, device), seconds(stage, device, True)
                sums[2 * i] += least
                sums[2 * i + 1] += most
                cells += [number(1e3 * least, 3), number(1e3 * most, 3), limit_of(stage, device)]
            table.add(stage.kernel, f"{stage.items / GROUP:.0f}", number(stage.read / 2**20, 2),
                      number(stage.written / 2**20, 2), number(stage.adds / 1e6, 1), *cells)
        rows = {row.stage: row for row in rows.itertuples()}
        cells = []
        for i, device in enumerate(DEVICES):
            back = bytes_read_back(rows) / device.bus + READS * device.wait
            sums[2 * i] += back
            sums[2 * i + 1] += back
            cells += [number(1e3 * back, 3), number(1e3 * back, 3), "wait"]
        table.add("two reads", "", number(bytes_read_back(rows) / 2**20, 2), "", "", *cells)
        cells = []
        for least, most in zip(sums[::2], sums[1::2]):
            cells += [number(1e3 * least, 2), number(1e3 * most, 2), ""]
        table.add("sum", "", "", "", "", *cells)
        print(table.markdown())


if __name__ == "__main__":
    main()
