#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/cli/program.hpp"

namespace {

/// A scene whose only body has this line; the line is the third of the file.
std::string body(const std::string& line) {
    return "[[body]]\nshape = \"box\"\n" + line + "\n";
}

constexpr rlim_t small_file = 4096;
constexpr int no_privilege_to_give = 125;

/// From here on no file of this process grows beyond the limit: what a full disk does.
void fill_the_disk() {
    const rlimit limit{small_file, small_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    ::signal(SIGXFSZ, SIG_IGN);
}

/// Rights do not bind the administrator, so the program starts without that privilege.
void give_up_privilege() {
    if (::getuid() != 0) return;
    for (const unsigned long privilege : {1UL * CAP_DAC_OVERRIDE, 1UL * CAP_DAC_READ_SEARCH})
        if (::prctl(PR_CAPBSET_DROP, privilege, 0, 0, 0) != 0) ::_exit(no_privilege_to_give);
}

/// The same as check_failure, where this machine allows the test at all.
void check_without_privilege(const std::vector<std::string>& arguments, int code,
                             const std::string& part) {
    Start start;
    start.in_child = give_up_privilege;
    const Outcome outcome = lodlab(arguments, start);
    if (outcome.code == no_privilege_to_give)
        WARN("this machine does not let root give up privileges; not tested");
    else
        check_failure(outcome, code, part);
}

/// Ends the program, whatever it does, after so much of the processor's time.
void end_within_a_minute() {
    const rlimit limit{60, 60};
    ::setrlimit(RLIMIT_CPU, &limit);
}

}  // namespace

TEST_CASE("a scene file that is missing or unreadable is refused") {
    const Scratch scratch;
    check_failure(lodlab({"simulate", scratch / "absent.toml"}), 3, "absent.toml");
    check_failure(lodlab({"simulate", "ofset_boxes"}), 3, "did you mean offset_boxes?");
    check_failure(lodlab({"simulate", scratch.path().string()}), 3, "not a regular file");
    const std::string secret = scratch.write("secret.toml", body(""));
    std::filesystem::permissions(secret, std::filesystem::perms::none);
    check_without_privilege({"simulate", secret}, 3, "secret.toml");
}

TEST_CASE("a scene that says nonsense is refused with file, line and column") {
    const Scratch scratch;
    const auto refused = [&](const std::string& text, const std::string& part) {
        const std::string file = scratch.write("bad.toml", text);
        check_failure(lodlab({"simulate", file, "--json", "--out", scratch / "never.png"}), 3,
                      "bad.toml:" + part);
    };
    refused("[[body\n", "1:");
    refused(body("mass = nan"), "3:1: mass");
    refused(body("position = [inf, 0]"), "3:1: position");
    refused(body("velocity = [1e300, 0]"), "3:1: velocity");
    refused(body("restitution = 1.01"), "3:1: restitution");
    refused(body("mass = 0"), "3:1: mass");
    refused(body("mass = -1"), "3:1: mass");
    refused(body("depth = 99"), "3:1: depth");
    refused(body("branching = 0"), "3:1: branching");
    refused("[[body]]\nshape = \"geer:9\"\n", "1:1: body body 1");
    refused("[[body]]\nshape = \"gear:2\"\n", "1:1: body body 1");
    refused("[[body]]\nshape = \"broken.svg\"\n", "1:1: there is no shape file");
    scratch.write("broken.svg", "<svg><path d='M 0 0");
    refused("[[body]]\nshape = \"broken.svg\"\n", "1:1: body body 1");
    CHECK(scratch.files() == std::vector<std::string>{"bad.toml", "broken.svg"});
}

TEST_CASE("a shape that is no shape is refused") {
    const Scratch scratch;
    check_failure(lodlab({"tree", scratch / "absent.svg"}), 3, "absent.svg");
    check_failure(lodlab({"tree", scratch.write("broken.svg", "<svg><path d='M 0 0")}), 3,
                  "broken.svg");
    check_failure(lodlab({"tree", scratch.write("empty.svg", "<svg/>")}), 3, "empty.svg");
    check_failure(lodlab({"tree", "text:\xef\xbf\xbf"}), 3, "text");
    check_failure(lodlab({"tree", "geer:9"}), 2, "geer");
    for (const std::string other : {"part.dae", "part.3mf", "part.step", "part.dxf"})
        check_failure(lodlab({"tree", scratch.write(other, "x")}), 2, "stl");
    check_failure(lodlab({"tree", "--strokes", "--dim", "3", "box"}), 2, "drawings");
}

TEST_CASE("what a drawing loses is said, and refused where it is taken strictly") {
    const Scratch scratch;
    const std::string file = scratch.write(
        "part.svg",
        "<svg viewBox='0 0 9 9'><rect width='8' height='4'/>"
        "<path d='M0 8H8' fill='none' stroke='red'/><rect x='4' width='9' height='4'/></svg>");
    const Outcome said = lodlab({"tree", file, "--depth", "0", "--no-cache"});
    CHECK(said.code == 0);
    CHECK(said.err.find("part: left out 1 unfilled stroke") != std::string::npos);
    CHECK(said.err.find("part: 1 shape lies in part outside its page") != std::string::npos);
    check_failure(lodlab({"tree", file, "--strict"}), 3, "1 unfilled stroke");
    const auto area_of = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"tree", file, "--depth", "0", "--no-cache", "--json"});
        return nlohmann::json::parse(lodlab(more).out)["shape"]["measure"].get<double>();
    };
    CHECK(area_of({}) == Approx(13 * 4 / 169.0));
    CHECK(area_of({"--page"}) == Approx(9 * 4 / 81.0));
    CHECK(area_of({"--strokes"}) == Approx((13 * 4 + 8) / 169.0));
}

TEST_CASE("more frames than the limit are refused, and the limit can be raised") {
    const std::vector<std::string> long_run{"simulate", "offset_boxes", "--duration", "500"};
    check_failure(lodlab(long_run), 5, "--raise-limits");
    auto raised = long_run;
    raised.insert(raised.end(), {"--raise-limits", "2", "--level", "0"});
    CHECK(lodlab(raised).code == 0);
}

TEST_CASE("a folder that cannot be written is reported before any work") {
    const Scratch scratch;
    check_failure(lodlab({"simulate", "offset_boxes", "--out", scratch / "no/where.png"}), 4,
                  "where.png");
    check_failure(lodlab({"simulate", "offset_boxes", "--trace", scratch / "no/where.json"}), 4,
                  "where.json");
    check_failure(lodlab({"tree", "L", "--out", scratch / "no/where.png"}), 4, "where.png");
    std::filesystem::permissions(
        scratch.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    check_without_privilege({"figure", "4", "--out", scratch / "f.png"}, 4, "f.png");
    std::filesystem::permissions(scratch.path(), std::filesystem::perms::owner_all);
    CHECK(scratch.files().empty());
}

TEST_CASE("a full disk ends in one line and leaves no file") {
    const Scratch scratch;
    Start start;
    start.in_child = fill_the_disk;
    for (const char* name : {"a.png", "a.svg", "a.pdf", "a.mp4", "a.gif", "a.json"}) {
        const Outcome outcome = lodlab({"simulate", "offset_boxes", "--duration", "0.6",
                                        "--quality", "draft", "--out", scratch / name},
                                       start);
        check_failure(outcome, 4, name);
    }
    check_failure(lodlab({"simulate", "offset_boxes", "--trace", scratch / "t.json"}, start), 4,
                  "t.json");
    check_failure(lodlab({"tree", "gear:9", "--out", scratch / "t.json"}, start), 4, "t.json");
    CHECK(scratch.files().empty());
}

TEST_CASE("standard output that cannot be written is an output that failed") {
    Start start;
    start.in_child = [] {
        if (::freopen("/dev/full", "w", stdout) == nullptr) ::_exit(124);
    };
    const Outcome outcome = lodlab({"simulate", "offset_boxes", "--json"}, start);
    CHECK(outcome.code == 4);
    CHECK(is_one_line(outcome.err));
}

TEST_CASE("bodies that start inside each other are run, and reported in one line") {
    const Scratch scratch;
    const std::string file = scratch.write("in.toml", body("") + body("position = [0.5, 0]"));
    const Outcome outcome = lodlab({"simulate", file, "--duration", "0.1", "--json"});
    CHECK(outcome.code == 0);
    CHECK(is_one_line(outcome.err));
    CHECK(contains(outcome.err, "body 1 and body 2 touch or overlap at the start"));
}

TEST_CASE("a drawing whose lines lie beyond Cairo's numbers is refused and hangs nobody") {
    Start start;
    start.in_child = end_within_a_minute;
    for (const std::string file : {"/far-curves.svg", "/far-curves-2.svg"})
        check_failure(lodlab({"tree", LODLAB_HOSTILE_DRAWINGS + file}, start), 3,
                      "millions of pages outside its page");
}
