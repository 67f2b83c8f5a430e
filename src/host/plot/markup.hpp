// Text that goes into HTML or SVG.
#pragma once

#include <string>

namespace canproof::host {

/// The text with `& < > "` written so that they are no markup; fit for elements and for attributes in double quotes.
std::string escaped(const std::string& text);

}  // namespace canproof::host
