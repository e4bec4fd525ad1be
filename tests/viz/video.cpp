#include <cstdint>
#include <fstream>
#include <sstream>

#include "lodlab/core/base/error.hpp"
#include "lodlab/core/base/stop.hpp"
#include "lodlab/viz/film/write.hpp"
#include "tests/catch.hpp"
#include "tests/text.hpp"
#include "tests/viz/scratch.hpp"

using namespace viz;
using lodtest::bytes_of;
using sample::Scratch;
using sample::SmallDisk;

namespace {

const std::vector<std::string> film_endings{"mp4", "webm", "gif"};

Figure frame(int number) {
    Figure figure;
    figure.title = "A disc crosses";
    figure.panels.emplace_back();
    figure.panels[0].view = {{0, 0}, {4, 2}};
    figure.panels[0].marks = {Disc{{.role = Role::meeting_node}, {0.5 + 0.1 * number, 1}, 0.4}};
    return figure;
}

/// 20 moving frames, the last held for 10 more: 1 second.
Animation crossing() {
    Animation animation;
    animation.frames_per_second = 30;
    for (int i = 0; i < 20; ++i) animation.shots.push_back({[i] { return frame(i); }, 1});
    hold(animation, frame(20), 1.0 / 3);
    return animation;
}

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return value;
}

/// The frames of a GIF, from its own blocks: how many, and how long they stand together [1/100 s].
struct GifFrames {
    int count = 0;
    int hundredths = 0;
};
GifFrames frames_of_gif(const std::string& bytes) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes.at(i)); };
    const auto table = [](int flags) {
        return flags & 0x80 ? std::size_t{3} << ((flags & 7) + 1) : std::size_t{0};
    };
    const auto skip_blocks = [&](std::size_t at) {
        while (byte(at) != 0) at += 1u + byte(at);
        return at + 1;
    };
    GifFrames frames;
    std::size_t at = 13 + table(byte(10));
    while (byte(at) != 0x3B) {
        if (byte(at) == 0x21) {  // an extension; a graphic control holds the delay
            if (byte(at + 1) == 0xF9) frames.hundredths += byte(at + 4) + 256 * byte(at + 5);
            at = skip_blocks(at + 2);
        } else {  // an image
            REQUIRE(byte(at) == 0x2C);
            ++frames.count;
            at = skip_blocks(at + 10 + table(byte(at + 9)) + 1);
        }
    }
    return frames;
}

/// The frames of a WebM: its SimpleBlocks and BlockGroups, found by walking the elements.
int frames_of_webm(const std::string& bytes, std::size_t at, std::size_t end) {
    int frames = 0;
    const auto number = [&](bool keep_marker) {
        const auto first = static_cast<std::uint8_t>(bytes.at(at));
        int length = 1;
        while (length < 8 && !(first & (0x80 >> (length - 1)))) ++length;
        std::uint64_t value = keep_marker ? first : first & (0xFFu >> length);
        for (int i = 1; i < length; ++i)
            value =
                value << 8 | static_cast<std::uint8_t>(bytes.at(at + static_cast<std::size_t>(i)));
        at += static_cast<std::size_t>(length);
        return value;
    };
    while (at < end) {
        const std::uint64_t id = number(true);
        const std::uint64_t size = number(false);
        const bool holds_clusters = id == 0x18538067 || id == 0x1F43B675;  // segment, cluster
        if (holds_clusters) {
            frames += frames_of_webm(bytes, at, std::min<std::size_t>(end, at + size));
        } else if (id == 0xA3 || id == 0xA0) {
            ++frames;
        }
        at += size;
    }
    return frames;
}

}  // namespace

TEST_CASE("an MP4 holds every frame, at its rate, with its index in front", "[video]") {
    const Scratch folder;
    write_animation(folder / "v.mp4", crossing());
    const std::string bytes = bytes_of(folder / "v.mp4");
    const std::size_t samples = bytes.find("stsz");
    REQUIRE(samples != std::string::npos);
    CHECK(big_endian(bytes, samples + 12) == 30);  // after version and the common size
    const std::size_t media = bytes.find("mdhd");
    REQUIRE(media != std::string::npos);
    const double timescale = big_endian(bytes, media + 16);
    CHECK(big_endian(bytes, media + 20) / timescale == Approx(1.0));
    CHECK(bytes.find("moov") < bytes.find("mdat"));
}

TEST_CASE("a WebM holds every frame", "[video]") {
    const Scratch folder;
    write_animation(folder / "v.webm", crossing());
    const std::string bytes = bytes_of(folder / "v.webm");
    CHECK(frames_of_webm(bytes, 0, bytes.size()) == 30);
}

TEST_CASE("a GIF lasts as long as the animation and shows a held frame once", "[video]") {
    const Scratch folder;
    write_animation(folder / "v.gif", crossing());
    const GifFrames frames = frames_of_gif(bytes_of(folder / "v.gif"));
    CHECK(frames.count == 21);
    CHECK(frames.hundredths == 100);
}

TEST_CASE("a draft has half the frames in the same time", "[video]") {
    const Scratch folder;
    write_animation(folder / "v.mp4", crossing(),
                    {.quality = Quality::draft, .progress = {}, .warn = {}});
    const std::string bytes = bytes_of(folder / "v.mp4");
    CHECK(big_endian(bytes, bytes.find("stsz") + 12) == 15);
    const std::size_t media = bytes.find("mdhd");
    CHECK(big_endian(bytes, media + 20) / static_cast<double>(big_endian(bytes, media + 16)) ==
          Approx(1.0));
}

TEST_CASE("the same frames give the same bytes", "[video]") {
    const Scratch folder;
    for (const std::string& ending : film_endings) {
        INFO(ending);
        write_animation(folder / ("a." + ending), crossing());
        write_animation(folder / ("b." + ending), crossing());
        CHECK(bytes_of(folder / ("a." + ending)) == bytes_of(folder / ("b." + ending)));
    }
}

TEST_CASE("a video names no version of the encoder", "[video]") {
    const Scratch folder;
    write_animation(folder / "v.mp4", crossing());
    CHECK(bytes_of(folder / "v.mp4").find("x264") == std::string::npos);
    CHECK(bytes_of(folder / "v.mp4").find("Lavf5") == std::string::npos);
}

TEST_CASE("progress counts the frames up to the last", "[video]") {
    const Scratch folder;
    Progress last;
    bool rising = true;
    WriteOptions options;
    options.progress = [&](const Progress& progress) {
        rising = rising && progress.done > last.done;
        last = progress;
    };
    write_animation(folder / "v.mp4", crossing(), options);
    CHECK(rising);
    CHECK(last.done == 30);
    CHECK(last.total == 30);
}

TEST_CASE("an interrupted video leaves nothing behind", "[video]") {
    const Scratch folder;
    for (const std::string& ending : film_endings) {
        INFO(ending);
        WriteOptions options;
        options.progress = [](const Progress& progress) {
            if (progress.done == 5) lod::stop_requested = true;
        };
        CHECK_THROWS_AS(write_animation(folder / ("v." + ending), crossing(), options),
                        lod::Interrupted);
        lod::stop_requested = false;
        CHECK(folder.is_empty());
    }
}

TEST_CASE("a video on a full disk is an error, and no file is left", "[video]") {
    const Scratch folder;
    for (const std::string& ending : film_endings) {
        for (const rlim_t bytes : {100u, 5000u}) {
            INFO(ending << ", " << bytes << " bytes");
            const SmallDisk disk(bytes);
            try {
                write_animation(folder / ("v." + ending), crossing());
                FAIL("written to a full disk");
            } catch (const lod::Error& error) {
                CHECK(error.kind() == lod::ErrorKind::output_failed);
            }
            CHECK(folder.is_empty());
        }
    }
}

TEST_CASE("frames of different sizes are refused", "[video]") {
    const Scratch folder;
    Animation animation = crossing();
    Figure tall = frame(0);
    tall.aspect = 1;
    hold(animation, tall, 0.1);
    try {
        write_animation(folder / "v.mp4", animation);
        FAIL("filmed");
    } catch (const lod::Error& error) {
        CHECK(error.kind() == lod::ErrorKind::input_refused);
    }
    CHECK(folder.is_empty());
}

TEST_CASE("an animation without frames or with no sensible rate is refused", "[video]") {
    const Scratch folder;
    CHECK_THROWS_AS(write_animation(folder / "v.mp4", Animation{}), lod::Error);
    Animation animation = crossing();
    animation.frames_per_second = 0;
    CHECK_THROWS_AS(write_animation(folder / "v.mp4", animation), lod::Error);
    CHECK(folder.is_empty());
}

TEST_CASE("a GIF of three inks keeps them apart", "[video]") {
    const Scratch folder;
    write_animation(folder / "v.gif", crossing());
    const std::string bytes = bytes_of(folder / "v.gif");
    // The ground is in the table exactly: white.
    bool white = false;
    for (std::size_t i = 13; i + 2 < 13 + 768; i += 3)
        white = white || bytes.substr(i, 3) == "\xff\xff\xff";
    CHECK(white);
}
