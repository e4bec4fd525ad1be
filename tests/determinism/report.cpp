#include "tests/determinism/report.hpp"

#include <cstdio>

void Report::add(const std::string& name, std::uint64_t hash) {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
    lines_.push_back({name, digits, ""});
}

void Report::add_text(const std::string& name, std::string_view text) {
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    add(name, hash);
}

void Report::leave_out(const std::string& name, const std::string& why) {
    lines_.push_back({name, "", why});
}
