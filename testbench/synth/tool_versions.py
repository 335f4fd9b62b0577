# SPDX-License-Identifier: Apache-2.0
"""The tools that read the RTL, and the versions of them with which it is tested.

Every script starts them by the name that tool() returns: one line on stderr says when the version
found is another, so that an odd failure can be told from a new tool.
"""
import functools
import re
import shutil
import subprocess
import sys

# How to ask, and the versions of Debian 12 and Debian 13.
TESTED = {"verilator": ("--version", ("5.006", "5.032")), "yosys": ("-V", ("0.23", "0.52"))}


@functools.cache
def version(name):
    """The version that `name` is, or None where it is not installed."""
    if shutil.which(name) is None:
        return None
    said = subprocess.run([name, TESTED[name][0]], capture_output=True, text=True, check=False)
    number = re.match(r"\w+ (\d+\.\d+)", said.stdout)
    return number[1] if number else "unknown"


@functools.cache
def tool(name):
    """`name`, for a command line. Notes a version that is not tested, once."""
    found, tested = version(name), TESTED[name][1]
    if found is not None and found not in tested:
        print(f"note: {name} {found} is not tested; {' and '.join(tested)} are", file=sys.stderr)
    return name
