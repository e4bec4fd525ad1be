#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace scenes {

/// The bytes of a trace, to be read at any place.
class TraceText {
  public:
    TraceText(std::unique_ptr<std::istream> in, std::uint64_t size)
        : in_(std::move(in)), size_(size) {}

    [[nodiscard]] std::uint64_t size() const { return size_; }
    /// Those from `begin` to before `end`. Throws std::runtime_error where they cannot be read, or
    /// are more than the limit. Requires: begin <= end <= size().
    [[nodiscard]] std::string bytes(std::uint64_t begin, std::uint64_t end);
    /// Without its newline; empty where the text has none.
    [[nodiscard]] std::string first_line();
    /// Without its newline; empty where the text does not end with one.
    [[nodiscard]] std::string last_line();

  private:
    std::unique_ptr<std::istream> in_;
    std::uint64_t size_ = 0;
};

/// What a line is in the one JSON document that a trace is.
enum class TraceLine {
    head,   ///< the document's first keys; opens the list of entries
    entry,  ///< of that list: a key frame or a frame
    end,    ///< closes the list; the document's key "end"
    index,  ///< its key "index"; closes the document
};

/// The object as a line that ends with its check: FNV-1a over all of the object before it. A change
/// of any one byte is seen.
[[nodiscard]] std::string checked_line(const nlohmann::ordered_json& object, TraceLine line);
/// The object of such a line, which has no newline. Throws std::exception at any other.
[[nodiscard]] nlohmann::ordered_json object_of(std::string_view checked_line, TraceLine line);

}  // namespace scenes
