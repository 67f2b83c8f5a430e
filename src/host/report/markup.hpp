// Text and numbers that go into HTML or SVG.
#pragma once

#include <cstdint>
#include <string>

namespace canproof::host {

/// The text with `& < > "` written so that they are no markup; fit for elements and for attributes in double quotes.
std::string escaped(const std::string& text);

/// A decimal number in groups of three: `-1,234,567.8`.
std::string grouped(std::string number);
std::string grouped(std::uint64_t number);

}  // namespace canproof::host
