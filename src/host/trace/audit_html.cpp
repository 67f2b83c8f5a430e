#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/plot/markup.hpp"
#include "host/trace/audit.hpp"

namespace canproof::host {

namespace {

const char* const head =
    R"(<!doctype html><html lang="en"><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>canproof audit</title><style>
:root{color-scheme:light dark}body{font:15px/1.5 system-ui,sans-serif;max-width:72rem;margin:2rem auto;padding:0 1rem}
h1,h2{line-height:1.2}table{border-collapse:collapse;width:100%;font-size:.9em}th,td{text-align:left;vertical-align:top;padding:.3rem .5rem;border-bottom:1px solid #8884}
code{font-size:.92em}.open{color:#c22}.shown{color:#283}.wrap{overflow-x:auto}small{opacity:.75}
.items{min-width:60rem;table-layout:fixed}.items td{overflow-wrap:anywhere}.items th:nth-child(1){width:15%}.items th:nth-child(2){width:36%}.items th:nth-child(3){width:18%}.items th:nth-child(5){width:6rem}
figure{margin:1rem 0}figure img{width:100%;background:#fff}
@media(prefers-color-scheme:dark){.open{color:#f77}.shown{color:#7c7}}@media print{body{max-width:none}}
</style>
)";

std::string tests_of(const std::string& id, const Evidence& evidence) {
    const auto found = evidence.verdicts.find(id);
    std::string text;
    if (found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            text += fmt::format("<span class={}>{} {}</span> <small>{}</small><br>", verdict.passed ? "shown" : "open",
                                verdict.passed ? "✓" : "✗", escaped(verdict.test), verdict.kind);
        }
    }
    return text;
}

std::string item_row(const AuditedItem& audited, const Evidence& evidence) {
    const Item& item = *audited.item;
    const auto code = evidence.implemented.find(item.id);
    const bool open = audited.failed || !audited.missing.empty();
    return fmt::format(
        "<tr id=\"{0}\"><td><code>{0}</code><br><small>{1}</small><td>{2}<br><small>{3}</small><td>{4}<td>{5}<td "
        "class={6}>{7}\n",
        item.id, audited.word, escaped(item.text), escaped(fmt::format("{}", fmt::join(item.sources, ", "))),
        code == evidence.implemented.end() ? "" : escaped(fmt::format("{}", fmt::join(code->second, ", "))),
        tests_of(item.id, evidence), open ? "open" : "shown", open ? "open" : "shown");
}

std::string decision_row(const Decision& decision) {
    std::string readings;
    for (const auto& reading : decision.readings) {
        readings += fmt::format("{} <small>{}</small><br>", escaped(reading.says), escaped(reading.source));
    }
    return fmt::format(
        "<tr id=\"{0}\"><td><code>{0}</code><br><small>{1} {2}</small><td>{3}<td>{4}<td><b>{5}</b><br>{6}\n",
        decision.id, decision.severity, escaped(decision.ref), escaped(decision.text), readings,
        escaped(decision.chosen), escaped(decision.because));
}

/// The plots of a device: files that begin with its name.
std::string figures_of(const std::string& device, const std::vector<std::string>& figures) {
    std::string text;
    for (const auto& figure : figures) {
        if (figure.rfind(device + "-", 0) == 0) {
            text += fmt::format("<figure><img src=\"{0}\" alt=\"{0}\" loading=lazy></figure>\n", escaped(figure));
        }
    }
    return text;
}

std::string part_section(const PartAudit& audit, const Evidence& evidence, const std::vector<std::string>& figures) {
    std::string text = fmt::format("<h2 id=\"{0}\">{0}</h2>\n", audit.part->name);
    const auto shown = std::count_if(audit.items.begin(), audit.items.end(),
                                     [](const AuditedItem& one) { return !one.failed && one.missing.empty(); });
    text +=
        fmt::format("<p>{} of {} items shown, {} normative sections, {} decisions, <b class={}>{} gap(s)</b>.</p>\n",
                    shown, audit.items.size(), audit.sections.size(), audit.part->decisions.size(),
                    audit.gaps.empty() ? "shown" : "open", audit.gaps.size());
    if (!audit.gaps.empty()) {
        text += "<details open><summary>Gaps</summary><ul>\n";
        for (const auto& gap : audit.gaps) {
            text += fmt::format("<li>{}\n", escaped(gap));
        }
        text += "</ul></details>\n";
    }
    text += figures_of(audit.part->name, figures);
    text += "<div class=wrap><table class=items><tr><th>Item<th>Says<th>Code<th>Tests<th>\n";
    for (const auto& item : audit.items) {
        text += item_row(item, evidence);
    }
    text += "</table></div>\n<h3>Sections</h3><div class=wrap><table><tr><th>Section<th>Covered by\n";
    for (const auto& section : audit.sections) {
        text += fmt::format(
            "<tr><td>{} <small>{}</small><td>{}\n", escaped(section.section->ref), escaped(section.section->title),
            section.covered_by.empty() ? "<span class=open>nothing</span>"
                                       : escaped(fmt::format("{}", fmt::join(section.covered_by, ", "))));
    }
    text +=
        "</table></div>\n<h3>Decisions</h3><div class=wrap><table><tr><th>Decision<th>Question<th>Readings<th>Chosen, "
        "because\n";
    for (const auto& decision : audit.part->decisions) {
        text += decision_row(decision);
    }
    return text + "</table></div>\n";
}

}  // namespace

std::string write_audit_html(const std::vector<PartAudit>& audits, const Evidence& evidence,
                             const std::vector<std::string>& figures, const std::string& more) {
    std::string text = head;
    std::size_t gaps = 0;
    for (const auto& audit : audits) {
        gaps += audit.gaps.size();
    }
    text += fmt::format(
        "<h1>canproof audit</h1><p>What the register claims, what shows it in this build, what is open: {} tests, {} "
        "failed, "
        "<b class={}>{} gap(s)</b>.</p>\n",
        evidence.tests, evidence.failed, gaps == 0 ? "shown" : "open", gaps);
    if (std::find(figures.begin(), figures.end(), misra_page) != figures.end()) {
        text += fmt::format(
            "<p><a href=\"{}\">MISRA C++:2023</a>: the firmware's guidelines, how each is checked, what is open.</p>\n",
            misra_page);
    }
    text += "<div class=wrap><table><tr><th>Part<th>Items<th>Gaps\n";
    for (const auto& audit : audits) {
        text += fmt::format("<tr><td><a href=\"#{0}\">{0}</a><td>{1}<td>{2}\n", audit.part->name, audit.items.size(),
                            audit.gaps.size());
    }
    text += "</table></div>\n";
    for (const auto& audit : audits) {
        text += part_section(audit, evidence, figures);
    }
    return text + more + "</html>\n";
}

}  // namespace canproof::host
