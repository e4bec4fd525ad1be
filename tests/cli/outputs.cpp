// What a user has is not lost, whatever names and signals a run meets.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "tests/catch.hpp"
#include "tests/cli/program.hpp"
#include "tests/text.hpp"

namespace {

namespace fs = std::filesystem;

const char* const drawing = "<svg><rect width='4' height='2'/></svg>";
const char* const scene =
    "[[body]]\nshape = \"p.svg\"\nvelocity = [1, 0]\nposition = [-2, 0]\n"
    "[[body]]\nshape = \"disc\"\n";

/// Refused as wrong usage, in one line with these words, and the file keeps its text.
void check_kept(const Outcome& outcome, const std::string& words, const std::string& path,
                const std::string& text) {
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(is_one_line(outcome.err));
    CHECK(contains(outcome.err, words));
    CHECK(lodtest::bytes_of(path) == text);
}

Start in(const Scratch& scratch) {
    Start start;
    start.folder = scratch.path();
    return start;
}

}  // namespace

TEST_CASE("no output takes the place of an input, whatever path or link leads to it") {
    const Scratch scratch;
    const std::string file = scratch.write("p.svg", drawing);
    fs::create_directory(scratch.path() / "sub");
    fs::create_symlink("p.svg", scratch.path() / "link.svg");
    fs::create_hard_link(file, scratch.path() / "hard.svg");
    for (const char* out : {"p.svg", "./p.svg", "sub/../p.svg", "link.svg", "hard.svg"}) {
        CAPTURE(out);
        check_kept(lodlab({"tree", "p.svg", "--depth", "1", "--out", out}, in(scratch)),
                   "it is the input p.svg", file, drawing);
    }
    check_kept(lodlab({"tree", "link.svg", "--depth", "1", "--out", "p.svg"}, in(scratch)),
               "it is the input link.svg", file, drawing);
    CHECK(fs::is_symlink(scratch.path() / "link.svg"));
}

TEST_CASE("neither a scene nor a drawing that it names is replaced") {
    const Scratch scratch;
    const std::string file = scratch.write("p.svg", drawing);
    const std::string toml = scratch.write("s.toml", scene);
    check_kept(lodlab({"simulate", "s.toml", "--trace", "s.toml"}, in(scratch)),
               "it is the input s.toml", toml, scene);
    for (const char* command : {"simulate", "collide", "compare"}) {
        CAPTURE(command);
        check_kept(lodlab({command, "s.toml", "--out", "p.svg"}, in(scratch)), "p.svg", file,
                   drawing);
    }
}

TEST_CASE("neither a trace that is played again nor a share that is merged is replaced") {
    const Scratch scratch;
    REQUIRE(
        lodlab({"simulate", "offset_boxes", "--duration", "0.1", "--trace", "t.json"}, in(scratch))
            .code == 0);
    const std::string trace = lodtest::bytes_of(scratch / "t.json");
    for (const char* option : {"--out", "--trace"})
        check_kept(lodlab({"simulate", "offset_boxes", "--replay", "t.json", option, "t.json"},
                          in(scratch)),
                   "it is the input t.json", scratch / "t.json", trace);
    for (const char* share : {"1/2", "2/2"})
        REQUIRE(lodlab({"degrade", "--shapes", "box", "--depth", "1", "--impacts", "2", "--share",
                        share, "--out", share[0] == '1' ? "d1.json" : "d2.json"},
                       in(scratch))
                    .code == 0);
    const std::string first = lodtest::bytes_of(scratch / "d1.json");
    check_kept(lodlab({"degrade", "--merge", "d1.json", "--merge", "d2.json", "--out", "d1.json"},
                      in(scratch)),
               "it is the input d1.json", scratch / "d1.json", first);
}

TEST_CASE("a file that a mesh or a drawing names is not replaced, however it is spelt") {
    const std::string rect = "<rect width='4' height='2'/>";
    const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n";
    const std::string faces = corner + "f 2 3 4\n";
    struct Naming {
        std::string input;
        std::string text;
        std::string output;
    };
    const std::vector<Naming> cases{
        {"p.svg", "<svg><image href='wood.png'/>" + rect + "</svg>", "wood.png"},
        {"p.svg", "<svg><image href='a%20wood.png'/>" + rect + "</svg>", "a wood.png"},
        {"p.svg", "<svg><image href='b&amp;w&#x2e;png'/>" + rect + "</svg>", "b&w.png"},
        {"p.svg", "<svg><style>a{fill:url( sub/../wood.png)}</style>" + rect + "</svg>",
         "wood.png"},
        {"p.svg", "<svg><image href='link.png'/>" + rect + "</svg>", "wood.png"},
        {"m.gltf", R"({"buffers":[{"uri":"\u0077ood.png"}]})", "wood.png"},
        {"m.gltf", R"({"images":[{"uri":"sub\/..\/a%20wood.png"}]})", "a wood.png"},
        {"m.gltf", R"({"images":[{"uri":"hard.png"}]})", "wood.png"},
        {"m.obj", "mtllib m.mtl\n" + faces, "m.mtl"},
        {"m.obj", "mtllib my own.mtl\n" + faces, "my own.mtl"},
        {"m.obj", "MTLLIB a.mtl link.mtl\n" + faces, "m.mtl"},
        {"m.obj", "mtllib m.mtl\n" + faces, "sub/oak.png"},
        {"m.obj", "mtllib m.mtl\n" + faces, "a wood.png"},
        {"m.ply", "ply\ncomment TextureFile link.png\nend_header\n", "wood.png"},
    };
    for (const Naming& one : cases) {
        CAPTURE(one.text, one.output);
        const Scratch scratch;
        fs::create_directory(scratch.path() / "sub");
        fs::create_symlink("wood.png", scratch.path() / "link.png");
        fs::create_symlink("m.mtl", scratch.path() / "link.mtl");
        for (const char* name : {"wood.png", "a wood.png", "b&w.png", "sub/oak.png", "my own.mtl"})
            scratch.write(name, "mine");
        scratch.write("m.mtl", "newmtl a\n  map_Kd -s 1 1 1 sub\\oak.png\nbump a wood.png\n");
        fs::create_hard_link(scratch.path() / "wood.png", scratch.path() / "hard.png");
        scratch.write(one.input, one.text);
        const std::string before = lodtest::bytes_of(scratch / one.output);
        // A trace may have any name; a picture cannot be called m.mtl.
        const std::string toml = scratch.write(
            "s.toml", "dim = " + std::string(one.input == "p.svg" ? "2" : "3") +
                          "\n[[body]]\nshape = \"" + one.input + "\"\n[[body]]\nshape = \"box\"\n");
        check_kept(lodlab({"simulate", "s.toml", "--trace", one.output}, in(scratch)), "names it",
                   scratch / one.output, before);
    }
}

TEST_CASE("a figure that nobody named replaces no file") {
    const Scratch scratch;
    const std::string file = scratch.write("figure-4.png", "mine");
    check_kept(lodlab({"figure", "4"}, in(scratch)), "--out figure-4.png to replace it", file,
               "mine");
    CHECK(lodlab({"figure", "4", "--out", "figure-4.png"}, in(scratch)).code == 0);
    CHECK(lodtest::bytes_of(file) != "mine");
}

TEST_CASE("two outputs in one file are refused before either is written") {
    const Scratch scratch;
    fs::create_symlink(".", scratch.path() / "here");
    for (const char* second : {"a.svg", "./a.svg", "here/a.svg"}) {
        const Outcome outcome =
            lodlab({"tree", "box", "--depth", "1", "--out", "a.svg", "--out", second}, in(scratch));
        CHECK(outcome.code == 2);
        CHECK(contains(outcome.err, "a.svg is written to that file too"));
        CHECK(scratch.files() == std::vector<std::string>{"here"});
    }
    const Outcome outcome = lodlab(
        {"simulate", "offset_boxes", "--duration", "0.1", "--trace", "a.json", "--out", "a.json"},
        in(scratch));
    CHECK(outcome.code == 2);
}

TEST_CASE("a read-only file stays, also for root, and any other keeps its permissions") {
    const Scratch scratch;
    const std::string file = scratch.write("k.svg", "keep");
    ::chmod(file.c_str(), 0444);
    const Outcome refused = lodlab({"tree", "box", "--depth", "1", "--out", file});
    CHECK(refused.code == 4);
    CHECK(contains(refused.err, "it is read-only"));
    CHECK(lodtest::bytes_of(file) == "keep");
    ::chmod(file.c_str(), 0640);
    CHECK(lodlab({"tree", "box", "--depth", "1", "--out", file}).code == 0);
    CHECK(contains(lodtest::bytes_of(file), "<svg"));
    struct stat status {};
    REQUIRE(::stat(file.c_str(), &status) == 0);
    CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("a link is followed: what it leads to is written, and the link stays") {
    const Scratch scratch;
    fs::create_directory(scratch.path() / "far");
    fs::create_symlink("far/real.svg", scratch.path() / "link.svg");  // there is no such file yet
    for (int time = 0; time < 2; ++time) {
        CHECK(lodlab({"tree", "box", "--depth", "1", "--out", "link.svg"}, in(scratch)).code == 0);
        CHECK(fs::is_symlink(scratch.path() / "link.svg"));
        CHECK(contains(lodtest::bytes_of(scratch / "far/real.svg"), "<svg"));
    }
}

TEST_CASE("names are as long as the system has them, and no output is a link to itself") {
    const Scratch scratch;
    for (const int letters : {245, 251, 255}) {
        const std::string name = std::string(static_cast<std::size_t>(letters - 4), 'x') + ".svg";
        CHECK(lodlab({"tree", "box", "--depth", "1", "--out", scratch / name}).code == 0);
        CHECK(fs::exists(scratch / name));
    }
    std::string too_long = ".svg";
    too_long.insert(0, 256, 'x');
    fs::create_symlink("loop.svg", scratch.path() / "loop.svg");
    const std::vector<std::string> wrong{"loop.svg", too_long};
    for (const std::string& name : wrong) {
        for (const char* option : {"--out", "--trace"}) {
            const Outcome outcome =
                lodlab({"simulate", "offset_boxes", "--duration", "0.1", option, scratch / name});
            INFO(outcome.err);
            CHECK(outcome.code == 4);
            CHECK(is_one_line(outcome.err));
        }
    }
}

TEST_CASE("the program and where it prints are no places for a picture or a trace") {
    const Scratch scratch;
    fs::create_symlink(fs::canonical(LODLAB_PROGRAM), scratch.path() / "program.json");
    const Outcome outcome = lodlab(
        {"simulate", "offset_boxes", "--duration", "0.1", "--trace", scratch / "program.json"});
    CHECK(outcome.code == 2);
    CHECK(contains(outcome.err, "it came with lodlab"));
    for (const bool error : {false, true}) {
        const std::string log = scratch.write("log.json", "");
        Start start;
        start.in_child = [&] {
            if (std::freopen(log.c_str(), "w", error ? stderr : stdout) == nullptr) ::_exit(124);
        };
        const Outcome mixed =
            lodlab({"simulate", "offset_boxes", "--duration", "0.1", "--trace", log}, start);
        CHECK(mixed.code == 2);
        CHECK(contains(error ? lodtest::bytes_of(log) : mixed.err, "the program prints there"));
    }
}

TEST_CASE("names that are no text are no internal error") {
    const Scratch scratch;
    const std::string odd = scratch.write("n\xff.toml",
                                          "[[body]]\nshape = \"box\"\n[[body]]\nshape = "
                                          "\"box\"\nposition = [3, 0]\n");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"simulate", odd, "--duration", "0.1", "--trace",
                                   scratch / "o.json", "--json"},
          {"compare", odd, "--duration", "0.1", "--json", "--out", scratch / "c.json"},
          {"collide", odd, "--json"}}) {
        const Outcome outcome = lodlab(arguments);
        INFO(outcome.err);
        CHECK(outcome.code == 0);
    }
}

TEST_CASE("a device or a pipe is no place for a file that is complete or absent") {
    const Scratch scratch;
    REQUIRE(::mkfifo((scratch / "pipe.svg").c_str(), 0600) == 0);
    const Outcome outcome = lodlab({"tree", "box", "--depth", "1", "--out", scratch / "pipe.svg"});
    CHECK(outcome.code == 4);
    CHECK(contains(outcome.err, "it is no regular file"));
    CHECK(fs::is_fifo(scratch / "pipe.svg"));
}

TEST_CASE("what a process that died left half-written is swept by the next one") {
    const Scratch scratch;
    const pid_t dead = ::fork();
    if (dead == 0) ::_exit(0);
    ::waitpid(dead, nullptr, 0);
    const std::string old =
        scratch.write("film.mp4.lodlab-part" + std::to_string(dead) + "-0", "half");
    const std::string ours =
        scratch.write("a.svg.lodlab-part" + std::to_string(::getpid()) + "-0", "x");
    const std::string other =
        scratch.write("letter.part" + std::to_string(dead) + "-0", "not a part of lodlab's");
    CHECK(lodlab({"tree", "box", "--depth", "1", "--out", scratch / "a.svg"}).code == 0);
    CHECK_FALSE(fs::exists(old));
    CHECK(fs::exists(ours));
    CHECK(fs::exists(other));
}

TEST_CASE("every signal that ends a program lets it tidy up") {
    const int signal = GENERATE(SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGALRM, SIGTERM, SIGXCPU,
                                SIGVTALRM, SIGPROF, SIGUSR1, SIGUSR2);
    CAPTURE(signal);
    const Scratch scratch;
    Start start;
    start.signal = signal;
    start.when_exists = scratch.path() / "film.mp4.lodlab-part";
    const Outcome outcome = lodlab(
        {"simulate", "gears_in_a_box", "--quality", "4k", "--out", scratch / "film.mp4"}, start);
    CHECK(outcome.code == 128 + signal);
    if (signal != SIGPIPE) CHECK(is_one_line(outcome.err));
    CHECK(scratch.files().empty());
}

TEST_CASE("a signal that is ignored, as under nohup or behind &, stops nothing") {
    const int signal = GENERATE(SIGHUP, SIGINT, SIGQUIT, SIGTERM);
    const Scratch scratch;
    Start start;
    start.in_child = [signal] { std::signal(signal, SIG_IGN); };
    start.signal = signal;
    start.when_exists = scratch.path() / "film.mp4.lodlab-part";
    const Outcome outcome = lodlab({"simulate", "offset_boxes", "--duration", "0.3", "--quality",
                                    "draft", "--out", scratch / "film.mp4"},
                                   start);
    CHECK(outcome.code == 0);
    CHECK(fs::exists(scratch.path() / "film.mp4"));
}

TEST_CASE("what is misspelt is found before the first tree is built") {
    // The first shape alone takes seconds; nothing may be built, so nothing may be kept.
    const Scratch scratch;
    Start start = in(scratch);
    start.environment = {"PATH=/usr/bin:/bin", "HOME=/nonexistent",
                         "XDG_CACHE_HOME=" + scratch.path().string()};
    const std::vector<std::vector<std::string>> wrong{
        {"degrade", "--dim", "3", "--shapes", "box,L,torus", "--depth", "1"},
        {"degrade", "--shapes", "box,L", "--builder", "octtree", "--depth", "1"},
        {"degrade", "--shapes", "box,L", "--share", "3/2", "--depth", "1"},
        {"degrade", "--shapes", "box,L", "--impacts", "2", "--share", "3/4", "--depth", "1"},
        {"simulate",
         scratch.write("s.toml", "[[body]]\nshape = \"box\"\n[[body]]\nshape = \"bx\"\n")},
    };
    for (const std::vector<std::string>& arguments : wrong) {
        const Outcome outcome = lodlab(arguments, start);
        INFO(outcome.err);
        CHECK((outcome.code == 2 || outcome.code == 3 || outcome.code == 5));
        CHECK(is_one_line(outcome.err));
        CHECK_FALSE(fs::exists(scratch.path() / "lodlab"));
    }
}
