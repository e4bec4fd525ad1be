#include "cli/terminal/numbers.hpp"

#include <nlohmann/json.hpp>

#include "cli/terminal/output.hpp"

namespace cli {

using Json = nlohmann::ordered_json;

Json list_of(std::span<const double> vector) {
    Json list = Json::array();
    for (const double number : vector) list.push_back(number);
    return list;
}

template <int Size>
Json moment_of(const lod::FixedMatrix<Size, Size>& moment) {
    if constexpr (Size == 1) return moment(0, 0);
    Json rows = Json::array();
    for (int i = 0; i < Size; ++i) rows.push_back(list_of(moment.transpose().col(i)));
    return rows;
}

std::string in_brackets(std::span<const double> vector, int digits) {
    std::string text = "(";
    for (std::size_t i = 0; i < vector.size(); ++i)
        text += (i > 0 ? ", " : "") + readable(vector[i], digits);
    return text + ")";
}

template Json moment_of(const lod::FixedMatrix<1, 1>&);
template Json moment_of(const lod::FixedMatrix<3, 3>&);

}  // namespace cli
