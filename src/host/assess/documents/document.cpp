// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/document.hpp"

#include <algorithm>

namespace canproof::host {

std::size_t count_missing(const Document& document) {
    std::size_t count = 0;
    for (const auto& chapter : document.chapters) {
        for (const auto& table : chapter.tables) {
            for (const auto& row : table.rows) {
                count += static_cast<std::size_t>(std::count(row.begin(), row.end(), missing));
            }
        }
    }
    return count;
}

}  // namespace canproof::host
