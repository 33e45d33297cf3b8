# SPDX-FileCopyrightText: 2026 The glark authors
# SPDX-License-Identifier: MIT
"""Measures glark-mpi with 1, 2 and 4 ranks, and compares the model of docs/reference/cluster.md with it.

measure_ranks.py GLARK_SCAN GLARK_MPI [--points N] [--side N] [--only-mesh] [--runs R] [--folder DIR]
Prints the tables of the page: strong and weak scaling, the model beside the measured runs, and the model for 1000 ranks
and a trillion points. Seconds are the least of R runs. CPU seconds say more where other programs use the machine, too.
"""
import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "stream"))
import scans

TARGET, THREADS = 20000, ["--threads", "1"]
ENVIRONMENT = dict(os.environ, OMPI_MCA_btl_vader_single_copy_mechanism="none", OMPI_MCA_mpi_yield_when_idle="1",
                   HWLOC_COMPONENTS="-gl")
# Bytes that ranks send: for a point, a cube of the first pass, the root of a tree, a number of a cell, a sample.
STREAMED, SHUFFLED, CUBE, ROOT, NUMBER, SAMPLE = 40, 28, 32, 272, 16, 48
CLASSES = 8 << 18  # bytes of the counts of errors
PIECE = 1 << 14  # points: ranges begin at multiples of it
# Assumptions about a cluster: bytes a second of the network and of the disk of a rank, and of the shared file
# system; seconds of a message.
NETWORK, DISK, SHARED, LATENCY = 5e9, 1e9, 100e9, 5e-6


def run(command: list) -> tuple:
    """Returns the report of a command, and the CPU seconds of all its processes."""
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=ENVIRONMENT)
    text = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        raise subprocess.CalledProcessError(process.returncode, command)
    return json.loads(text), usage.ru_utime + usage.ru_stime


def measured(ranks: int, *arguments) -> dict:
    launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", "-n", str(ranks)]
    runs = [run([*launcher, MPI_PROGRAM, *map(str, arguments), "--json", *THREADS]) for _ in range(OPTIONS.runs)]
    best = min(runs, key=lambda one: one[0]["seconds"])[0]
    busiest = min(report["cpu_seconds"] for report, _ in runs)
    return dict(best, cpu=min(cpu for _, cpu in runs), cpu_seconds=busiest)


def cells_of(index: pathlib.Path) -> list:
    """Count, first and last point of each cell of a sampling."""
    rows = [line.split() for line in index.read_text().splitlines()[2:] if not line.startswith("checksum")]
    return [(int(row[4]), int(row[5]), int(row[6])) for row in rows]


def foreign_points(cells: list, points: int, ranks: int) -> float:
    """Points that their readers send to other ranks, if cells fill evenly between their first and last points."""
    steps = math.ceil(points / PIECE)
    begins = [min(points, PIECE * (steps // ranks * r + min(r, steps % ranks))) for r in range(ranks + 1)]
    foreign, before = 0.0, 0
    for count, first, last in sorted(cells, key=lambda cell: cell[1]):
        owner = min(ranks - 1, int((before + count / 2) / points * ranks))
        own = max(0, min(last + 1, begins[owner + 1]) - max(first, begins[owner]))
        foreign += count * (1 - own / (last + 1 - first))
        before += count
    return foreign


def transfer_model(ranks: int) -> tuple:
    """Bytes and messages of a transfer: 13 exchanges of numbers, whatever the scan."""
    return 8 * 13 * ranks * (ranks - 1), 13 * ranks * (ranks - 1)


def sample_bytes(ranks: int, shuffled: bool, foreign: float, cells: int, cubes: float, samples: int) -> float:
    """Bytes of a sampling: the points that change their rank, the cubes up and down a tree, the counts of errors, and the
    roots, numbers and samples of the cells."""
    others, share = ranks - 1, (ranks - 1) / ranks
    up = others if shuffled else math.log2(ranks) / 2
    of_cells = NUMBER * (others if shuffled else 1) + 8 * others + share * (ROOT + 2 * NUMBER)
    return (foreign * (SHUFFLED if shuffled else STREAMED) + CUBE * cubes * (up + others) + CLASSES * others +
            of_cells * cells + share * SAMPLE * samples)


def cubes_of(report: dict, foreign: float) -> float:
    """The cubes that two ranks have counted, by what they have sent. The report does not say it."""
    rest = sample_bytes(2, report["shuffled"], foreign, report["cells"], 0, report["samples"])
    each = CUBE * (2 if report["shuffled"] else 1.5)
    return (report["bytes_sent"] - rest) / each


def large_model(costs: dict, ranks: int = 1000, points: float = 1e12, samples: float = 1e8, record: int = 30):
    """Prints what a run on a cluster takes. costs: seconds of a rank for a point, for each command."""
    each = points / ranks
    rows = []
    files = points * record / SHARED
    sent, messages = transfer_model(ranks)
    for name in ("transfer", "transfer, shuffled"):
        rows.append([name, f"{sent:.2g}", f"{messages:.2g}", f"{each * costs[name]:.0f}", f"{2 * files:.0f}", "0", "0"])
    for name, point, foreign in [("sample, coherent, at best", STREAMED, 0), ("sample, coherent, at worst", STREAMED, 1),
                                 ("sample, shuffled", SHUFFLED, 1)]:
        cells, cubes = samples / 100, 3e6
        sent = sample_bytes(ranks, point == SHUFFLED, 0, int(cells), cubes, int(samples)) + foreign * points * point
        rounds = each / 3.1e6  # of 1 GB of memory
        messages = rounds * (3 if foreign else 2) * ranks * ranks
        network = foreign * each * point / NETWORK + rounds * ranks * LATENCY * foreign
        first = samples * (SAMPLE / NETWORK + costs["sample written"]) + cells * ROOT / NETWORK
        computing = each * costs["sample, shuffled" if point == SHUFFLED else "sample"]
        disk = 2 * files + 2 * each * point / DISK
        rows.append([name, f"{sent:.2g}", f"{messages:.2g}", *(f"{part:.0f}" for part in (computing, disk, network, first))])
    table(f"{ranks} ranks, {points:.0e} points of {record} bytes, {samples:.0e} samples",
          ["command", "bytes sent", "messages", "s of computing", "s of files", "s of the network", "s of the first rank"], rows)


def table(title: str, head: list, rows: list):
    print(f"\n{title}\n\n| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(str(word) for word in row) + " |")


def sampling_of(scan: pathlib.Path) -> list:
    small, edited = scan.parent / "small.ply", scan.parent / "edited.ply"
    run([SCAN_PROGRAM, "sample", scan, "-o", small, "--target", str(TARGET), "--memory", "256MiB", "--json"])
    scans.write_bent(small, edited)
    return ["transfer", scan, "--from", small, "--to", edited, "-o", scan.parent / "out.raw"]


def sample_of(scan: pathlib.Path) -> list:
    return ["sample", scan, "-o", scan.parent / "sampled.ply", "--target", TARGET, "--memory", "64MiB"]


SECONDS = ["seconds", "CPU seconds of the busiest rank", "of all"]


def seconds_of(report: dict) -> list:
    return [f"{report[name]:.2f}" for name in ("seconds", "cpu_seconds", "cpu")]


def strong_scaling(scans_of: dict, costs: dict, busiest: dict):
    strong, checks = [], []
    for name, shuffled, arguments in COMMANDS:
        scan = scans_of[OPTIONS.points, shuffled]
        command, cubes = arguments(scan), 0.0
        for ranks in (1, 2, 4):
            report = measured(ranks, *command)
            strong.append([name, ranks, *seconds_of(report),
                           f"{report['peak_memory_bytes'] / 2**20:.0f}", report["bytes_sent"], report["messages_sent"]])
            busiest[name, ranks] = report["cpu_seconds"]
            if ranks == 1:
                costs[name] = report["cpu_seconds"] / OPTIONS.points
                continue
            model = transfer_model(ranks)[0]
            if "samples" in report:
                foreign = foreign_points(cells_of(scan.parent / "sampled.ply.cells"), OPTIONS.points, ranks)
                cubes = cubes or cubes_of(report, foreign)
                model = sample_bytes(ranks, report["shuffled"], foreign, report["cells"], cubes, report["samples"])
            checks.append([name, ranks, report["bytes_sent"], round(model)])
    table(f"Strong scaling: {OPTIONS.points} points",
          ["command", "ranks", *SECONDS, "MiB of the largest rank", "bytes sent", "messages"], strong)
    table("The model (the number of cubes is that of 2 ranks)", ["command", "ranks", "bytes sent", "by the model"], checks)


def weak_scaling(scans_of: dict, busiest: dict):
    """Also compares the seconds of strong scaling with the model: a part for each rank, and the points of its range."""
    rows, checks = [], []
    for name, shuffled, arguments in COMMANDS:
        for ranks in (1, 2, 4):
            points = OPTIONS.points * ranks // 4
            report = measured(ranks, *arguments(scans_of[points, shuffled]))
            rows.append([name, ranks, points, *seconds_of(report)])
            if ranks == 1:  # a quarter of the points
                whole = busiest[name, 1]
                fixed = max(0.0, (4 * report["cpu_seconds"] - whole) / 3)
                checks += [[name, other, f"{busiest[name, other]:.2f}", f"{fixed + (whole - fixed) / other:.2f}"]
                           for other in (2, 4)]
    table("The model of CPU seconds", ["command", "ranks", "CPU seconds of the busiest rank", "by the model"], checks)
    table("Weak scaling", ["command", "ranks", "points", *SECONDS], rows)


def mesh_scaling(folder: pathlib.Path):
    """simplify of a mesh with side x side vertices."""
    mesh = scans.write_wide_mesh(folder / "mesh.ply", OPTIONS.side)
    command = ["simplify", mesh, "-o", folder / "simple.ply", "--target", TARGET, "--memory", "256MiB"]
    rows = []
    for ranks in (1, 2, 4):
        report = measured(ranks, *command)
        rows.append(["simplify", ranks, *seconds_of(report), f"{report['peak_memory_bytes'] / 2**20:.0f}",
                     report["bytes_sent"], report["messages_sent"]])
    table(f"Simplify: {OPTIONS.side ** 2} vertices, {2 * (OPTIONS.side - 1) ** 2} triangles",
          ["command", "ranks", *SECONDS, "MiB of the largest rank", "bytes sent", "messages"], rows)


COMMANDS = [("transfer", False, sampling_of), ("sample", False, sample_of), ("transfer, shuffled", True, sampling_of),
            ("sample, shuffled", True, sample_of)]


def main(folder: pathlib.Path):
    mesh_scaling(folder)
    if OPTIONS.only_mesh:
        return
    scans_of, costs, busiest = {}, {}, {}
    for shuffled in (False, True):
        for points in (OPTIONS.points // 4, OPTIONS.points // 2, OPTIONS.points):
            name = f"{points}{'.shuffled' if shuffled else ''}.raw"
            scans_of[points, shuffled] = scans.write_raw(folder / name, scans.bumpy_sphere(points, shuffled))
    strong_scaling(scans_of, costs, busiest)
    weak_scaling(scans_of, busiest)
    with_normals = scans.write_ply(folder / "normals.ply", scans.bumpy_sphere(OPTIONS.points // 2))
    few, many = (measured(1, "sample", with_normals, "-o", folder / "sampled.ply", "--memory", "128MiB", "--target", target)
                 for target in (TARGET, 10 * TARGET))
    costs["sample written"] = max(0.0, many["cpu_seconds"] - few["cpu_seconds"]) / (9 * TARGET)
    print("\nSeconds of a rank:", {name: f"{cost:.2g}" for name, cost in costs.items()})
    large_model(costs)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("programs", nargs=2)
    parser.add_argument("--points", type=int, default=4000000)
    parser.add_argument("--side", type=int, default=1000)
    parser.add_argument("--only-mesh", action="store_true")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--folder", default=None)
    OPTIONS = parser.parse_args()
    SCAN_PROGRAM, MPI_PROGRAM = OPTIONS.programs
    with tempfile.TemporaryDirectory(dir=OPTIONS.folder) as temporary:
        main(pathlib.Path(temporary))
