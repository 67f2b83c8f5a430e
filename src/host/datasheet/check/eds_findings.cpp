// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/eds_findings.hpp"

#include <algorithm>
#include <tuple>

#include "host/register/fault.hpp"

namespace canproof::host {

void EdsFindings::add(const std::string& rule, unsigned line, std::string what, std::vector<EdsEdit> edits) {
    add(rule, line, std::move(what),
        edits.empty() ? nullptr : std::make_shared<const std::vector<EdsEdit>>(std::move(edits)));
}

void EdsFindings::add(const std::string& rule, unsigned line, std::string what, EdsEdits edits) {
    const EdsRule& found = rules_.at(rule);
    if (all_.size() < Faults::most) {
        all_.push_back({found, line, std::move(what), found.fix, std::move(edits), all_.size()});
    }
}

std::vector<EdsFinding> EdsFindings::take() {
    std::sort(all_.begin(), all_.end(), [](const EdsFinding& a, const EdsFinding& b) {
        return std::tie(a.line, a.order) < std::tie(b.line, b.order);
    });
    return std::move(all_);
}

}  // namespace canproof::host
