// Writes the book without its videos, for the browser test; what another build left there goes.
// Usage: write_book FOLDER [LESSON...], all lessons where no number is given.

#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

#include "lessons/book/book.hpp"
#include "lessons/engine/lessons.hpp"

int main(int count, char** values) {
    try {
        lessons::BookOptions options;
        options.video = false;
        const std::filesystem::path folder = count > 1 ? values[1] : "book";
        for (int i = 2; i < count; ++i) options.lessons.push_back(std::stoi(values[i]));
        std::filesystem::remove_all(folder);
        lessons::write_book(folder, options);
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << "\n";
        return 1;
    }
}
