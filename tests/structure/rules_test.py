"""Plants a breach of each rule in a small house and expects it to be found, alone."""

import pathlib
import tempfile
import unittest

from rules import breaches_in

# A member that plane and space could share.
EXCESS = """
struct Excess {
    double least(const lodNd::Point& x) const {
        double most = 0;
        for (const VectorNd& p : corners) most = std::max(most, (p - x).norm());
        return most + distance(x);
    }
};
"""

BEGINNING = "#pragma once\n\n/// \\file\n/// What is drawn.\n"

HOUSE = {
    "cmake/headers/public.txt": "# What is offered.\nlod2d/shape/shape.hpp\nviz/draw/tree.hpp\n",
    "cmake/headers/reached.txt": "core/math/dimension.hpp\ncore/tree/body.hpp\nviz/figure/figure.hpp\n",
    "examples/tree.cpp": "#include <lodlab/lod2d/shape/shape.hpp>\n#include <lodlab/core.hpp>\n",
    "core/math/dimension.hpp": "#pragma once\ntemplate <int Dim> constexpr bool plane = Dim == 2;\n",
    "core/tree/body.hpp": '#include "core/math/dimension.hpp"\n// Dim == 2 in a comment\n',
    "core/tree/ball.cpp": "template <int Dim> int points() { return Dim + 1; }\n",
    "lod2d/shape/shape.hpp": BEGINNING + '#include "core/tree/body.hpp"\n#include <nlohmann/json_fwd.hpp>\n',
    "lod2d/shape/measure.cpp": "double extent(const Polygon& polygon) { return 1; }\n" + EXCESS.replace("N", "2"),
    "lod3d/mesh/measure.cpp": "double extent(const Mesh& mesh, int axis) { return 1; }\n"
    "struct Hull { double least(const Point& p) const { return 2; } };\n",
    "measure/reference/box2d_reference.cpp": "#include <box2d/box2d.h>\n",
    "scenes/threads/thread_pool.cpp": "#include <tbb/parallel_for.h>\n",
    "viz/figure/figure.hpp": "#include <string>\n",
    "viz/figure/figure.cpp": '#include "viz/figure/figure.hpp"\n',
    "viz/draw/tree.hpp": BEGINNING + '#include "lod2d/shape/shape.hpp"\n#include "viz/figure/figure.hpp"\n',
    "viz/draw/motion/run.cpp": '#include "viz/draw/tree.hpp"\n',
    "viz/paint/space/render.cpp": '#include "viz/paint/canvas/canvas.hpp"\n',
    "viz/paint/canvas/canvas.hpp": '#include "viz/figure/figure.hpp"\n',
    "cli/commands/main.cpp": '#include <CLI/CLI.hpp>\n#include "viz/figure/figure.hpp"\n',
    "tests/video.cpp": "#include <libavformat/avformat.h>\n#include <lodlab/core.hpp>\n",
    "core/base/long.cpp": "void f(int a, int b, int c, int d, std::map<int, int> e) {\n" + "    g();\n" * 48 + "}\nstruct S {\n" + "int i;\n" * 300 + "};\n",
}

BREACHES = {
    "a lower folder includes a higher one": ("core/tree/a.cpp", '#include "viz/figure/figure.hpp"\n'),
    "the plane includes space": ("lod2d/shape/a.cpp", '#include "lod3d/mesh/mesh.hpp"\n'),
    "geometry includes a reader of drawings": ("lod2d/builder/a.cpp", '#include "lod2d/source/svg.hpp"\n'),
    "geometry includes the reference": ("lod2d/shape/b.cpp", '#include "measure/reference/box2d_reference.hpp"\n'),
    "a room of core includes one above": ("core/math/a.hpp", '#include "core/tree/body.hpp"\n'),
    "drawing includes painting": ("viz/draw/a.cpp", '#include "viz/paint/canvas/canvas.hpp"\n'),
    "painting includes drawing": ("viz/paint/space/a.cpp", '#include "viz/draw/tree.hpp"\n'),
    "a room includes one that stands on it": ("viz/draw/a.cpp", '#include "viz/draw/motion/run.hpp"\n'),
    "a file in no room": ("viz/a.cpp", "int i;\n"),
    "pictures include scenes": ("viz/draw/a.cpp", '#include "scenes/scene.hpp"\n'),
    "a library includes the tests": ("scenes/a.cpp", '#include "tests/catch.hpp"\n'),
    "a library includes all of another": ("viz/draw/a.cpp", '#include "lodlab/core.hpp"\n'),
    "an include without its folder": ("viz/draw/a.cpp", '#include "tree.hpp"\n'),
    "figure includes something of ours": ("viz/figure/figure.hpp", '#include "core/tree/body.hpp"\n'),
    "Dim is compared": ("core/tree/a.hpp", "template <int Dim> int f() { return Dim == 2 ? 1 : 3; }\n"),
    "Dim is compared from the left": ("core/tree/a.hpp", "static_assert(2 != Dim);\n"),
    "a specialisation for one dimension": ("core/tree/a.cpp", "template <> void f<2>(int) {}\n"),
    "a second file for oneTBB": ("cli/commands/a.cpp", "#include <tbb/task_arena.h>\n"),
    "a second file for Box2D": ("cli/commands/a.cpp", "#include <box2d/b2_body.h>\n"),
    "a function of the C library": ("measure/a.cpp", "double f(double x) { return std::atan2(x, 2); }\n"),
    "an algorithm of ranges in a portable room": ("core/tree/a.cpp", "void f(V& v) { std::ranges::sort(v); }\n"),
    "a bit_cast in a portable room": ("viz/figure/a.cpp", "auto f(double d) { return std::bit_cast<long>(d); }\n"),
    "Eigen in a header": ("core/tree/a.hpp", "#include <Eigen/Core>\n"),
    "a library crosses the border to Eigen": ("lod3d/solid/a.cpp", '#include "core/math/eigen.hpp"\n'),
    "a file in core": ("core/tree/a.cpp", "#include <fstream>\n"),
    "a signal in core": ("core/base/a.cpp", "#include <csignal>\n"),
    "a descriptor in a picture as data": ("viz/figure/a.cpp", "#include <unistd.h>\n"),
    "Cairo in a header": ("viz/paint/a.hpp", "#include <cairo/cairo.h>\n"),
    "JSON in a header": ("lod2d/shape/a.hpp", "#include <nlohmann/json.hpp>\n"),
    "a test that ctest would not find": ("tests/a.cpp", 'TEST_CASE("one; two") {}\n'),
    "a long file": ("core/tree/a.cpp", "int i;\n" * 401),
    "a long function": ("core/tree/a.cpp", "int f() {\n" + "    g();\n" * 49 + "}\n"),
    "a function of six parameters": ("viz/draw/a.cpp", "void f(int a, int b, int c, int d, int e, std::map<int, int> g = {}) {}\n"),
    "a constructor of six parameters": (
        "lod2d/shape/a.hpp",
        "class A {\n    A(int a, int b, int c,\n      int d, int e, int f)\n        : a_(a) {}\n};\n",
    ),
    "a long method": ("core/tree/a.cpp", "class A {\n  public:\n    int f(int a,\n   int b) const {\n" + "    g();\n" * 49 + "}\n};\n"),
    "a function of the plane again in space": (
        "lod3d/solid/a.cpp",
        "[[nodiscard]] double extent(const lod3d::Mesh& mesh) {\n    return 2;\n}\n",
    ),
    "a member of the plane again in space": ("lod3d/solid/a.cpp", EXCESS.replace("N", "3")),
    "a public header without a word about it": ("lod2d/shape/shape.hpp", '#pragma once\n#include "core/tree/body.hpp"\n'),
    "a public header includes one more that is internal": (
        "core/tree/more.hpp",
        "#pragma once\n",
        {"lod2d/shape/shape.hpp": BEGINNING + '#include "core/tree/body.hpp"\n#include "core/tree/more.hpp"\n'},
    ),
    "a list names a header that no public one includes": ("viz/figure/figure.hpp", "", {"viz/draw/tree.hpp": BEGINNING}),
    "a list names a header that is not there": (
        "core/tree/gone.hpp",
        None,
        {"cmake/headers/public.txt": "lod2d/shape/shape.hpp\nviz/draw/tree.hpp\ncore/tree/gone.hpp\n"},
    ),
    "an example takes an internal header": ("examples/a.cpp", "#include <lodlab/core/tree/body.hpp>\n"),
    "a circle": ("core/tree/body.hpp", '#include "core/tree/circle.hpp"\n'),
}


class Rules(unittest.TestCase):
    def breaches(self, planted):
        with tempfile.TemporaryDirectory() as folder:
            files = HOUSE | {"core/tree/circle.hpp": '#include "core/tree/body.hpp"\n'} | planted
            for name, text in files.items():
                path = pathlib.Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(text, encoding="utf-8")
            return breaches_in(folder)

    def test_a_house_in_order_has_no_breach(self):
        self.assertEqual(self.breaches({}), [])

    def test_each_planted_breach_is_found(self):
        for what, (name, text, *others) in BREACHES.items():
            with self.subTest(what):
                planted = others[0] if others else {}
                found = self.breaches(planted if text is None else planted | {name: text})
                self.assertTrue(found)
                self.assertTrue(any(breach.startswith(name) for breach in found), found)

    def test_a_full_folder_is_a_breach(self):
        full = {f"core/base/file_{i}.hpp": "" for i in range(20)}
        self.assertTrue(any(breach.startswith("core/base/:") for breach in self.breaches(full)))

    def test_an_empty_folder_is_a_breach(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertTrue(breaches_in(folder))


if __name__ == "__main__":
    unittest.main()
