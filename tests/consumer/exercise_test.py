"""The installed program checks an exercise with the headers that were installed beside it.

Usage: exercise_test.py PREFIX COMPILER
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PREFIX, COMPILER = pathlib.Path(sys.argv[1]), sys.argv[2]
PROGRAM = PREFIX / "bin/lodlab"


class InstalledExercise(unittest.TestCase):
    def test_the_headers_beside_the_program_are_taken(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            compiler = folder / "compiler"
            compiler.write_text(f'#!/bin/sh\necho "$@" > "{folder}/words"\nexec "{COMPILER}" "$@"\n')
            compiler.chmod(0o755)

            def exercise(*words):
                return subprocess.run(
                    [PROGRAM, "exercise", "impulse", *words], cwd=folder, capture_output=True, text=True,
                    env={**os.environ, "CXX": str(compiler)},
                )  # fmt: skip

            self.assertEqual(exercise().returncode, 0)
            (folder / "exercises/impulse.cpp").write_text(exercise("--solution").stdout)
            checked = exercise()
            self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)
            headers = [word[2:] for word in (folder / "words").read_text().split() if word.startswith("-I")]
            lasting = {pathlib.Path(header).resolve() for header in headers if pathlib.Path(header).is_dir()}
            own = {(folder / "exercises").resolve()}  # of the student
            self.assertEqual(lasting - own, {(PREFIX / "include").resolve()}, headers)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
