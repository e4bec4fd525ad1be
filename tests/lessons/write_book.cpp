// Writes the whole book, without its videos, for the browser test; what another build left there
// goes.

#include <exception>
#include <filesystem>
#include <iostream>

#include "lessons/book/book.hpp"
#include "lessons/engine/lessons.hpp"

int main(int count, char** values) {
    try {
        lessons::BookOptions options;
        options.video = false;
        const std::filesystem::path folder = count > 1 ? values[1] : "book";
        std::filesystem::remove_all(folder);
        lessons::write_book(folder, options);
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << "\n";
        return 1;
    }
}
