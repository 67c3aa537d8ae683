#!/usr/bin/env python3
"""CPU of two runs from one time of theirs to another, both under way at the same time on one core.

    bench/between.py TURNS FROM TO DIR_A 'COMMAND A' DIR_B 'COMMAND B'

    bench/between.py 3 0.01 0.12 a "stiffwater-3d run my.scene until=0.3 -q -f -o a --threads 1" \\
        b "mpirun -n 2 stiffwater-3d-mpi run my.scene until=0.3 -q -f -o b --threads 1"

Each turn prints CPU seconds of both between the times FROM and TO [s] of the runs, and B over A; then the median.
How far each has come is read in front.csv of its directory, so the scene has fluid and an output.interval that is
short beside TO - FROM; `until` lies well behind TO, as both are to be under way when the slower one comes there, and
are ended then.  What the start takes is not in it, and both share the core with each other for the whole of it, which
`bench/side-by-side.sh` leaves to chance: there the longer one has the core for itself at the end.  Turns of 25 s
scatter by 1 to 4 % where whole runs side by side scatter by up to 10.  CORE=N in the environment: another core than 0.
"""
import os
import shlex
import signal
import statistics
import subprocess
import sys
import time

PERIOD = 0.03  # s between looks


def processes(pid):
    """The process and all that it started."""
    found = [pid]
    for task in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{task}/children") as children:
            for child in children.read().split():
                found += processes(int(child))
    return found


def cpu(pid):
    """CPU of the process and all that it started, with all their threads [s]."""
    total = 0
    for one in processes(pid):
        for task in os.listdir(f"/proc/{one}/task"):
            with open(f"/proc/{one}/task/{task}/schedstat") as times:
                total += int(times.read().split()[0])
    return 1e-9 * total


def reached(directory):
    """The time of the last whole row of front.csv [s]; -1: there is none."""
    try:
        with open(os.path.join(directory, "front.csv")) as rows:
            last = rows.read().rpartition("\n")[0].rpartition("\n")[2]
        return float(last.split(",")[0])
    except (OSError, ValueError):
        return -1


class Run:
    """One of the two commands, and what CPU it had taken at which time of its run."""

    def __init__(self, directory, command):
        self.directory, self.seen = directory, []
        try:
            os.remove(os.path.join(directory, "front.csv"))
        except FileNotFoundError:
            pass
        words = ["taskset", "-c", os.environ.get("CORE", "0"), *shlex.split(command)]
        self.process = subprocess.Popen(words, stdout=subprocess.DEVNULL, start_new_session=True)

    def look(self):
        """Notes where it is; ends the program where it has come to an end."""
        if self.process.poll() is not None:
            sys.exit(f"{self.directory}: the run ended before both came to TO: set a later until")
        t, last = reached(self.directory), self.seen[-1][0] if self.seen else -1
        if t <= last:
            return last
        try:
            self.seen.append((t, cpu(self.process.pid)))
        except FileNotFoundError:  # one of its processes ended while it was asked: later, then
            return last
        return t

    def at(self, t):
        """CPU when it came to t, between rows as if it were even [s]."""
        for (before, a), (after, b) in zip(self.seen, self.seen[1:]):
            if before <= t <= after:
                return a + (b - a) * (t - before) / (after - before)
        sys.exit(f"{self.directory}: no row of front.csv at or before {t:g} s: choose a later FROM")

    def end(self):
        for one in processes(self.process.pid):
            os.kill(one, signal.SIGKILL)
        self.process.wait()


def turn(start, stop, commands):
    runs = [Run(*one) for one in commands]
    try:
        while min([run.look() for run in runs]) < stop:
            time.sleep(PERIOD)
        return [run.at(stop) - run.at(start) for run in runs]
    finally:
        for run in runs:
            if run.process.poll() is None:
                run.end()


def main():
    if len(sys.argv) != 8:
        sys.exit(__doc__)
    turns, start, stop = int(sys.argv[1]), float(sys.argv[2]), float(sys.argv[3])
    ratios = []
    for _ in range(turns):
        a, b = turn(start, stop, [sys.argv[4:6], sys.argv[6:8]])
        ratios.append(b / a)
        print(f"A {a:.2f} s, B {b:.2f} s, B over A {b / a:.3f}", flush=True)
    print(f"median {statistics.median(ratios):.3f}")


main()
