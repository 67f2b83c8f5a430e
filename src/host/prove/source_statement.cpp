// SPDX-License-Identifier: Apache-2.0
#include "host/prove/source_statement.hpp"

#include <charconv>
#include <filesystem>
#include <vector>

#include "host/base/lines.hpp"
#include "host/base/trimmed.hpp"

namespace canproof::host::prove {

std::string statement_at(const std::string& place) {
    const std::size_t colon = place.rfind(':');
    const std::filesystem::path file = place.substr(0, colon);
    std::size_t number = 0;
    const char* const end = place.data() + place.size();
    if (colon == std::string::npos || !std::filesystem::exists(file) ||
        std::from_chars(place.data() + colon + 1, end, number).ec != std::errc{} || number == 0) {
        return "";
    }
    const std::vector<std::string> lines = read_lines(file);
    std::string text;
    for (std::size_t at = number - 1; at < lines.size() && text.find(';') == std::string::npos; ++at) {
        text += (text.empty() ? "" : " ") + trimmed(lines[at]);
    }
    return text.substr(0, text.find(';'));
}

}  // namespace canproof::host::prove
