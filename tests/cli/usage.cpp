#include "tests/catch.hpp"
#include "tests/cli/program.hpp"

namespace {

void check_misuse(const std::vector<std::string>& arguments, const std::string& part) {
    const Outcome outcome = lodlab(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(outcome.out.empty());
    CHECK(is_one_line(outcome.err));
    CHECK(contains(outcome.err, part));
}

}  // namespace

TEST_CASE("the help lists every command with an example of its own") {
    const Outcome help = lodlab({"--help"});
    CHECK(help.code == 0);
    CHECK(help.err.empty());
    for (const std::string command : {"tree", "collide", "simulate", "figure", "lesson", "book",
                                      "page", "doctor", "completion"}) {
        CHECK(contains(help.out, "\n  " + command + " "));
        const Outcome one = lodlab({command, "--help"});
        CHECK(one.code == 0);
        CHECK(contains(one.out, "Example: lodlab " + command));
    }
}

TEST_CASE("the version is printed, with the commit and the libraries") {
    const Outcome version = lodlab({"--version"});
    CHECK(version.code == 0);
    CHECK(version.out.starts_with("lodlab 0."));
    CHECK(contains(version.out, "commit"));
    CHECK(contains(version.out, "Cairo"));
    CHECK(contains(version.out, "libavcodec"));
}

TEST_CASE("a command line that is not understood ends in one line and code 2") {
    check_misuse({}, "no command given");
    check_misuse({"simulat", "offset_boxes"}, "did you mean simulate?");
    check_misuse({"simulate"}, "SCENE is required");
    check_misuse({"tree", "star:5", "star:6", "star:7"},
                 "star:6 and 1 more words are too many here");
    check_misuse({"simulate", "offset_boxes", "--levl", "3"}, "did you mean --level?");
    check_misuse({"simulate", "offset_boxes", "--level", "three"}, "--level");
    check_misuse({"simulate", "offset_boxes", "--level", "-1"}, "--level");
    check_misuse({"simulate", "offset_boxes", "--milliseconds", "nan"}, "--milliseconds");
    for (const char* number : {"0", "-1", "nan", "1.5", "257", "many"})
        check_misuse({"simulate", "offset_boxes", "--threads", number}, "--threads");
    check_misuse(
        {"simulate", "offset_boxes", "--replay", "t.json", "--seek", "3", "--threads", "2"},
        "drop --threads");
    check_misuse({"simulate", "offset_boxes", "--duration", "inf"}, "--duration");
    check_misuse({"simulate", "offset_boxes", "--response", "nett"}, "did you mean net?");
    check_misuse({"simulate", "offset_boxes", "--theme", "drak"}, "did you mean dark?");
    check_misuse({"simulate", "offset_boxes", "--level", "1", "--budget", "9"},
                 "exclude each other");
    check_misuse({"simulate", "offset_boxes", "--replay", "t.json", "--level", "1"},
                 "from the trace");
    check_misuse({"tree"}, "no shape given");
    check_misuse({"tree", "gear:9", "--depth", "99"}, "--depth");
    check_misuse({"tree", "gear:9", "--branching", "1"}, "--branching");
    check_misuse({"tree", "gear:9", "--size", "0"}, "--size");
}

TEST_CASE("numbers are decimal, and what is none is refused") {
    for (const char* number : {"0x1", "010", "1_000", "1e999", "nan", ""}) {
        CAPTURE(number);
        check_misuse({"tree", "gear:9", "--depth", number}, "--depth");
        check_misuse({"simulate", "offset_boxes", "--budget", number}, "--budget");
        check_misuse({"simulate", "offset_boxes", "--milliseconds", number}, "--milliseconds");
        check_misuse({"simulate", "offset_boxes", "--duration", number}, "--duration");
        check_misuse({"degrade", "--seed", number}, "--seed");
    }
    for (const char* number : {"-1", "3600001"})
        check_misuse({"simulate", "offset_boxes", "--milliseconds", number}, "--milliseconds");
    for (const char* number : {"-1", "1.5", "18446744073709551616"})
        check_misuse({"degrade", "--seed", number}, "--seed");
    check_misuse({"figure", "0x9"}, "N");
    check_misuse({"lesson", "03"}, "no lesson 03");
    CHECK(lodlab({"tree", "box", "--depth", "+1", "--size", ".5e0"}).code == 0);
}

TEST_CASE("a flag takes no value") {
    for (const char* flag : {"--json=3", "--json=true", "--json=false", "--json="})
        check_misuse({"doctor", flag}, "--json takes no value; write it alone");
}

TEST_CASE("an option that means nothing beside others, or without another, is refused") {
    check_misuse({"tree", "--list", "--out", "a.png"},
                 "--list only prints what there is; drop --out");
    check_misuse({"tree", "box", "--list"}, "drop SHAPE");
    check_misuse({"degrade", "--merge", "a.json", "--impacts", "3"},
                 "--merge takes the rest from the shares; drop --impacts");
    check_misuse({"degrade", "--merge", "a.json", "--share", "1/1"}, "drop --share");
    check_misuse({"simulate", "offset_boxes", "--strip", "--plot", "--out", "a.png"},
                 "--strip and --plot");
    for (const char* flag : {"--strip", "--plot"}) {
        check_misuse({"simulate", "offset_boxes", flag}, "add --out FILE.png");
        check_misuse({"simulate", "offset_boxes", flag, "--out", "a.mp4"}, "add --out FILE.png");
    }
    check_misuse({"collide", "near_miss_in_space", "--projected"}, "add --out FILE.png");
    check_misuse({"collide", "offset_boxes", "--projected", "--out", "a.png"}, "drop --projected");
    check_misuse({"tree", "knot", "--level", "1", "--out", "a.png"}, "add --out FILE.urdf");
    check_misuse({"tree", "knot", "--builder", "octree", "--effort", "1"},
                 "has an effort; drop it");
    check_misuse({"lesson", "--out", "pictures"}, "lodlab lesson 3");
    for (const char* option : {"--page", "--strict", "--strokes"})
        for (const char* shape : {"gear:9", "text:R", "knot"})
            check_misuse({"tree", shape, option}, std::string(shape) + " is none: drop the option");
}

TEST_CASE("an ending that no format has is refused before any work") {
    check_misuse({"simulate", "offset_boxes", "--out", "a.doc"}, "a.doc");
    check_misuse({"tree", "gear:9", "--out", "a.mp4"}, "a.mp4");
    check_misuse({"figure", "1", "--out", "noending"}, "noending");
}

TEST_CASE("a figure that does not exist names those that do") {
    check_misuse({"figure", "6", "--out", "a.png"}, "1, 2, 3, 4, 5 and 9");
    check_misuse({"figure", "77", "--out", "a.png"}, "1, 2, 3, 4, 5 and 9");
}

TEST_CASE("the completion names every command and its options") {
    const Outcome script = lodlab({"completion"});
    CHECK(script.code == 0);
    for (const char* part : {"simulate)", "--milliseconds", "doctor)", "complete -o filenames"})
        CHECK(contains(script.out, part));
}

TEST_CASE("a picture of a quota without one is refused, and so is a question that lacks its own") {
    check_misuse({"simulate", "gas:9", "--quota", "--out", "a.mp4"},
                 "there is none; add --budget TESTS or --milliseconds TIME");
    check_misuse({"simulate", "gas:9", "--quota", "--budget", "9"}, "add --out FILE.mp4");
    check_misuse({"simulate", "gas:9", "--quota", "--plot", "--budget", "9", "--out", "a.png"},
                 "are two pictures");
    check_misuse({"crowd", "gas", "--bodies", "5,9"}, "add --milliseconds 1");
    check_misuse({"crowd", "gas:9", "--levels"}, "add --milliseconds 1");
    check_misuse({"crowd", "gas:9", "--budget", "9"}, "add --levels, or drop it");
    check_misuse({"crowd", "gas:9", "--levels", "--bodies", "5", "--budget", "9"}, "drop --");
    check_misuse({"crowd", "gas", "--bodies", "5", "--budget", "9", "--threads", "2"},
                 "drop --threads");
    for (const char* numbers : {"0", "5,", "9,5", "5,5", "x", "1e3", "5;9", "-1", ""})
        check_misuse({"crowd", "gas", "--bodies", numbers, "--budget", "9"}, "--bodies");
    check_misuse({"crowd", "gas:9", "--bodies", "5", "--budget", "9"},
                 "the scene must be the name of a crowd");
    check_misuse({"crowd", "offset_boxes", "--bodies", "5", "--budget", "9"}, "not offset_boxes");
    check_misuse({"crowd", "gas:9", "--levels", "--budget", "9", "--milliseconds", "1"},
                 "exclude each other");
    check_misuse({"crowd", "gas", "--bodies", "5", "--budget", "9", "--milliseconds", "1"},
                 "exclude each other");
    check_misuse({"crowd", "gas:9", "--policies", "best_gian"}, "did you mean best_gain?");
    check_misuse({"crowd", "gas:9", "--policies", "trade,trade"}, "names trade twice");
    check_misuse({"crowd", "gas", "--bodies", "5", "--budget", "9", "--duration", "0.01"},
                 "is one frame");
}
