// SHA-256 of bytes, as 64 small hexadecimal digits.
#pragma once

#include <string>

namespace canproof::host {

std::string sha256(const std::string& bytes);

}  // namespace canproof::host
