#pragma once

// How a case comes to an exercise's function and its answer comes back: rows of doubles, for the
// student's program, which includes this file, and for lodlab's own variants of the function.

#include <cstdint>
#include <cstdio>
#include <exception>
#include <type_traits>
#include <vector>

#include "lodlab/core/math/sphere.hpp"

namespace lod {
template <int Dim>
struct Body;
template <int Dim>
struct Contact;
}  // namespace lod

namespace exercises::wire {

struct Reader {
    const double* at = nullptr;
    const double* end = nullptr;
    double next() { return at < end ? *at++ : 0; }
};

struct Writer {
    std::vector<double> numbers;
};

inline void take(Reader& in, double& number) {
    number = in.next();
}
inline void take(Reader& in, int& number) {
    number = static_cast<int>(in.next());
}
inline void take(Reader& in, bool& yes) {
    yes = in.next() != 0;
}

template <int Rows, int Cols>
void take(Reader& in, lod::FixedMatrix<Rows, Cols>& matrix) {
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Cols; ++column) matrix.entry[row + Rows * column] = in.next();
}

inline void take(Reader& in, lod::Quaternion& turn) {
    const double w = in.next();
    const double x = in.next();
    const double y = in.next();
    turn = lod::Quaternion(w, x, y, in.next());
}

template <int Dim>
void take(Reader& in, lod::Sphere<Dim>& ball) {
    take(in, ball.centre);
    take(in, ball.radius);
}

template <int Dim>
void take(Reader& in, lod::Contact<Dim>& contact) {
    take(in, contact.point);
    take(in, contact.normal);
}

template <int Dim>
void take(Reader& in, lod::Body<Dim>& body) {
    take(in, body.inverse_mass);
    take(in, body.inertia);
    take(in, body.inverse_inertia);
    take(in, body.restitution);
    take(in, body.position);
    take(in, body.orientation);
    take(in, body.velocity);
    take(in, body.spin);
}

/// So many as the first number says.
template <class T>
void take(Reader& in, std::vector<T>& list) {
    list.resize(static_cast<std::size_t>(in.next()));
    for (T& one : list) take(in, one);
}

inline void give(Writer& out, double number) {
    out.numbers.push_back(number);
}

template <int Rows, int Cols>
void give(Writer& out, const lod::FixedMatrix<Rows, Cols>& matrix) {
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Cols; ++column) give(out, matrix.entry[row + Rows * column]);
}

template <class T>
void give(Writer& out, const std::vector<T>& list) {
    give(out, static_cast<double>(list.size()));
    for (const T& one : list) give(out, one);
}

template <class... Argument>
struct Types {};

template <class Function, class... Taken>
auto ask(Reader&, Function function, Types<>, Taken&... taken) {
    return function(taken...);
}

/// Takes one argument after another from the case, then calls the function.
template <class Function, class First, class... Rest, class... Taken>
auto ask(Reader& in, Function function, Types<First, Rest...>, Taken&... taken) {
    std::remove_cvref_t<First> argument;
    take(in, argument);
    return ask(in, function, Types<Rest...>(), taken..., argument);
}

template <class Signature>
struct Call;

/// Calls a function with what a case says.
template <class Answer, class... Argument>
struct Call<Answer(Argument...)> {
    template <class Function>
    static std::vector<double> answer(Function function, Reader in) {
        const Answer answer = ask(in, function, Types<Argument...>());
        Writer out;
        give(out, answer);
        return out.numbers;
    }
};

/// The exit code of a program whose function threw.
constexpr int threw_code = 70;

/// Answers the cases of one file in another, each as soon as it is known.
template <class Signature, class Function>
int serve(char** paths, Function function) {
    std::FILE* cases = std::fopen(paths[1], "rb");
    std::FILE* answers = std::fopen(paths[2], "wb");
    if (cases == nullptr || answers == nullptr) return 71;
    double size = 0;
    while (std::fread(&size, sizeof size, 1, cases) == 1) {
        std::vector<double> numbers(static_cast<std::size_t>(size));
        if (std::fread(numbers.data(), sizeof size, numbers.size(), cases) != numbers.size())
            return 71;
        try {
            numbers = Call<Signature>::answer(function,
                                              {numbers.data(), numbers.data() + numbers.size()});
        } catch (const std::exception& thrown) {
            std::fprintf(stderr, "\n%s\n", thrown.what());
            return threw_code;
        }
        size = static_cast<double>(numbers.size());
        std::fwrite(&size, sizeof size, 1, answers);
        std::fwrite(numbers.data(), sizeof size, numbers.size(), answers);
        std::fflush(answers);
    }
    return 0;
}

}  // namespace exercises::wire
