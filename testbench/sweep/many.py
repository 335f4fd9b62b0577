#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""many.py SPEC --out DIR --on local|parallel|slurm [-n N]: a sweep as N tasks, then merged.

Runs the shards of DIR that are missing, shows how far they are, merges them into DIR/sweep.jsonl.
The same command again runs what did not come. Needs Python's standard library alone.
"""
import argparse
import json
import os
import pathlib
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time

PER_ARRAY = 1000  # Slurm's MaxArraySize is 1001 unless a site says otherwise
SHARD = re.compile(r"shard-(\d+)-of-(\d+)\.jsonl")


def fail(text):
    print(f"many.py: {text}", file=sys.stderr)
    sys.exit(2)


def asked(command):
    """What a command prints; what it says when it refuses goes to the user, with its status."""
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.returncode)
    return done.stdout.strip()


def numbers_of(ranges):
    """[3, 7, 12, 13, 14] of "3,7,12-14"."""
    out = []
    for part in filter(None, ranges.split(",")):
        first, _, last = part.partition("-")
        out += range(int(first), int(last or first) + 1)
    return out


def ranges_of(numbers):
    parts = []
    for n in numbers:
        if parts and parts[-1][1] == n - 1:
            parts[-1][1] = n
        else:
            parts.append([n, n])
    return ",".join(str(a) if a == b else f"{a}-{b}" for a, b in parts)


class Watch:
    """How far the files of a folder are: only what was added since the last look is read."""

    def __init__(self, folder, total):
        self.folder, self.total = folder, total
        self.seen = {}  # shard: [bytes read, records, failed]
        self.look()
        self.before, self.start, self.next = self.done, time.monotonic(), 0
        self.shown = False

    def look(self):
        largest = {}
        for entry in os.scandir(self.folder):
            match = SHARD.match(entry.name)
            if match:
                try:
                    size = entry.stat().st_size
                except OSError:  # renamed since
                    continue
                largest[match[1]] = max(largest.get(match[1], (0, "")), (size, entry.path))
        for shard, (size, path) in largest.items():
            state = self.seen.setdefault(shard, [0, 0, 0])
            if size < state[0]:
                state[:] = [0, 0, 0]
            if size == state[0]:
                continue
            try:
                with open(path, "rb") as file:
                    file.seek(state[0])
                    text = file.read()
            except OSError:
                continue
            whole = text[:text.rfind(b"\n") + 1]
            state[0] += len(whole)
            state[1] += whole.count(b'{"case":')
            state[2] += whole.count(b',"error":{"code":') + whole.count(b'{"identical":false')
        self.done = sum(s[1] for s in self.seen.values())
        self.failed = sum(s[2] for s in self.seen.values())

    def show(self, last=False):
        now = time.monotonic()
        if not last and now < self.next:
            return
        self.look()
        took = time.monotonic() - now
        self.next = now + max(1 if sys.stderr.isatty() else 10, 20 * took)
        rate = (self.done - self.before) / max(now - self.start, 1e-9)
        left = f"{(self.total - self.done) / rate:.0f} s left" if rate > 0 else "no rate yet"
        line = (f"many.py: {self.done}/{self.total} cases  {rate:.1f}/s  {left}  "
                f"{self.failed} failed")
        end = "\n" if last or not sys.stderr.isatty() else ""
        print(("\r\033[K" if sys.stderr.isatty() else "") + line, end=end, file=sys.stderr,
              flush=True)


def on_local(args, shards, watch):
    waiting, running = list(shards), []
    try:
        while waiting or running:
            while waiting and len(running) < args.jobs:
                running.append(subprocess.Popen([*args.command, "--shard",
                                                 f"{waiting.pop(0)}/{args.count}"],
                                                stdout=subprocess.DEVNULL))
            running = [r for r in running if r.poll() is None]
            watch.show()
            time.sleep(0.05)
    finally:
        for one in running:
            one.terminate()


def on_parallel(args, shards, watch):
    if not shutil.which("parallel"):
        fail("GNU parallel is not installed (package parallel)")
    words = ["parallel", "--will-cite", "--jobs", str(args.jobs), "--joblog",
             str(args.out / "joblog"), "--", *map(shlex.quote, args.command), "--shard",
             "{}/" + str(args.count)]
    running = subprocess.Popen(words, stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
    try:
        running.stdin.write("".join(f"{i}\n" for i in shards))
        running.stdin.close()
        while running.poll() is None:
            watch.show()
            time.sleep(0.05)
    finally:
        running.terminate()


def submit(options, text):
    return asked(["sbatch", "--parsable", "--ntasks=1", *options, "--wrap", text]).split(";")[0]


def on_slurm(args, shards, watch):
    if not shutil.which("sbatch"):
        fail("Slurm is not installed here (package slurm-client)")
    common = ["--job-name=halfspace-sweep", f"--time={args.time}", "--requeue",
              "--open-mode=append", f"--chdir={os.getcwd()}", *args.sbatch]
    depends, jobs = [], []
    if args.has_rtl:  # once for all, so that the tasks find it
        jobs.append(submit([*common, f"--output={args.out}/log-rtl.txt"],
                           shlex.join([*args.command, "--build-rtl"])))
        depends = [f"--dependency=afterok:{jobs[0]}", "--kill-on-invalid-dep=yes"]
    for base in range(0, args.count, PER_ARRAY):
        part = [i - base for i in shards if base <= i < base + PER_ARRAY]
        if part:
            text = (f"exec {shlex.join(args.command)} "
                    f"--shard $((SLURM_ARRAY_TASK_ID + {base}))/{args.count}")
            jobs.append(submit([*common, *depends, f"--array={ranges_of(part)}",
                                f"--output={args.out}/log-{base}+%a.txt"], text))
    print(f"many.py: job {', '.join(jobs)}; scancel {' '.join(jobs)} ends it", file=sys.stderr)
    wait = 0.5
    while subprocess.run(["squeue", "-h", "-j", ",".join(jobs), "-o", "%i"], text=True,
                         stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                         check=False).stdout.strip():
        watch.show()
        time.sleep(wait)
        wait = min(1.2 * wait, 10)


def draw(merged):
    """The chart of area, error and throughput, of a sweep that has all three."""
    with open(merged) as file:
        if {"area", "coverage_error", "clocks"} <= json.loads(file.readline()).keys():
            script = pathlib.Path(__file__).with_name("sweep_chart.py")
            subprocess.run([sys.executable, script, merged, merged.parent], check=True)
            print(f"{merged.parent}/index.html: the chart")


def arguments():
    cores = len(os.sched_getaffinity(0))
    parser = argparse.ArgumentParser(prog="many.py", description=__doc__.split("\n")[0])
    parser.add_argument("spec", metavar="SPEC", type=pathlib.Path)
    parser.add_argument("--out", metavar="DIR", type=pathlib.Path, required=True)
    parser.add_argument("--on", choices=("local", "parallel", "slurm"), default="local")
    parser.add_argument("-n", dest="count", metavar="N", type=int,
                        help="tasks (default: those of DIR, else one for each core)")
    parser.add_argument("--jobs", type=int, default=cores, help="tasks at a time on this machine")
    parser.add_argument("--time", default="60", help="limit of a Slurm task (default 60 minutes)")
    parser.add_argument("--sbatch", action="append", default=[], metavar="OPTION",
                        help="another option for sbatch, such as --sbatch=--partition=short")
    parser.add_argument("--program", default=os.environ.get("HALFSPACE", "halfspace"))
    args = parser.parse_args()
    args.program = shutil.which(args.program) or fail(f"no program '{args.program}'")
    args.program = os.path.abspath(args.program)
    args.spec, args.out = args.spec.absolute(), args.out.absolute()
    there = {int(m[2]) for p in args.out.glob("shard-*") if (m := SHARD.match(p.name))}
    args.count = args.count or (min(there) if there else cores)
    if there and args.count not in there:
        fail(f"{args.out} has {', '.join(map(str, sorted(there)))} shards, not {args.count}")
    if not 1 <= args.count <= 1000000 or args.jobs < 1:
        fail(f"-n {args.count} or --jobs {args.jobs} is out of range")
    args.command = [args.program, "sweep", str(args.spec), "--out", str(args.out)]
    return args


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(2))
    args = arguments()
    cases = int(asked([args.program, "sweep", str(args.spec), "--count"]))
    args.has_rtl = "rtl" in json.loads(args.spec.read_text()).get("measure", [])
    args.out.mkdir(parents=True, exist_ok=True)
    merge = [args.program, "merge", str(args.out)]
    shards = list(range(args.count))
    if any(SHARD.match(p.name) for p in args.out.iterdir()):
        shards = numbers_of(asked([*merge, "--missing"]))
    watch = Watch(args.out, cases)
    try:
        if shards:
            {"local": on_local, "parallel": on_parallel, "slurm": on_slurm}[args.on](
                args, shards, watch)
    except KeyboardInterrupt:
        fail("interrupted; what is done stays, and the same command goes on")
    watch.show(last=True)
    out = args.out / "sweep.jsonl"
    out.unlink(missing_ok=True)
    status = subprocess.run([*merge, "--out", str(out)], check=False).returncode
    if status == 1 and not out.exists():
        print("many.py: the same command runs them again", file=sys.stderr)
    if out.exists():
        draw(out)
    sys.exit(status)


if __name__ == "__main__":
    main()
