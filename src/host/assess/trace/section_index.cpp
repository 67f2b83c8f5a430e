// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/section_index.hpp"

#include "host/register/refs.hpp"

namespace canproof::host {

SectionIndex::SectionIndex(const Register& content) {
    std::size_t order = 0;
    for (const auto& part : content.parts) {
        content.for_each_item(part, [&](const Item& item, const char*) {
            ++order;
            for (const auto& source : item.sources) {
                const auto colon = source.find(':');
                if (colon == std::string::npos) {
                    continue;
                }
                for (const auto& ref : split_refs(source.substr(colon + 1))) {
                    hits_[source.substr(0, colon + 1) + ref].push_back({order, item.id});
                }
            }
        });
    }
}

std::vector<std::string> SectionIndex::items_of(const std::string& manual, const Section& section) const {
    std::map<std::size_t, std::string> ordered;
    const auto add = [&](const std::string& ref) {
        const auto found = hits_.find(manual + ":" + ref);
        if (found != hits_.end()) {
            for (const auto& hit : found->second) {
                ordered[hit.order] = hit.id;
            }
        }
    };
    add(section.ref);
    for (const auto& object : section.objects) {
        add(object);
    }
    std::vector<std::string> ids;
    for (const auto& [order, id] : ordered) {
        ids.push_back(id);
    }
    return ids;
}

}  // namespace canproof::host
