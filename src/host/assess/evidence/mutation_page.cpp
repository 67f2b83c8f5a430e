// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/mutation_page.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/assess/evidence/item_links.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

std::vector<std::vector<std::string>> survivors_in(const std::string& text, const ItemLinks& links) {
    std::vector<std::vector<std::string>> rows;
    const auto document = nlohmann::json::parse(text);
    for (const auto& one : document.at("survivors")) {
        const std::string reason = one.at("reason");
        rows.push_back({link_to(links, one.at("item")), escaped(one.at("cell").get<std::string>()),
                        escaped(one.at("change").get<std::string>()),
                        reason.empty() ? html_state("open") : prose(reason)});
    }
    return rows;
}

}  // namespace

std::string mutation_page(const PackInput& input) {
    const MeasuredMutation& mutation = *input.mutation;
    const ItemLinks links = links_of(input);
    std::vector<std::vector<std::string>> rows;
    for (const auto& [id, count] : mutation.items) {
        const bool closed = count.altered == count.noticed + count.justified;
        rows.push_back({link_to(links, id), std::to_string(count.altered), std::to_string(count.noticed),
                        std::to_string(count.justified), html_state(closed ? "holds" : "open")});
    }
    return "<p>Each cell that was generated from the register (defaults, limits, rights, mappings, rows of tables, "
           "constants) is altered, one cell at a time; a test that claims the item of the cell has to fail.</p>\n" +
           html_table("Altered cells by item",
                      {{"Item"}, {"Altered"}, {"Noticed"}, {"Survive with a reason"}, {"State"}}, rows, Search::yes) +
           "<h2>What survives</h2>\n" +
           html_table("Alterations that survive", {{"Item", 16}, {"Cell", 28}, {"Change", 22}, {"Reason"}},
                      survivors_in(mutation.json, links), Search::yes);
}

}  // namespace canproof::host
