"""The rules of the house, read from the sources: which folder may include which, where Dim may be
tested, where the large libraries and the system may appear, how large a folder, a file and a function may be, and that nothing
is written once for the plane and once for space.

Usage: rules.py FOLDER             prints each breach as file:line: what; exits 1 when there is one
       rules.py --includes FOLDER  prints which room includes which, for draw_rooms
"""

import collections
import difflib
import pathlib
import re
import sys

LIBRARIES = ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "live", "lessons", "cli"]

# Includes run one way: a room may include itself and these, with all that is in them. A folder without
# a line of its own is part of the room around it.
MAY_INCLUDE = {
    "core/base": [],
    "core/math": ["core/base"],
    "core/tree": ["core/base", "core/math"],
    "core/builder": ["core/base", "core/math", "core/tree"],
    "core/contact": ["core/base", "core/math", "core/tree"],
    "core/response": ["core/base", "core/math", "core/tree", "core/contact"],
    "core/exact": ["core/base", "core/math", "core/tree", "core/contact", "core/response"],
    "core/broad": ["core/base", "core/math", "core/tree"],
    "core/frame": ["core/base", "core/math", "core/tree", "core/broad", "core/contact", "core/response", "core/exact"],
    "io/files": ["core/base"],
    "io": ["core", "io/files"],
    "lod2d/shape": ["core"],
    "lod2d/builder": ["core", "lod2d/shape"],
    "lod2d/source/paths": ["core", "lod2d/shape"],
    "lod2d/source/svg": ["core", "lod2d/shape", "lod2d/source/paths"],
    "lod2d/source/css": ["core", "lod2d/shape", "lod2d/source/paths", "lod2d/source/svg"],
    "lod2d/source/resolve": ["core", "io/files", "lod2d/shape", "lod2d/source/paths", "lod2d/source/svg", "lod2d/source/css"],
    "lod2d/source": ["core", "io/files", "lod2d/shape", "lod2d/source"],
    "lod3d/mesh": ["core"],
    "lod3d/solid": ["core", "lod3d/mesh"],
    "lod3d/builder": ["core", "lod3d/mesh", "lod3d/solid"],
    "lod3d/source": ["core", "io/files", "lod3d/mesh", "lod3d/solid"],
    "scenes": ["core", "io", "lod2d", "lod3d"],
    "scenes/crowd": ["core", "lod2d", "scenes"],
    "scenes/trace": ["core", "io", "scenes"],
    "scenes/threads": ["core/base", "core/tree"],
    "measure/reference": ["core", "lod2d/shape"],
    "measure/crowd": ["core"],
    "measure": ["core", "io", "lod2d", "lod3d", "scenes", "measure/reference"],
    "viz/figure": ["core"],
    "viz/draw": ["core", "lod2d", "lod3d", "viz/figure"],
    "viz/draw/motion": ["core", "lod2d", "lod3d", "viz/figure", "viz/draw"],
    "viz/paint": ["core", "io/files", "viz/figure"],
    "viz/film": ["core", "io/files", "viz/figure", "viz/paint"],
    "live": ["core", "io", "lod2d", "scenes", "viz/figure", "viz/draw"],
    "live/page": ["core", "lod2d", "live", "viz/figure", "viz/draw", "viz/paint"],
    "lessons/embed": ["core"],
    "lessons/exercises": ["core", "io", "lessons/embed"],
    "lessons/engine": ["core", "io/files", "lod2d", "lod3d", "measure", "viz", "live", "lessons/embed"],
    "lessons/course": ["core", "lod2d", "lod3d", "scenes", "measure", "viz", "live", "lessons/engine"],
    "lessons/book": ["core", "io", "lod2d", "lod3d", "viz", "live", "lessons/embed", "lessons/engine"],
    "cli/terminal": ["core"],
    "cli/arguments": ["core", "io", "lod2d", "lod3d", "scenes", "viz", "cli/terminal"],
    "cli/stage": ["core", "io/files", "lod2d", "lod3d", "scenes", "measure", "viz", "cli/terminal", "cli/arguments"],
    "cli/commands": ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "live", "lessons", "cli/terminal", "cli/arguments", "cli/stage"],
    "cli": ["core", "cli"],
    "examples": ["core", "io", "lod2d", "lod3d", "scenes", "measure", "viz", "lessons"],
    "tests": LIBRARIES,
    "bench": LIBRARIES + ["tests"],  # it measures against the oracles of the tests
}

# Each of these stands behind one file of ours.
ONE_SOURCE = {
    "Cairo and Pango": r"<(cairo(?!-script)|pango)",
    "librsvg and what it draws to": r"<(librsvg/|cairo-script)",
    "Box2D": r"<box2d/",
    "libav": r"<lib(av|sw)\w+/",
    "libwebp": r"<webp/",
    "assimp": r"<assimp/",
    "Eigen": r"<Eigen/",
    "Highway": r"<hwy/",
    "oneTBB": r"<(tbb|oneapi)/",
}

# Files, signals, processes and threads are not these rooms' affair; they compute anywhere.
WITHOUT_SYSTEM = ["core", "lod2d/shape", "lod2d/builder", "lod3d/mesh", "lod3d/solid", "lod3d/builder", "viz/figure", "live"]
OF_THE_SYSTEM = r"<(filesystem|fstream|iostream|csignal|thread|future|sys/|(unistd|fcntl|signal|poll|io|windows)\.h>)"

# What a build for WebAssembly compiles, too (scripts/wasm); its standard library lacks these.
PORTABLE = ["core", "io", "lod2d/shape", "lod2d/builder", "lod3d", "scenes", "measure", "viz/figure", "viz/draw", "live"]
NOT_PORTABLE = re.compile(r"\bstd::(ranges::\w+\s*\(|bit_cast\b)")
NATIVE = {"lod3d/source/gltf_promises.cpp"}  # is left out there

# A whole library in one header: <lodlab/core.hpp>, <lodlab/viz_paint.hpp>.
UMBRELLA = re.compile(r"(core|io|lod2d|lod3d|scenes|measure|reference|viz)(_[a-z]+)?\.hpp$")

# Lists of headers in cmake/headers: those that lodlab offers, and others that these include.
PUBLIC = "public.txt"
REACHED = "reached.txt"
BEGINS = re.compile(r"#pragma once\n\n(//[^\n]*\n)*/// \\file\n/// \w")

# What a picture is, as data: no body, no vector of ours.
ALONE = "viz/figure/figure"

# Takes vectors to Eigen's and back, for programs and tests; no source of the libraries includes it.
EIGEN_BORDER = "core/math/eigen.hpp"

# The C library rounds these as it likes; core/math/trigonometry.hpp has what gives the same bits everywhere.
ROUNDED_FREELY = re.compile(
    r"\bstd::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|hypot|cbrt|erf|[lt]gamma)\s*\("
)
DECIDE_RESULTS = ["core", "io", "lod2d", "lod3d", "scenes", "measure", "live"]

# These are slow to compile or not part of our interface: sources only, never headers.
NOT_IN_HEADERS = r"<(tbb/|nlohmann/json\.hpp|toml\+\+/|toml|CLI/|boost/|librsvg/|cairo|zlib|pugixml|polyclipping/|ft2build|fontconfig/|md4c|mustache)"

TESTS_DIM = re.compile(
    r"\bDim\b\s*([=!]=|[<>]=?\s*\d|[%?])|\b\d\s*([=!]=|[<>]=?)\s*Dim\b"
    r"|template\s*<\s*>[^;{]*<\s*[23]\s*>"
)
MAY_TEST_DIM = "core/math/dimension.hpp"

# What the plane and space call by two names, in one neutral word each.
NEUTRAL = {
    "polygon": "figure", "mesh": "figure",
    "shape": "body", "solid": "body",
    "polygonpiece": "piece", "meshpiece": "piece",
    "disc": "ball", "circle": "ball", "sphere": "ball",
    "boundaryindex": "distances", "meshdistance": "distances",
    "outline": "border", "surface": "border",
}  # fmt: skip
TOKENS = re.compile(r"[A-Za-z_]\w*|\d[\w.]*|[^\s\w]")
# What both offer under one name, for their own types; the bodies must not be alike all the same.
OFFERED_BY_BOTH = {"build_tree", "report_tree", "generate", "generators", "names_generator", "names_of"}
FEWEST_TOKENS = 30  # shorter bodies are alike by chance
MOST_ALIKE = 0.75  # of the tokens of two bodies

MOST_FILE_LINES = 400
CUT_NAME = re.compile(r'TEST_CASE(_SIG)?\("[^"]*;')
MOST_FUNCTION_LINES = 50
MOST_PARAMETERS = 5
MOST_FOLDER_FILES = 20

INCLUDE = re.compile(r'^\s*#\s*include\s*(<[^>]+>|"[^"]+")')
NO_FUNCTION = re.compile(r"^(if|for|while|switch|else|do|catch|try|namespace|struct|class|enum|union|extern)\b")


def without_comments(text):
    """The text with comments and the insides of strings blanked; every line keeps its number."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
    return token.sub(lambda match: re.sub(r"[^\n]", " ", match.group()), text)


def includes_of(text):
    """(line number, "folder/file.hpp" or <system>) of each include; <lodlab/...> is ours, too."""
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, re.sub(r"^[<\"]lodlab/(.*)[>\"]$", r'"\1"', match.group(1))


class Function:
    """A function's body that stands outside other functions."""

    def __init__(self, head, in_class, line, body):
        self.line = line
        self.body = body
        self.lines = body.count("\n") + 1
        head = re.sub(r"\[\[.*?\]\]|^\s*template\s*<[^{]*?>\s*(?=[\w\[])", " ", head, flags=re.S)
        named = re.search(r"([\w~]+(?:::[\w~]+)*)\s*\(", head)
        qualified = named.group(1) if named else ""
        self.name = qualified.split("::")[-1]
        self.is_member = in_class or "::" in qualified
        self.parameters = head[named.end() : matching(head, named.end())] if named else ""


def matching(text, start):
    """Where the bracket that stands open before `start` is closed."""
    depth = 1
    for at in range(start, len(text)):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return len(text)


def functions_of(code):
    """Every function's body outside other functions, by matching braces."""
    code = re.sub(r"=\s*\{\s*\}", lambda empty: "=" + empty.group()[1:].replace("{", " ").replace("}", " "), code)
    outer = []  # per open brace: (whether it opened a function, its place, its head)
    head_start = 0
    for match in re.finditer(r"[{};]|^\s*#[^\n]*|\b(public|private|protected)\s*:", code, re.M):
        character = match.group()
        if character == "{":
            head = code[head_start : match.start()].strip()
            inside = any(is_function for is_function, _, _ in outer)
            is_function = ")" in head and not NO_FUNCTION.match(head) and not inside
            outer.append((is_function, match.start(), head))
        elif character == "}" and outer:
            is_function, first, head = outer.pop()
            if is_function:
                in_class = any(re.search(r"\b(class|struct)\b", above) for _, _, above in outer)
                yield Function(head, in_class, code.count("\n", 0, first) + 1, code[first : match.end()])
        head_start = match.end()


def room_of(name):
    """The innermost room that a file's folder belongs to; None outside every room."""
    folder = name.rpartition("/")[0]
    while folder and folder not in MAY_INCLUDE:
        folder = folder.rpartition("/")[0]
    return folder or None


def check_includes(name, text, breaches):
    top = name.split("/")[0]
    room = room_of(name)
    if room is None:
        breaches.append(f"{name}:1: stands in no room; the rooms are in tests/structure/rules.py")
        return
    for line, included in includes_of(text):
        if included[0] == "<":
            if re.match(OF_THE_SYSTEM, included) and any(room.startswith(one) for one in WITHOUT_SYSTEM):
                breaches.append(f"{name}:{line}: {included} in {room}, which asks nothing of the system; io/files does")
            if name.endswith(".hpp") and top in LIBRARIES and re.match(NOT_IN_HEADERS, included):
                breaches.append(f"{name}:{line}: {included} in a header; include it in a .cpp")
            continue
        other = included.strip('"')
        if other == EIGEN_BORDER and top in LIBRARIES:
            breaches.append(f"{name}:{line}: {included} in a library; only programs and tests see Eigen")
        if UMBRELLA.match(other) and top not in LIBRARIES:
            continue  # a program's choice; a library names what it needs
        if "/" not in other:
            breaches.append(f"{name}:{line}: {included} without its folder")
        elif room_of(other) != room and not any(other.startswith(allowed + "/") for allowed in MAY_INCLUDE[room]):
            breaches.append(f"{name}:{line}: {room} must not include {included}")
        elif re.match(ALONE + r"\.", name) and not re.match(ALONE + r"\.", other):
            breaches.append(f"{name}:{line}: {ALONE} stands alone; it must not include {included}")


def check_folders(texts, breaches):
    """No folder has more sources than a reader can overlook."""
    sizes = collections.Counter(name.rpartition("/")[0] for name in texts)
    for folder, files in sorted(sizes.items()):
        if files > MOST_FOLDER_FILES:
            breaches.append(f"{folder}/:1: {files} sources; at most {MOST_FOLDER_FILES}")


def check_one_source(texts, breaches):
    for library, pattern in ONE_SOURCE.items():
        users = {
            name: line
            for name, text in sorted(texts.items())
            if name.split("/")[0] in LIBRARIES
            for line, included in includes_of(text)
            if re.match(pattern, included) and name != EIGEN_BORDER
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
    if folder in DECIDE_RESULTS:
        for number, line in enumerate(code.splitlines(), 1):
            if ROUNDED_FREELY.search(line):
                breaches.append(f"{name}:{number}: a function of the C library; take core/math/trigonometry.hpp's")
    if any(name.startswith(portable + "/") for portable in PORTABLE) and name not in NATIVE:
        for number, line in enumerate(code.splitlines(), 1):
            if NOT_PORTABLE.search(line):
                breaches.append(f"{name}:{number}: libc++ for WebAssembly lacks it; CONTRIBUTING.md says what to take")
    for number, line in enumerate(text.splitlines(), 1):
        if CUT_NAME.search(line):
            breaches.append(f"{name}:{number}: a test's name with a semicolon; ctest cuts it there and runs nothing")
    lines = text.count("\n")
    if lines > MOST_FILE_LINES:
        breaches.append(f"{name}:1: {lines} lines; at most {MOST_FILE_LINES}")
    for function in functions_of(code):
        if function.lines > MOST_FUNCTION_LINES:
            breaches.append(
                f"{name}:{function.line}: a function of {function.lines} lines; at most {MOST_FUNCTION_LINES}"
            )
        taken = len(types_of(function.parameters)) if function.parameters.strip() else 0
        if folder in LIBRARIES and folder != "lessons" and taken > MOST_PARAMETERS:
            breaches.append(
                f"{name}:{function.line}: {function.name} takes {taken} parameters; at most {MOST_PARAMETERS}, more in a struct"
            )


def neutral(code):
    """The tokens of a piece of code without what tells the plane from space."""
    code = re.sub(r"\b(std|lod|lod2d|lod3d)::|\bconst\b|&", " ", code)
    code = re.sub(r"<\s*[23]\s*>|\b(Vector|Matrix)[23]d\b", "<Dim>", code)
    return [NEUTRAL.get(token.lower(), token) for token in TOKENS.findall(code)]


def types_of(parameters):
    """The neutral types of a list of parameters, without their names and default values."""
    depth = 0
    types = [""]
    for character in parameters:
        depth += {"<": 1, "(": 1, "{": 1, ">": -1, ")": -1, "}": -1}.get(character, 0)
        if character == "," and depth == 0:
            types.append("")
        else:
            types[-1] += character
    types = [neutral(re.sub(r"=.*", "", type, flags=re.S)) for type in types]
    return [type[:-1] if len(type) > 1 and type[-1].isidentifier() else type for type in types]


def share_a_shape(flat, deep):
    """Whether a function of the plane and one of space by the same name are one function written
    twice: free functions that take the same parameters once plane and space are called alike, unless
    both offer them to callers, or any two whose bodies, neutral too, are the same in three tokens of four. Members may share parameters
    alone: that is how the two offer core, or a container's vocabulary, under one name.
    """
    offers = flat.is_member or deep.is_member or flat.name in OFFERED_BY_BOTH
    if not offers and types_of(flat.parameters) == types_of(deep.parameters):
        return True
    bodies = [neutral(function.body) for function in (flat, deep)]
    if min(map(len, bodies)) < FEWEST_TOKENS:
        return False
    return difflib.SequenceMatcher(None, *bodies, autojunk=False).ratio() >= MOST_ALIKE


def check_twins(texts, breaches):
    """lod2d and lod3d share no function by name and shape."""
    functions = {"lod2d": {}, "lod3d": {}}
    for name, text in texts.items():
        folder = name.split("/")[0]
        for function in functions_of(without_comments(text)) if folder in functions else ():
            functions[folder].setdefault(function.name, []).append((name, function))
    for word in sorted(functions["lod2d"].keys() & functions["lod3d"].keys() - {""}):
        for flat_name, flat in functions["lod2d"][word]:
            for deep_name, deep in functions["lod3d"][word]:
                if share_a_shape(flat, deep):
                    breaches.append(
                        f"{deep_name}:{deep.line}: {word} is written in {flat_name}:{flat.line} too; "
                        "make it one template in core"
                    )


def listed(root, name):
    """The headers that a list of cmake/headers names; none where there is no such list."""
    path = pathlib.Path(root, "cmake/headers", name)
    lines = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    return [line for line in lines if line and not line.startswith("#")]


def check_headers(root, texts, breaches):
    """The public headers are there and say what they are for, the others that they include are known, and the
    examples, which show what a user writes, take public ones alone."""
    public, reached = listed(root, PUBLIC), listed(root, REACHED)
    below = set()
    ahead = list(public)
    while ahead:
        name = ahead.pop()
        if name not in below:
            below.add(name)
            ahead += [included.strip('"') for _, included in includes_of(texts.get(name, "")) if included[0] == '"']
    for name in public + reached:
        if name not in texts:
            breaches.append(f"{name}:1: is not there, but cmake/headers names it")
    for name in public:
        if name in texts and not BEGINS.match(texts[name]):
            breaches.append(f"{name}:1: is public; after #pragma once it says what it is for, below /// \\file")
    for name in sorted(below - set(public) - set(reached)):
        breaches.append(f"{name}:1: is internal, but a public header includes it; see cmake/headers/{REACHED}")
    for name in sorted(set(reached) - (below - set(public))):
        breaches.append(f"{name}:1: no public header includes it; take it from cmake/headers/{REACHED}")
    for name, text in texts.items():
        for line, included in includes_of(text) if name.startswith("examples/") else ():
            if included[0] == '"' and not UMBRELLA.match(included.strip('"')) and included.strip('"') not in public:
                breaches.append(f"{name}:{line}: {included} is internal; examples take public headers alone")


def texts_in(root):
    """The sources of every room, by name."""
    root = pathlib.Path(root)
    return {
        path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
        for folder in sorted({room.split("/")[0] for room in MAY_INCLUDE})
        for path in sorted((root / folder).rglob("*.?pp"))
    }


def includes_between_rooms(root):
    """room and a room that it includes: a line each."""
    pairs = set()
    for name, text in texts_in(root).items():
        for _, included in includes_of(text):
            other = room_of(included.strip('"')) if included[0] == '"' else None
            if other and other != room_of(name) and name.split("/")[0] in LIBRARIES:
                pairs.add(f"{room_of(name)} {other}")
    return sorted(pairs)


def breaches_in(root):
    """Every breach below a folder, as file:line: what."""
    texts = texts_in(root)
    breaches = []
    for name, text in texts.items():
        check_includes(name, text, breaches)
        check_code(name, text, breaches)
    check_folders(texts, breaches)
    check_one_source(texts, breaches)
    check_circles(texts, breaches)
    check_twins(texts, breaches)
    check_headers(root, texts, breaches)
    if not texts:
        breaches.append(f"{root}:0: no sources here")
    return breaches


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "--includes":
        print("\n".join(includes_between_rooms(sys.argv[2])))
        sys.exit()
    if len(sys.argv) != 2:
        sys.exit("rules.py: name the one folder to read")
    found = breaches_in(sys.argv[1])
    print("\n".join(found) or "the rules hold")
    sys.exit(1 if found else 0)
