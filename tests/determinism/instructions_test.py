"""Reads the disassembly of the libraries that decide results: none may hold an instruction that a maker
of processors may round in his own way (reciprocals and square roots that are approximations), or one that
fuses a product and a sum, whichever instruction set the libraries were compiled for. Exempt is what
core/tree/family_kernels.cpp makes for newer instructions: it decides no test that its rounding might turn.

Usage: instructions_test.py OBJDUMP ARCHIVE...    exits 1 and names the functions where there is one
       instructions_test.py --self-test
"""

import re
import subprocess
import sys

# x86: rcpps, rsqrtss, vrcp14pd, vrsqrt28ps, vfmadd213sd, ...; arm64: frecpe, frsqrte and their steps,
# fmadd, fmla, ...
FORBIDDEN = re.compile(
    r"\bv?(rcp|rsqrt)(14|28)?[ps][sdh]\b|\bvfn?m(add|sub)\w*|\bfr(ecp|sqrt)[esx]\b|\bfn?m(add|sub|la|ls)\b"
)
EXEMPT = re.compile(r"\blod::detail::N_AVX")
FUNCTION = re.compile(r"^[0-9a-f]+ <(.*)>:$")


def forbidden_in(disassembly):
    """(function, instruction) of each."""
    function = "?"
    for line in disassembly.splitlines():
        named = FUNCTION.match(line)
        if named:
            function = named.group(1)
        elif FORBIDDEN.search(line.split("<")[0]) and not EXEMPT.search(function):
            yield function, line.split("\t")[-1].strip()


def main():
    if sys.argv[1:] == ["--self-test"]:
        planted = "0000 <f()>:\n 1:\t0f 52 c0\trsqrtps %xmm0,%xmm0\n 2:\t51\tsqrtps %xmm0,%xmm1\n" \
                  " 3:\tc4\tvfmadd213sd %xmm0,%xmm1,%xmm2\n 4:\t1f\tfmadd d0, d1, d2, d3\n"
        assert len(list(forbidden_in(planted))) == 3, list(forbidden_in(planted))
        print("planted instructions are found")
        return 0
    objdump, *archives = sys.argv[1:]
    found = []
    lines = 0
    for archive in archives:
        text = subprocess.run([objdump, "-dC", "--no-show-raw-insn", archive], capture_output=True,
                              text=True, check=True).stdout
        lines += text.count("\n")
        found += [f"{archive}: {instruction} in {function}" for function, instruction in forbidden_in(text)]
    print("\n".join(found) or f"{lines} lines of disassembly, no approximate or fused instruction")
    return 1 if found or lines == 0 else 0


sys.exit(main())
