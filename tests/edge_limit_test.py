#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""edge_limit_test.py ROOT: the width of E at a sample, docs/03_design/config.md, without a guard
band. Every edge between two points of a small lattice, at every sample of the frame: the biased
value fits 2n + s + f + 1 bits. With 16 samples, whose positions have a 0, the value before the bias
reaches 2^(2n+s+f) and does not; with fewer it does.

The sample positions are read from rtl/hs_pkg.sv."""
import pathlib
import re
import sys


def positions(package):
    """Samples -> [(x, y)], 1/16 px."""
    found = {}
    for axis in "XY":
        text = re.search(rf"SAMPLE_{axis} =\s(.*?);", package, re.S)[1]
        words = [int(word.replace("_", ""), 16) for word in re.findall(r"64'h([\dA-F_]+)", text)]
        for samples, word in zip((1, 2, 4, 8, 16), words, strict=True):
            found.setdefault(samples, []).append([word >> 4 * m & 15 for m in range(samples)])
    return {samples: list(zip(*axes)) for samples, axes in found.items()}


def extremes(n, s, f, offsets):
    """Least and greatest biased E, and greatest before the bias, in units of 2^-(s+f) px^2."""
    points = [(x, y) for x in range((1 << n + s) + 1) for y in range((1 << n + s) + 1)]
    samples = [((16 * i + x << f) // 16, (16 * j + y << f) // 16)
               for i in range(1 << n) for j in range(1 << n) for x, y in offsets]
    least, greatest, unbiased = 0, 0, 0
    for xi, yi in points:
        for xj, yj in points:
            a, b = yi - yj, xj - xi
            values = [a * (x - (xi << f - s)) + b * (y - (yi << f - s)) for x, y in samples]
            bias = 0 if a > 0 or (a == 0 and b > 0) else 1
            unbiased = max(unbiased, *values)
            greatest = max(greatest, max(values) - bias)
            least = min(least, min(values) - bias)
    return least, greatest, unbiased


def main():
    offsets = positions((pathlib.Path(sys.argv[1]) / "rtl/hs_pkg.sv").read_text())
    for n, s in ((1, 0), (1, 1), (2, 0), (2, 1), (3, 0)):
        for samples in offsets if n < 3 else (8, 16):
            f = max(s, {1: 1, 2: 2, 4: 3, 8: 4, 16: 4}[samples])
            limit = 1 << (2 * n + s + f)
            least, greatest, unbiased = extremes(n, s, f, offsets[samples])
            said = f"n = {n}, s = {s}, {samples} samples: {least} to {greatest}, unbiased {unbiased}"
            assert -limit <= least and greatest < limit, said
            assert (unbiased == limit) == (samples == 16), said
    print(said)


if __name__ == "__main__":
    main()
