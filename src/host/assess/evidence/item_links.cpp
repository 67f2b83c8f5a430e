// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/item_links.hpp"

#include <fmt/format.h>

#include "host/assess/trace/audit.hpp"
#include "host/report/markup.hpp"

namespace canproof::host {

std::string audit_page_name(const Part& part) {
    return "audit-" + part.name + ".html";
}

ItemLinks links_of(const PackInput& input) {
    ItemLinks links;
    for (const auto& audit : input.audits) {
        for (const auto& one : audit.items) {
            links[one.item->id] = audit_page_name(*audit.part) + "#" + one.item->id;
        }
        for (const auto& one : audit.part->decisions) {
            links[one.id] = "decisions.html#" + one.id;
        }
        for (const auto& one : audit.part->hazards) {
            links[one.id] = "hazards.html#" + one.id;
        }
    }
    return links;
}

std::string link_to(const ItemLinks& links, const std::string& id) {
    const auto found = links.find(id);
    return found == links.end() ? fmt::format("<code>{}</code>", escaped(id))
                                : fmt::format("<a href=\"{}\">{}</a>", escaped(found->second), escaped(id));
}

std::string link_to_each(const ItemLinks& links, const std::vector<std::string>& ids) {
    std::string text;
    for (const auto& id : ids) {
        text += (text.empty() ? "" : ", ") + link_to(links, id);
    }
    return text;
}

}  // namespace canproof::host
