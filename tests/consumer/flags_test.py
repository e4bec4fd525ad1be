"""Builds every example, joined into one program, and a program that uses Eigen with settings of its own,
against an installed lodlab, with compiler flags that the library was not built with. Each must compile, run to
its end, and print and write the same bytes as with no flags at all. What must not compile or link is tried, too.

Usage: flags_test.py --prefix DIR --libdir lib --sources DIR --compilers g++ [clang++ ...]
                     [--base FLAGS] [--built DIR] [--all]
--base are flags that the library itself needs (a sanitizer's); DIR holds programs that were built with the
library itself and no flags of their own, the others are built anew; --all tries every flag with every
standard and sanitizer, which takes some minutes; without it the worst of them are tried, all together.
"""

import argparse
import concurrent.futures
import hashlib
import itertools
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

FEW = [["-march=native", "-O2", "-ffp-contract=fast", "-DEIGEN_MAX_ALIGN_BYTES=64", "-std=c++2b"]]
ALL = [
    ["-march=x86-64-v2"],
    ["-march=x86-64-v3"],
    ["-march=x86-64-v4"],
    ["-march=native"],
    ["-march=native", "-ffp-contract=fast"],
    ["-DEIGEN_MAX_ALIGN_BYTES=64"],
    ["-DEIGEN_DONT_VECTORIZE"],
]
# flags: what the message must say
REFUSED = {
    ("-ffast-math",): "forget infinities",
    ("-Ofast",): "forget infinities",
    ("-fpack-struct",): "another layout",
    ("-fshort-enums",): "another layout",
    ("-D_GLIBCXX_DEBUG",): "layout_0_1_with_GLIBCXX_DEBUG",
}
WITH_EIGEN = "with_eigen"
EXAMPLES = "examples"


def joined(paths):
    """Programs, each of which ends with its main, as one whose argument says which is to run."""
    includes, bodies = set(), []
    for path in paths:
        lines = path.read_text().splitlines()
        includes |= {line for line in lines if line.startswith("#include")}
        body = "\n".join(line for line in lines if not line.startswith("#include"))
        end = body.rindex("}")
        body = body[:end].replace("int main()", "int run()") + "    return 0;\n}"
        bodies.append(f"namespace example_{path.stem} {{\n{body}\n}}")
    choices = [f'    if (name == "{path.stem}") return example_{path.stem}::run();' for path in paths]
    return "\n".join([*sorted(includes), "#include <string_view>", *bodies,
                      "int main(int, char** words) {", "    const std::string_view name = words[1];",
                      *choices, "    return 99;", "}", ""])


def runs_here(flags):
    """Whether this machine executes what the flags ask for."""
    level = [flag.rsplit("-", 1)[1] for flag in flags if flag.startswith("-march=x86-64-v")]
    if not level:
        return True
    loader = next(iter(pathlib.Path("/lib64").glob("ld-linux-x86-64.so.2")), None)
    if loader is None:
        return False
    said = subprocess.run([loader, "--help"], capture_output=True, text=True).stdout
    return f"x86-64-{level[0]} (supported" in said


class Consumer:
    def __init__(self, arguments):
        self.sources = pathlib.Path(arguments.sources)
        self.base = shlex.split(arguments.base)
        self.built = pathlib.Path(arguments.built).resolve() if arguments.built else None
        environment = dict(os.environ)
        folder = f"{arguments.prefix}/{arguments.libdir}/pkgconfig"
        environment["PKG_CONFIG_PATH"] = folder + ":" + environment.get("PKG_CONFIG_PATH", "")
        modules = ["lodlab-viz", "lodlab-io", "lodlab-lod2d", "lodlab-lod3d", "lodlab-lod3d_source", "lodlab-scenes"]

        def ask(what):
            answer = subprocess.run(["pkg-config", what, *modules], env=environment, check=True,
                                    capture_output=True, text=True)
            return answer.stdout.split()

        self.cflags = ask("--cflags")
        self.libs = ask("--libs")
        # Eigen is the program's own affair: lodlab's headers need none.
        self.eigen = subprocess.run(["pkg-config", "--cflags", "eigen3"], check=True,
                                    capture_output=True, text=True).stdout.split()
        # Fontconfig keeps what it has read until the program ends: memory errors are looked for here.
        self.environment = dict(os.environ, LD_LIBRARY_PATH=f"{arguments.prefix}/{arguments.libdir}",
                                ASAN_OPTIONS="detect_leaks=0")
        paths = sorted((self.sources / "examples").glob("*.cpp"))
        self.names = {EXAMPLES: [path.stem for path in paths], WITH_EIGEN: [WITH_EIGEN]}
        self.folder = tempfile.TemporaryDirectory()
        examples = pathlib.Path(self.folder.name) / "examples.cpp"
        examples.write_text(joined(paths))
        self.programs = {EXAMPLES: examples, WITH_EIGEN: self.sources / "tests/consumer/with_eigen.cpp",
                         "two_bodies": self.sources / "examples/two_bodies.cpp"}

    def compile(self, name, compiler, flags, output):
        """The program's flags stand last, as a careless user's would."""
        eigen = self.eigen if name == WITH_EIGEN else []
        command = [compiler, "-std=c++20", *self.base, self.programs[name], *self.cflags, *eigen,
                   *flags, "-o", output, *self.libs]
        return subprocess.run(command, capture_output=True, text=True)

    def expected(self, name, compiler):
        """The outcome without flags."""
        programs = [self.built / one for one in self.names[name]] if self.built else []
        if programs and all(program.exists() for program in programs):
            return [self.outcome_of([program]) for program in programs]
        return self.outcome(name, compiler, [])

    def outcome(self, name, compiler, flags):
        """What each of the program's parts prints and writes; or a line that begins with an exclamation mark."""
        with tempfile.TemporaryDirectory() as building:
            program = pathlib.Path(building) / "program"
            built = self.compile(name, compiler, flags, program)
            if built.returncode != 0:
                return ["! does not compile: " + built.stderr.strip()[-2000:]]
            return [self.outcome_of([program, one]) for one in self.names[name]]

    def outcome_of(self, command):
        with tempfile.TemporaryDirectory() as folder:
            ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, env=self.environment)
            if ran.returncode != 0:
                return f"! {command[-1]} ends with {ran.returncode}: {ran.stderr.strip()[-2000:]}"
            written = [f"{path.name} {hashlib.sha256(path.read_bytes()).hexdigest()}"
                       for path in sorted(pathlib.Path(folder).iterdir())]
            return "\n".join([ran.stdout, *written])


def check_refusals(consumer, compilers):
    wrong = []
    for compiler, (flags, message) in itertools.product(compilers, REFUSED.items()):
        if "clang" in pathlib.Path(compiler).name and "-fpack-struct" in flags:
            flags = ("-fpack-struct=1",)
        with tempfile.TemporaryDirectory() as folder:
            built = consumer.compile("two_bodies", compiler, list(flags), f"{folder}/program")
        if built.returncode == 0 or message not in built.stderr:
            wrong.append(f"{compiler} {' '.join(flags)}: should be refused by a message with "
                         f"\"{message}\"; it said {built.stderr[-500:] or 'nothing'}")
    return wrong


def main():
    parser = argparse.ArgumentParser()
    for option in ("--prefix", "--libdir", "--sources"):
        parser.add_argument(option, required=True)
    parser.add_argument("--compilers", nargs="+", required=True)
    parser.add_argument("--base", default="")
    parser.add_argument("--built")
    parser.add_argument("--all", action="store_true")
    arguments = parser.parse_args()
    consumer = Consumer(arguments)

    flag_sets = FEW
    if arguments.all:
        flag_sets = [flags + ["-O2", standard, *sanitizer] for flags in ALL
                     for standard in ("-std=c++20", "-std=c++2b")
                     for sanitizer in ([], ["-fsanitize=address"])]
    skipped = [flags for flags in flag_sets if not runs_here(flags)]
    flag_sets = [flags for flags in flag_sets if flags not in skipped]

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        expected = dict(zip(consumer.names, pool.map(
            lambda name: consumer.expected(name, arguments.compilers[0]), consumer.names)))
        trials = list(itertools.product(consumer.names, arguments.compilers, flag_sets))
        found = list(pool.map(lambda trial: consumer.outcome(*trial), trials))

    wrong = check_refusals(consumer, arguments.compilers)
    wrong += [f"with no flags {one}" for outcome in expected.values() for one in outcome if one[0] == "!"]
    for (name, compiler, flags), outcome in zip(trials, found):
        if len(outcome) != len(expected[name]):
            wrong.append(f"{name}, {compiler} {' '.join(flags)}:\n{outcome[0]}")
            continue
        for part, one, wanted in zip(consumer.names[name], outcome, expected[name]):
            if one != wanted:
                wrong.append(f"{part}, {compiler} {' '.join(flags)}:\n{one}\ninstead of\n{wanted}")
    print("\n\n".join(wrong))
    for flags in skipped:
        print(f"not tried, this machine lacks the instructions: {' '.join(flags)}")
    tried = sum(len(consumer.names[name]) for name, _, _ in trials) + len(REFUSED) * len(arguments.compilers)
    print(f"{tried} tried, {len(wrong)} not as they should be")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
