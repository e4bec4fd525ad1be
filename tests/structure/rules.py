"""The rules of the house, read from the sources: which folder may include which, where Dim may be
tested, where the large libraries may appear, and how long a file and a function may be.

Usage: rules.py FOLDER    prints each breach as file:line: what; exits 1 when there is one
"""

import pathlib
import re
import sys

LIBRARIES = ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "lessons", "cli"]

# Includes run one way: a folder may include itself and these.
MAY_INCLUDE = {
    "core": [],
    "io": ["core"],
    "lod2d": ["core", "io"],
    "lod3d": ["core", "io"],
    "scenes": ["core", "io", "lod2d", "lod3d"],
    "measure": ["core", "io", "lod2d", "lod3d", "scenes"],
    "viz": ["core", "io", "lod2d", "lod3d"],
    "lessons": ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz"],
    "cli": ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "lessons"],
    "examples": ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "lessons"],
    "tests": LIBRARIES,
    "bench": LIBRARIES,
}

# Each of these stands behind one file of ours.
ONE_SOURCE = {
    "Cairo and Pango": r"<(cairo|pango)",
    "Box2D": r"<box2d/",
    "libav": r"<lib(av|sw)\w+/",
    "assimp": r"<assimp/",
}

# These are slow to compile or not part of our interface: sources only, never headers.
NOT_IN_HEADERS = r"<(nlohmann/json\.hpp|toml\+\+/|toml|CLI/|boost/|pugixml|polyclipping/|ft2build|fontconfig/|md4c|mustache)"

TESTS_DIM = re.compile(
    r"\bDim\b\s*([=!]=|[<>]=?\s*\d|[%?])|\b\d\s*([=!]=|[<>]=?)\s*Dim\b"
    r"|template\s*<\s*>[^;{]*<\s*[23]\s*>"
)
MAY_TEST_DIM = "core/dimension.hpp"

MOST_FILE_LINES = 400
MOST_FUNCTION_LINES = 60

INCLUDE = re.compile(r'^\s*#\s*include\s*(<[^>]+>|"[^"]+")')
NO_FUNCTION = re.compile(r"^(if|for|while|switch|else|do|catch|try|namespace|struct|class|enum|union|extern)\b")


def without_comments(text):
    """The text with comments and the insides of strings blanked; every line keeps its number."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
    return token.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def includes_of(text):
    """(line number, "folder/file.hpp" or <system>) of each include."""
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1)


def functions_of(code):
    """(first line, lines) of each function body outside other functions, by matching braces."""
    outer = []  # per open brace: (whether it opened a function, line of its head)
    head_start = 0
    for match in re.finditer(r"[{};]|^\s*#[^\n]*|\b(public|private|protected)\s*:", code, re.M):
        character = match.group()
        if character == "{":
            head = code[head_start : match.start()].strip()
            inside = any(is_function for is_function, _ in outer)
            is_function = ")" in head and not NO_FUNCTION.match(head) and not inside
            outer.append((is_function, code.count("\n", 0, match.start()) + 1))
        elif character == "}" and outer:
            is_function, first = outer.pop()
            if is_function:
                yield first, code.count("\n", 0, match.start()) + 1 - first + 1
        head_start = match.end()


def check_includes(name, text, breaches):
    folder = name.split("/")[0]
    for line, included in includes_of(text):
        if included[0] == "<":
            if name.endswith(".hpp") and folder in LIBRARIES and re.match(NOT_IN_HEADERS, included):
                breaches.append(f"{name}:{line}: {included} in a header; include it in a .cpp")
            continue
        other = included.strip('"').split("/")[0]
        if "/" not in included:
            breaches.append(f"{name}:{line}: {included} without its folder")
        elif other != folder and other not in MAY_INCLUDE[folder]:
            breaches.append(f"{name}:{line}: {folder} must not include {included}")
        elif name.startswith("viz/figure.") and included.strip('"') != "viz/figure.hpp":
            breaches.append(f"{name}:{line}: viz/figure stands alone; it must not include {included}")


def check_one_source(texts, breaches):
    for library, pattern in ONE_SOURCE.items():
        users = {
            name: line
            for name, text in sorted(texts.items())
            if name.split("/")[0] in LIBRARIES
            for line, included in includes_of(text)
            if re.match(pattern, included)
        }
        for name, line in users.items():
            if name.endswith(".hpp"):
                breaches.append(f"{name}:{line}: {library} in a header; keep it behind one .cpp")
            elif len(users) > 1:
                breaches.append(f"{name}:{line}: {library} in more than one file: {', '.join(users)}")


def check_circles(texts, breaches):
    """No chain of includes leads back to its start."""
    after = {
        name: [included.strip('"') for _, included in includes_of(text) if included[0] == '"']
        for name, text in texts.items()
    }
    done = set()

    def visit(name, path):
        if name in path:
            breaches.append(f"{name}:1: includes itself: {' -> '.join(path[path.index(name):] + [name])}")
        elif name in after and name not in done:
            for other in after[name]:
                visit(other, path + [name])
            done.add(name)

    for name in sorted(after):
        visit(name, [])


def check_code(name, text, breaches):
    code = without_comments(text)
    folder = name.split("/")[0]
    if folder in LIBRARIES and name != MAY_TEST_DIM:
        for number, line in enumerate(code.splitlines(), 1):
            if TESTS_DIM.search(line):
                breaches.append(f"{name}:{number}: asks for Dim; only {MAY_TEST_DIM} may")
    lines = text.count("\n")
    if lines > MOST_FILE_LINES:
        breaches.append(f"{name}:1: {lines} lines; at most {MOST_FILE_LINES}")
    for first, length in functions_of(code):
        if length > MOST_FUNCTION_LINES:
            breaches.append(f"{name}:{first}: a function of {length} lines; at most {MOST_FUNCTION_LINES}")


def breaches_in(root):
    """Every breach below a folder, as file:line: what."""
    root = pathlib.Path(root)
    texts = {
        path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
        for folder in MAY_INCLUDE
        for path in sorted((root / folder).rglob("*.?pp"))
    }
    breaches = []
    for name, text in texts.items():
        check_includes(name, text, breaches)
        check_code(name, text, breaches)
    check_one_source(texts, breaches)
    check_circles(texts, breaches)
    if not texts:
        breaches.append(f"{root}:0: no sources here")
    return breaches


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("rules.py: name the one folder to read")
    found = breaches_in(sys.argv[1])
    print("\n".join(found) or "the rules hold")
    sys.exit(1 if found else 0)
