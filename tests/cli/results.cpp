#include <algorithm>

#include "tests/catch.hpp"
#include "tests/cli/keys.hpp"

TEST_CASE("the results have exactly the documented keys") {
    check_keys("tree", result({"tree", "L", "--depth", "2", "--json"}));
    check_keys("collide", result({"collide", "offset_boxes", "--level", "2", "--json"}));
    check_keys("simulate", result({"simulate", "offset_boxes", "--json"}));
    check_keys("tree", result({"tree", "box", "--dim", "3", "--builder", "octree", "--json"}));
    check_keys("collide", result({"collide", "offset_balls", "--json"}));
    check_keys("simulate", result({"simulate", "offset_balls", "--json"}));
    check_keys("compare", result({"compare", "offset_boxes", "--json"}));
    check_keys("degrade",
               result({"degrade", "--shapes", "box", "--impacts", "3", "--depth", "2", "--json"}));
    check_keys("crowd", result({"crowd", "gas:5", "--seeds", "2", "--duration", "0.2", "--json"}));
    check_keys("crowd --bodies", result({"crowd", "gas", "--bodies", "5,9", "--budget", "3",
                                         "--duration", "0.2", "--json"}));
    check_keys("crowd --levels", result({"crowd", "gas:9", "--levels", "--budget", "3",
                                         "--duration", "0.2", "--json"}));
    check_keys("doctor", result({"doctor", "--json"}));
}

TEST_CASE("a tree's report tells the exact shape and a certified fit") {
    const Json json = result({"tree", "box:2,1", "--depth", "3", "--json"});
    CHECK(json["dim"] == 2);
    CHECK(json["shape"]["measure"] == Approx(2));
    CHECK(json["shape"]["inertia"] == Approx(2 * (4.0 + 1) / 12));
    REQUIRE(json["levels"].size() == 4);
    CHECK(json["levels"][0]["nodes"] == 1);
    for (const Json& level : json["levels"]) CHECK(level["certified"] == true);
}

TEST_CASE("the offset boxes give the impulse, energy and momentum of the exact case") {
    // Two offset unit boxes closing at 2 m/s: kinetic energy 2 J before and after.
    const Json json = result({"simulate", "offset_boxes", "--json"});
    CHECK(json["frames"] == 360);
    CHECK(json["energy"]["start"] == Approx(2));
    CHECK(json["energy"]["end"] == Approx(2));
    CHECK(json["momentum"]["end"][0] == Approx(2));
    CHECK(json["interrupted_frames"] == 0);
    CHECK(json["contacts"] > 0);
}

TEST_CASE("the same run gives the same bits, and another budget gives others") {
    const Json first = result({"simulate", "figure9", "--json"});
    const Json second = result({"simulate", "figure9", "--json"});
    const Json budgeted = result({"simulate", "figure9", "--budget", "20", "--json"});
    CHECK(first["state_hash"] == second["state_hash"]);
    CHECK(first["state_hash"] != budgeted["state_hash"]);
    CHECK(budgeted["interrupted_frames"] > 0);
    CHECK(budgeted["level_reached"]["max"] < first["level_reached"]["max"]);
}

TEST_CASE("a policy decides what a budget is spent on, and in a trace it is kept") {
    const Scratch scratch;
    const std::string trace = scratch / "trace.json";
    const std::vector<std::string> run{"simulate", "gas:60", "--duration", "0.5",
                                       "--budget", "1000",   "--json"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), run.begin(), run.end());
        return result(more)["state_hash"];
    };
    CHECK(with({"--policy", "first_come"}) != with({"--policy", "best_gain"}));
    const Json seen = with({"--policy", "perceptual", "--fixation", "0.3,-0.2", "--trace", trace});
    CHECK(seen != with({"--policy", "perceptual", "--fixation", "-2,1"}));
    CHECK(seen == result({"simulate", "gas:60", "--replay", trace, "--json"})["state_hash"]);
    for (const char* point : {"1", "1,", "1,2,3,4", "a,b", "nan,0", "1e7,0"}) {
        const Outcome refused = lodlab({"simulate", "gears_in_a_box", "--fixation", point});
        CHECK(refused.code == 2);
        CHECK(is_one_line(refused.err));
    }
}

TEST_CASE("the number of threads changes no bit, and a trace by two of them is replayed by one") {
    const Scratch scratch;
    const std::string trace = scratch / "trace.json";
    const std::vector<std::string> run{"simulate", "gas:600", "--duration", "0.2"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), run.begin(), run.end());
        more.emplace_back("--json");
        return result(more);
    };
    const Json one = with({});
    CHECK(one["threads"] == 1);
    const Json three = with({"--threads", "3", "--trace", trace});
    CHECK(three["threads"] == 3);
    for (const char* key : {"state_hash", "tests", "contacts"}) CHECK(three[key] == one[key]);
    const Json again = result({"simulate", "gas:600", "--replay", trace, "--json"});
    CHECK(again["state_hash"] == one["state_hash"]);
    // On a clock: whatever it cut.
    const Json timed = with({"--threads", "2", "--milliseconds", "0.1", "--trace", trace});
    for (const char* threads : {"1", "2"})
        CHECK(result({"simulate", "gas:600", "--replay", trace, "--threads", threads,
                      "--json"})["state_hash"] == timed["state_hash"]);
}

TEST_CASE("a trace written on the clock is replayed to the same bits") {
    const Scratch scratch;
    const std::string trace = scratch / "trace.json";
    const Json timed = result({"simulate", "gears_in_a_box", "--duration", "0.5", "--milliseconds",
                               "0", "--trace", trace, "--json"});
    const Json again = result({"simulate", "gears_in_a_box", "--replay", trace, "--json"});
    CHECK(timed["state_hash"] == again["state_hash"]);
    CHECK(timed["tests"] == again["tests"]);
    CHECK(timed["interrupted_frames"] == again["interrupted_frames"]);
    CHECK(timed["interrupted_frames"] > 0);
    const Outcome other = lodlab({"simulate", "offset_boxes", "--replay", trace});
    CHECK(other.code == 3);
    CHECK(is_one_line(other.err));
}

TEST_CASE("a near miss is a collision at a coarse level and none at the leaves") {
    const Json coarse = result({"collide", "near_miss", "--level", "1", "--json"});
    CHECK(coarse["pairs"][0]["verdict"] == "possible");
    CHECK_FALSE(coarse["pairs"][0]["contacts"].empty());
    const Json fine = result({"collide", "near_miss", "--json"});
    CHECK(fine["pairs"][0]["verdict"] == "apart");
    CHECK(fine["pairs"][0]["contacts"].empty());
    CHECK(result({"simulate", "near_miss", "--json"})["contacts"] == 0);
}

TEST_CASE("the reports for readers name what matters") {
    const auto text = [](const std::vector<std::string>& arguments) {
        const Outcome outcome = lodlab(arguments);
        CHECK(outcome.code == 0);
        return outcome.out;
    };
    CHECK(text({"tree", "L", "--depth", "1"}).find("yes, proved") != std::string::npos);
    CHECK(text({"tree", "--list"}).find("gear:") != std::string::npos);
    CHECK(text({"collide", "offset_boxes"}).find("a true collision") != std::string::npos);
    CHECK(text({"simulate", "offset_boxes"}).find("state hash") != std::string::npos);
    CHECK(text({"lesson"}).find("lodlab lesson 1") != std::string::npos);
    CHECK(text({"doctor"}).find("mp4 encoder") != std::string::npos);
}

TEST_CASE("a comparison tells each level from the exact impact, and Box2D from neither") {
    const Json json = result({"compare", "offset_boxes", "--json"});
    CHECK(json["scene"] == "offset_boxes");
    REQUIRE(json["impacts"].size() == 1);
    const Json& impact = json["impacts"][0];
    CHECK(impact["a"] == "A");
    // METHOD.md, case 6: impulse 50/31, spins 60/31.
    CHECK(impact["exact"]["b"]["velocity"][0].get<double>() == Approx(50.0 / 31).epsilon(1e-6));
    CHECK(impact["exact"]["a"]["spin"].get<double>() == Approx(60.0 / 31).epsilon(1e-6));
    CHECK(impact["box2d"]["error"]["impulse"].get<double>() < 1e-5);
    CHECK(impact["levels"].size() == 5);
    // A box is its own hull: its coarsest level knows where it touches.
    CHECK(impact["levels"][0]["error"]["impulse"].get<double>() < 1e-3);
    REQUIRE(json["runs"].size() == 6);
    CHECK(json["runs"][5]["level"] == "exact");
    for (const Json& run : json["runs"]) {
        const Json& parts = run["perceived"];
        double sum = 0;
        for (const auto& [part, cost] : parts.items())
            if (part != "total") sum += cost.get<double>();
        CHECK(parts["total"].get<double>() == Approx(sum));
    }
    CHECK(json["runs"][5]["perceived"]["total"].get<double>() < 1e-3);
}

TEST_CASE("what a level takes for a collision and never was has no error to tell") {
    const Json json = result({"compare", "near_miss", "--json"});
    REQUIRE(json["impacts"].size() == 1);
    CHECK(json["impacts"][0]["exact"]["time"].is_null());
    CHECK(json["impacts"][0]["box2d"]["a"].is_null());
    CHECK(json["impacts"][0]["levels"][0]["gap"].get<double>() > 0);
    CHECK(json["impacts"][0]["levels"][0]["error"].is_null());
    CHECK(json["runs"][0]["extra"] == 1);
}

TEST_CASE("a crowd runs by its name, and of many remarks of a kind a few are shown") {
    const std::vector<std::string> fast{"simulate", "gas:200", "--duration", "1"};
    const Outcome outcome = lodlab(fast);
    REQUIRE(outcome.code == 0);
    CHECK(outcome.out.starts_with("gas: 60 frames of 16.6667 ms\n"));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 6);
    CHECK(outcome.err.find(" more like the last\n") != std::string::npos);
}

TEST_CASE("threads change no bit of what crowd, compare and degrade find") {
    const auto both = [](const std::vector<std::string>& command) {
        std::vector<std::string> threaded = command;
        threaded.insert(threaded.end(), {"--threads", "2"});
        return std::pair{result(command), result(threaded)};
    };
    const auto crowd = both({"crowd", "gas:30", "--seeds", "1", "--duration", "0.2", "--json"});
    CHECK(crowd.first == crowd.second);
    const auto compare = both({"compare", "offset_boxes", "--json"});
    CHECK(compare.first == compare.second);
    auto degrade =
        both({"degrade", "--shapes", "box,L", "--impacts", "20", "--depth", "2", "--json"});
    for (Json* one : {&degrade.first, &degrade.second})
        for (Json& curve : (*one)["curves"])
            for (Json& level : curve["levels"]) level.erase("microseconds");
    CHECK(degrade.first == degrade.second);
}

TEST_CASE("over level_order is a ratio of errors, 1 for itself, and absent without it") {
    const std::vector<std::string> run{"crowd",      "implode:30", "--seeds", "2",
                                       "--duration", "0.5",        "--json",  "--policies"};
    const auto with = [&](const char* policies) {
        std::vector<std::string> all = run;
        all.emplace_back(policies);
        return result(all)["priorities"];
    };
    const Json both = with("first_come,level_order");
    REQUIRE(both.size() == 2);
    CHECK(both[0]["priority"] == "first_come");
    for (const Json& quota : both[1]["quotas"])
        for (const char* error : {"error", "attended_error"})
            CHECK(quota["over_level_order"][error]["median"] == 1);
    CHECK(both[0]["quotas"][4]["over_level_order"]["error"]["median"] > 1);
    CHECK_FALSE(with("first_come")[0]["quotas"][0].contains("over_level_order"));
}
