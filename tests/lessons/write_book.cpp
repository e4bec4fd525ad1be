// Writes the whole book, without its videos, for the browser test.

#include <exception>
#include <iostream>

#include "lessons/book/book.hpp"
#include "lessons/engine/lessons.hpp"

int main(int count, char** values) {
    try {
        lessons::BookOptions options;
        options.video = false;
        lessons::write_book(count > 1 ? values[1] : "book", options);
        return 0;
    } catch (const std::exception& problem) {
        std::cerr << problem.what() << "\n";
        return 1;
    }
}
