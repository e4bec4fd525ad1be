// Makes what lodlab makes, trees, runs and texts, and prints a hash of each: the same on every
// machine, from every compiler, at every level of optimisation and for every instruction set.
//
// Usage: state_hashes          prints them
//        state_hashes FILE     compares with those in FILE, names what differs, exits 1 if anything

#include <cstdio>
#include <fstream>
#include <map>

#include "lodlab/core/tree/family_tests.hpp"
#include "tests/determinism/report.hpp"

namespace {

/// Of "hash  name" lines.
std::map<std::string, std::string> read_hashes(const char* path) {
    std::ifstream file(path);
    std::map<std::string, std::string> hashes;
    for (std::string line; std::getline(file, line);)
        if (line.size() > 18) hashes[line.substr(18)] = line.substr(0, 16);
    return hashes;
}

/// What other ways of testing nodes, by other instructions of this machine, make of core's bodies:
/// nothing is added where that is the same.
void add_other_paths(Report& report) {
    std::map<std::string, std::string> fastest;
    for (const Report::Line& line : report.lines()) fastest[line.name] = line.hash;
    for (const lod::detail::TestPath& path : lod::detail::test_paths()) {
        lod::detail::take_path(path);
        Report other;
        add_traversals(other);
        for (const Report::Line& line : other.lines())
            if (line.hash != fastest[line.name])
                report.add(line.name + ", by " + std::string(path.name),
                           std::stoull(line.hash, nullptr, 16));
    }
    lod::detail::take_path(lod::detail::test_paths().front());
}

int compare(const Report& report, const char* path) {
    std::map<std::string, std::string> expected = read_hashes(path);
    int same = 0;
    int other = 0;
    std::size_t left_out = 0;  // rows
    for (const Report::Line& line : report.lines()) {
        const auto found = expected.extract(line.name);
        const std::string wanted = found ? found.mapped() : "nothing";
        if (line.hash.empty()) {
            std::printf("not made: %s (%s)\n", line.name.c_str(), line.why_not.c_str());
            left_out += (found ? 1 : 0) + std::erase_if(expected, [&](const auto& left) {
                            return left.first.starts_with(line.name);
                        });
        } else if (line.hash == wanted) {
            ++same;
        } else {
            ++other;
            std::printf("%s: %s instead of %s\n", line.name.c_str(), line.hash.c_str(),
                        wanted.c_str());
        }
    }
    for (const auto& [name, hash] : expected) std::printf("%s: nothing made it\n", name.c_str());
    other += static_cast<int>(expected.size());
    if (left_out > 0) std::printf("left out: %zu rows\n", left_out);
    std::printf("%d of %d hashes are those in %s\n", same, same + other, path);
    if (other > 0)
        std::puts(
            "Where the change is meant, write them there: state_hashes > "
            "tests/determinism/hashes.txt");
    return other > 0 ? 1 : 0;
}

}  // namespace

int main(int count, char** arguments) {
    Report report;
    add_crowds(report);
    add_plane_trees(report);
    add_space_trees(report);
    add_scenes(report);
    add_measurements(report);
    add_other_paths(report);
    if (count > 1) return compare(report, arguments[1]);
    for (const Report::Line& line : report.lines())
        if (!line.hash.empty()) std::printf("%s  %s\n", line.hash.c_str(), line.name.c_str());
    return 0;
}
