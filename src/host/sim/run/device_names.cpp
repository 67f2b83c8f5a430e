// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/device_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t most_listed = 20;

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (std::size_t i = 0; i < names.size() && i < most_listed; ++i) {
        text += (i == 0 ? "" : ", ") + names[i];
    }
    return names.size() <= most_listed ? text : text + fmt::format(" and {} more", names.size() - most_listed);
}

}  // namespace

std::size_t find_device(const std::vector<std::string>& names, const std::string& name) {
    const auto whole = std::find(names.begin(), names.end(), name);
    if (whole != names.end()) {
        return static_cast<std::size_t>(whole - names.begin());
    }
    std::vector<std::string> candidates;
    std::size_t found = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i].substr(0, names[i].rfind('@')) == name) {
            candidates.push_back(names[i]);
            found = i;
        }
    }
    if (candidates.empty()) {
        throw InputError{fmt::format("no device `{}` runs here; there is {}", name, listed(names))};
    }
    if (candidates.size() > 1) {
        throw InputError{fmt::format("`{}` is the name of {}; write one of these", name, listed(candidates))};
    }
    return found;
}

}  // namespace canproof::host
