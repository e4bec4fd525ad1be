#include "lodlab/viz/figure/figure.hpp"

#include "tests/catch.hpp"

using namespace viz;

TEST_CASE("holding a figure for two seconds at 30 frames a second takes 60 frames", "[figure]") {
    Animation animation;
    animation.frames_per_second = 30;
    hold(animation, Figure{}, 2);
    CHECK(frame_count(animation) == 60);
}

TEST_CASE("a figure held for no time still has one frame", "[figure]") {
    Animation animation;
    hold(animation, Figure{}, 0);
    CHECK(frame_count(animation) == 1);
}

TEST_CASE("plain text has neither marks of italics nor of subscripts", "[figure]") {
    CHECK(plain_text("*v_c* and R_{AB}, 2 \\* 3") == "vc and RAB, 2 * 3");
}

TEST_CASE("a name from outside is shown letter by letter", "[figure]") {
    const std::string name = "my_file*{1}\\.svg";
    CHECK(plain_text(literal_text(name)) == name);
}
