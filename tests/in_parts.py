"""Runs a part of a test program's cases in one process: under the sanitizers starting a process for each
takes longer than most cases do.

Usage: in_parts.py PROGRAM PART PARTS    (PART from 1)
Cases whose names match the regular expression in CTEST_LEAVE_OUT are left out, as scripts/test does.
"""

import os
import re
import subprocess
import sys
import tempfile


def names_of(program):
    """Catch2 2 has an option for it, and ends with their number; Catch2 3 lists names where it is quiet."""
    old = subprocess.run([program, "--list-test-names-only"], capture_output=True, text=True)
    if "nrecognised" not in old.stdout + old.stderr and old.stdout:
        return old.stdout.splitlines()
    new = subprocess.run([program, "--list-tests", "--verbosity", "quiet"], capture_output=True, text=True, check=True)
    return new.stdout.splitlines()


def escaped(name):
    """As catch_discover_tests hands names over: a comma would end one, a bracket begin a tag."""
    return re.sub(r"([\\,\[\]])", r"\\\1", name)


def main():
    program, part, parts = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    left_out = re.compile(os.environ.get("CTEST_LEAVE_OUT") or "^$")
    names = names_of(program)
    if not names:
        sys.exit(f"in_parts: {program} names no cases")
    chosen = [name for name in names[part - 1::parts] if not left_out.search(name)]
    print(f"{len(chosen)} of {len(names)} cases, part {part} of {parts}", flush=True)
    if not chosen:
        return 0
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as listed:
        listed.write("\n".join(map(escaped, chosen)) + "\n")
        listed.flush()
        ran = subprocess.run([program, "--input-file", listed.name], stdout=subprocess.PIPE, text=True)
    print(ran.stdout)
    counted = re.search(r"in (\d+) test case|test cases: +(\d+)", ran.stdout)
    if ran.returncode == 0 and (not counted or int(counted[1] or counted[2]) != len(chosen)):
        sys.exit(f"in_parts: {program} did not run what it was asked to")
    return ran.returncode


sys.exit(main())
