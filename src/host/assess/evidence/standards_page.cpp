// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/standards_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/technique_states.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

std::string counts_of(const std::vector<Technique>& techniques) {
    const auto count = [&](const char* state) {
        return static_cast<std::size_t>(std::count_if(techniques.begin(), techniques.end(),
                                                      [state](const Technique& one) { return one.state == state; }));
    };
    const std::size_t shown = count("shown");
    const std::size_t partly = count("partly");
    const std::size_t absent = count("missing");
    const std::size_t inapplicable = count("not applicable");
    return fmt::format(
        "{} rows: {} shown, {} partly, {} missing, {} not applicable; {} rest on evidence that is not "
        "measured, stale or open in this pack.",
        techniques.size(), shown, partly, absent, inapplicable,
        techniques.size() - shown - partly - absent - inapplicable);
}

}  // namespace

std::string standards_page(const PackInput& input, const Exhibits& exhibits) {
    const auto all = techniques_of(input.argument, exhibits);
    std::string text = fmt::format(
        "<p>The tables list, in our words, the techniques that IEC 61508-3:2010 recommends for SIL 3 and ISO 26262-6 "
        "and -8:2018 for ASIL D, with their use in this project. {}</p>\n<p>The authors judge their own work: this is "
        "no independent assessment. The levels are as the authors read the standards; compare them with a copy of the "
        "standards.</p>\n",
        counts_of(all));
    for (auto first = all.begin(); first != all.end();) {
        const auto last =
            std::find_if(first, all.end(), [&](const Technique& one) { return one.table != first->table; });
        std::vector<std::vector<std::string>> rows;
        std::for_each(first, last, [&rows](const Technique& one) {
            rows.push_back(
                {escaped(one.number), escaped(one.name), escaped(one.level), html_state(one.state), prose(one.how)});
        });
        text += fmt::format("<h2>{}: {}</h2>\n", escaped(first->table), escaped(first->title)) +
                html_table(first->title,
                           {{"Row", 6}, {"Technique", 30}, {"Level", 8}, {"State", 14}, {"In this project"}}, rows);
        first = last;
    }
    return text;
}

}  // namespace canproof::host
