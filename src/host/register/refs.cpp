// SPDX-License-Identifier: Apache-2.0
#include "host/register/refs.hpp"

#include <sstream>

namespace canproof::host {

std::vector<std::string> split_refs(const std::string& text) {
    std::vector<std::string> refs;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        std::string number;
        if ((word == "Table" || word == "Figure") && words >> number) {
            word += " " + number;
        }
        refs.push_back(word);
    }
    return refs;
}

std::set<std::string> refs_of(const Manual& manual) {
    std::set<std::string> refs;
    for (const auto& section : manual.sections) {
        refs.insert(section.ref);
        refs.insert(section.objects.begin(), section.objects.end());
    }
    return refs;
}

bool is_within(const std::string& ref, const std::string& above) {
    return ref == above || ref.rfind(above + ".", 0) == 0;
}

}  // namespace canproof::host
