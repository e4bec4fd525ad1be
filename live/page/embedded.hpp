#pragma once

#include <string_view>

/// The files of this folder, and the module, as they were when the program was built.
namespace live::embedded {

[[nodiscard]] std::string_view page_html();
[[nodiscard]] std::string_view page_css();
[[nodiscard]] std::string_view page_js();
[[nodiscard]] std::string_view live_css();
[[nodiscard]] std::string_view figure_js();
[[nodiscard]] std::string_view controls_js();
[[nodiscard]] std::string_view numbers_js();
[[nodiscard]] std::string_view handles_js();
[[nodiscard]] std::string_view inside_js();
[[nodiscard]] std::string_view live_js();
[[nodiscard]] std::string_view playground_js();
/// Empty where there was none.
[[nodiscard]] std::string_view module_js();

}  // namespace live::embedded
