// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/coverage_page.hpp"

#include <fmt/format.h>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

std::string cell(const CoverageCount& count) {
    return fmt::format("<span class=n>{:.1f} %</span> <small>{}/{}</small>", count.percent(), count.covered,
                       count.total);
}

}  // namespace

std::string coverage_page(const MeasuredCoverage& coverage) {
    std::vector<std::vector<std::string>> files;
    const CoverageTotals totals = totals_of(coverage.files);
    const CoverageTotals host = host_totals_of(coverage.files);
    for (const auto& file : coverage.files) {
        files.push_back({fmt::format("<code>{}</code>", escaped(file.file)), cell(file.line_count()),
                         cell(file.branches), cell(file.conditions)});
    }
    files.insert(files.begin(),
                 {"<b>all firmware</b>", cell(totals.lines), cell(totals.branches), cell(totals.conditions)});
    if (host.lines.total != 0) {
        files.insert(files.begin() + 1, {"<b>the host's buses and replay</b>", cell(host.lines), cell(host.branches),
                                         cell(host.conditions)});
    }
    std::vector<std::vector<std::string>> gaps;
    for (const auto& [gap, reason] : coverage.verdict.gaps) {
        gaps.push_back({fmt::format("<code>{}:{}</code>", escaped(gap.file), gap.line), gap.kind,
                        fmt::format("<code>{}</code><br><small>{}</small>", escaped(gap.code), escaped(gap.missing)),
                        reason.empty() ? html_state("open") : prose(reason)});
    }
    return "<p>Lines, branches (each outcome counts) and conditions shown to decide alone (MC/DC), from unit and "
           "conformance "
           "tests, properties and the corpora of the fuzz targets.</p>\n" +
           html_table("Coverage by file", {{"File"}, {"Lines"}, {"Branches"}, {"MC/DC"}}, files, Search::yes) +
           "<h2>Places that no test reaches</h2><p>Each place has a reason or is open.</p>\n" +
           html_table("Places that no test reaches", {{"Place", 24}, {"Kind", 8}, {"Code", 28}, {"Reason"}}, gaps,
                      Search::yes);
}

}  // namespace canproof::host
