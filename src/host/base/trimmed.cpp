// SPDX-License-Identifier: Apache-2.0
#include "host/base/trimmed.hpp"

namespace canproof::host {

std::string_view trimmed_view(std::string_view text, std::string_view blanks) {
    const auto first = text.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string trimmed(std::string_view text, std::string_view blanks) {
    return std::string{trimmed_view(text, blanks)};
}

}  // namespace canproof::host
