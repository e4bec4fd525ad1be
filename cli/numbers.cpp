#include "cli/numbers.hpp"

#include <nlohmann/json.hpp>

#include "cli/output.hpp"

namespace cli {

using Json = nlohmann::ordered_json;

Json list_of(const Eigen::Ref<const Eigen::VectorXd>& vector) {
    Json list = Json::array();
    for (const double number : vector) list.push_back(number);
    return list;
}

Json moment_of(const Eigen::Ref<const Eigen::MatrixXd>& moment) {
    if (moment.size() == 1) return moment(0, 0);
    Json rows = Json::array();
    for (Eigen::Index i = 0; i < moment.rows(); ++i)
        rows.push_back(list_of(moment.row(i).transpose()));
    return rows;
}

std::string in_brackets(const Eigen::Ref<const Eigen::VectorXd>& vector, int digits) {
    std::string text = "(";
    for (Eigen::Index i = 0; i < vector.size(); ++i)
        text += (i > 0 ? ", " : "") + readable(vector[i], digits);
    return text + ")";
}

}  // namespace cli
