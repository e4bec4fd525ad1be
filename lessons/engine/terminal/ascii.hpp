#pragma once

#include <streambuf>
#include <string>

namespace lessons {

/// Passes text on in ASCII, for a terminal without UTF-8: "3 m²" as "3 m^2", what has no such form
/// as "?".
class AsciiBuffer : public std::streambuf {
  public:
    explicit AsciiBuffer(std::streambuf* to) : to_(to) {}

  protected:
    int_type overflow(int_type c) override;
    int sync() override;

  private:
    std::streambuf* to_;
    std::string pending_;  ///< of a character of several bytes
};

}  // namespace lessons
