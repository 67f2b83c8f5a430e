#include "host/assess/trace/section_index.hpp"

#include <sstream>

namespace canproof::host {

namespace {

/// "1.3 Table 7" names "1.3" and "Table 7".
std::vector<std::string> refs_of(const std::string& text) {
    std::istringstream words{text};
    std::vector<std::string> refs;
    for (std::string word; words >> word;) {
        std::string number;
        if ((word == "Table" || word == "Figure") && words >> number) {
            word += " " + number;
        }
        refs.push_back(word);
    }
    return refs;
}

}  // namespace

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
                for (const auto& ref : refs_of(source.substr(colon + 1))) {
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
