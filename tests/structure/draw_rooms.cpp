// Draws which room of lodlab includes which, from what rules.py --includes prints:
//     python3 tests/structure/rules.py --includes . > doc/rooms.txt
//     draw_rooms doc/rooms.svg < doc/rooms.txt
// A room stands above all that it includes; what another room on the way includes too is left out.

#include <algorithm>
#include <exception>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lodlab/viz/paint/write.hpp"

namespace {

using Rooms = std::map<std::string, std::set<std::string>>;  // room -> what it includes

Rooms read(std::istream& input) {
    Rooms rooms;
    std::string room, other;
    while (input >> room >> other) {
        rooms[room].insert(other);
        rooms[other];
    }
    return rooms;
}

/// How many rooms stand below one another under a room.
int floor_of(const Rooms& rooms, const std::string& room) {
    int floor = 0;
    for (const std::string& below : rooms.at(room))
        floor = std::max(floor, 1 + floor_of(rooms, below));
    return floor;
}

bool reaches(const Rooms& rooms, const std::string& from, const std::string& to) {
    return from == to || std::ranges::any_of(rooms.at(from), [&](const std::string& below) {
               return reaches(rooms, below, to);
           });
}

/// The folder at the root that a room is in.
std::string family_of(const std::string& room) {
    const std::string top = room.substr(0, room.find('/'));
    return top == "io" || top == "scenes" || top == "measure" ? "scenes" : top;
}

/// A column a folder, by floors; rooms that share both stand side by side.
std::map<std::string, viz::Point> places_of(const Rooms& rooms) {
    const std::vector<std::string> columns{"lessons", "lod2d", "core", "scenes",
                                           "lod3d",   "viz",   "cli"};
    std::map<std::pair<std::string, int>, int> taken;
    std::map<std::string, viz::Point> places;
    for (const auto& [room, below] : rooms) {
        const int floor = floor_of(rooms, room);
        const std::string family = family_of(room);
        const auto column = std::ranges::find(columns, family) - columns.begin();
        const int beside = taken[{family, floor}]++;
        places[room] = {3.0 * static_cast<double>(column) + 1.3 * beside,
                        1.25 * floor + 0.5 * beside};
    }
    return places;
}

viz::Figure drawn(const Rooms& rooms) {
    viz::Figure figure;
    figure.title = "Which room stands on which?";
    figure.caption =
        "A line leads down to a room that is included; those that another line implies are left "
        "out.";
    figure.alt = "Rooms of lodlab in floors; each includes rooms of lower floors only.";
    figure.scale_bar = false;
    figure.aspect = 1.1;
    const auto places = places_of(rooms);
    viz::Panel panel;
    panel.view = {{-1, -0.8}, {20.5, 0}};
    for (const auto& [room, place] : places)
        panel.view.high.y = std::max(panel.view.high.y, place.y + 0.6);
    for (const auto& [room, below] : rooms)
        for (const std::string& other : below) {
            const bool implied = std::ranges::any_of(below, [&](const std::string& between) {
                return between != other && reaches(rooms, between, other);
            });
            if (!implied)
                panel.marks.push_back(viz::Polyline{{.role = viz::Role::construction},
                                                    {places.at(room), places.at(other)}});
        }
    for (const auto& [room, place] : places) {
        panel.marks.push_back(viz::Dot{{.role = viz::Role::contact}, place});
        panel.marks.push_back(
            viz::Label{{.role = viz::Role::note}, place, viz::literal_text(room), 0.1});
    }
    figure.panels.push_back(std::move(panel));
    return figure;
}

}  // namespace

int main(int count, char** values) {
    try {
        if (count != 2) throw std::invalid_argument("draw_rooms: name the picture to write");
        viz::write_figure(values[1], drawn(read(std::cin)));
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << "\n";
        return 1;
    }
}
