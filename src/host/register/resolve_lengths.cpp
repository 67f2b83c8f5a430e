// SPDX-License-Identifier: Apache-2.0
// Gives each string without a `length` the length of its default.

#include "host/register/resolve_lengths.hpp"

namespace canproof::host {

void resolve_lengths(Part& part) {
    for (Object& object : part.objects) {
        for (Entry& entry : object.entries) {
            const auto* text = std::get_if<std::string>(&entry.value);
            if (text != nullptr && entry.length == 0 && is_string_type(entry.type)) {
                entry.length = text->size();
            }
        }
    }
}

}  // namespace canproof::host
