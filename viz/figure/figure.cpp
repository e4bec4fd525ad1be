#include "lodlab/viz/figure/figure.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace viz {

Mark::Mark(const Mark& other) = default;
Mark::Mark(Mark&& other) noexcept = default;
Mark& Mark::operator=(const Mark& other) = default;
Mark& Mark::operator=(Mark&& other) noexcept = default;
Mark::~Mark() = default;

const char* role_name(Role role) {
    switch (role) {
        case Role::body:
            return "body";
        case Role::wall:
            return "wall";
        case Role::ghost:
            return "ghost";
        case Role::node:
            return "node";
        case Role::level_node:
            return "level_node";
        case Role::meeting_node:
            return "meeting_node";
        case Role::true_collision:
            return "true_collision";
        case Role::dropped_node:
            return "dropped_node";
        case Role::contact:
            return "contact";
        case Role::normal:
            return "normal";
        case Role::impulse:
            return "impulse";
        case Role::velocity:
            return "velocity";
        case Role::trajectory:
            return "trajectory";
        case Role::reference:
            return "reference";
        case Role::curve:
            return "curve";
        case Role::band:
            return "band";
        case Role::construction:
            return "construction";
        case Role::reached:
            return "reached";
        case Role::share:
            return "share";
        case Role::excess:
            return "excess";
        case Role::note:
            return "note";
    }
    return "unknown";
}

int frame_count(const Animation& animation) {
    int frames = 0;
    for (const Shot& shot : animation.shots) frames += std::max(1, shot.frames);
    return frames;
}

void hold(Animation& animation, Figure figure, double seconds) {
    const double frames = std::round(seconds * animation.frames_per_second);
    animation.shots.push_back(
        {[held = std::move(figure)] { return held; }, std::max(1, static_cast<int>(frames))});
}

std::string plain_text(const std::string& text) {
    std::string plain;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\\' && i + 1 < text.size())
            plain += text[++i];
        else if (c == '_' && i + 1 < text.size() && text[i + 1] == '{')
            ++i;
        else if (c != '*' && c != '_' && c != '}')
            plain += c;
    }
    return plain;
}

std::string literal_text(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (c == '*' || c == '_' || c == '}' || c == '\\') text += '\\';
        text += c;
    }
    return text;
}

}  // namespace viz
