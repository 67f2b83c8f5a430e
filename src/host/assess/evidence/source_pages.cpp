// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/source_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "host/assess/evidence/item_links.hpp"
#include "host/base/read_file.hpp"
#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

/// The ids of the items that a line of a source implements or tests, by the place of the line:
/// `src/firmware/canopen/node.cpp:12`.
using ItemsByPlace = std::map<std::string, std::set<std::string>>;

ItemsByPlace items_by_place(const Evidence& evidence) {
    ItemsByPlace items;
    for (const auto& [id, places] : evidence.implemented) {
        for (const auto& place : places) {
            items[place].insert(id);
        }
    }
    for (const auto& [id, verdicts] : evidence.verdicts) {
        for (const auto& verdict : verdicts) {
            items[fmt::format("{}:{}", verdict.file, verdict.line)].insert(id);
        }
    }
    return items;
}

std::string page_of(const std::string& file) {
    return "source/" + file + ".html";
}

/// Returns the relative path from the page to the pack's folder: `../` for each folder in the page's name.
std::string way_back_from(const std::string& page) {
    std::string way;
    for (auto depth = std::count(page.begin(), page.end(), '/'); depth > 0; --depth) {
        way += "../";
    }
    return way;
}

/// Returns the lines of a source as markup, each with the items that the line implements or tests.
std::string lines_markup(const std::string& file, const std::string& text, const ItemsByPlace& items,
                         const ItemLinks& links) {
    std::string markup;
    std::istringstream lines{text};
    std::string line;
    for (unsigned number = 1; std::getline(lines, line); ++number) {
        markup += fmt::format("<li id=L{}><code>{}</code>", number, escaped(line));
        if (const auto found = items.find(fmt::format("{}:{}", file, number)); found != items.end()) {
            markup += " " + link_to_each(links, {found->second.begin(), found->second.end()});
        }
        markup += "\n";
    }
    return markup;
}

}  // namespace

std::map<std::string, std::string> sources_named_by(const Evidence& evidence, const std::filesystem::path& root) {
    std::set<std::string> names;
    for (const auto* links : {&evidence.implemented, &evidence.used}) {
        for (const auto& [id, places] : *links) {
            for (const auto& place : places) {
                names.insert(place.substr(0, place.find(':')));
            }
        }
    }
    for (const auto& [id, verdicts] : evidence.verdicts) {
        for (const auto& verdict : verdicts) {
            names.insert(verdict.file);
        }
    }
    std::map<std::string, std::string> sources;
    for (const auto& name : names) {
        if (!name.empty() && std::filesystem::is_regular_file(root / name)) {
            sources[name] = read_file(root / name);
        }
    }
    return sources;
}

std::string source_link(const PackInput& input, const std::string& file, const unsigned line) {
    if (input.sources.count(file) == 0) {
        return "";
    }
    return line == 0 ? page_of(file) : fmt::format("{}#L{}", page_of(file), line);
}

std::map<std::string, std::string> source_pages(const PackInput& input, const PageFrame& frame) {
    const ItemsByPlace items = items_by_place(input.evidence);
    const ItemLinks links = links_of(input);
    std::map<std::string, std::string> pages;
    for (const auto& [file, text] : input.sources) {
        const std::string page = page_of(file);
        const std::string body = lines_markup(file, text, items, links);
        pages[page] = html_page(file, "audit.html", {frame.navigation, frame.origin, way_back_from(page)},
                                "<ol class=source>\n" + body + "</ol>\n");
    }
    return pages;
}

}  // namespace canproof::host
