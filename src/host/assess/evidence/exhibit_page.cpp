// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/exhibit_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "host/assess/evidence/exhibit.hpp"
#include "host/report/markup.hpp"

namespace canproof::host {

namespace {

/// Returns the fields of one CSV line, escaped for HTML. A field in quotes may contain commas, but no line break. Two
/// quotes in such a field stand for one quote (RFC 4180).
std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields{""};
    bool quoted = false;
    char before = ',';
    for (const char one : line) {
        const bool is_second_quote = one == '"' && before == '"' && !quoted;
        before = is_second_quote ? '\0' : one;
        if (is_second_quote) {
            fields.back() += one;
            quoted = true;
        } else if (one == '"') {
            quoted = !quoted;
        } else if (one == ',' && !quoted) {
            fields.emplace_back();
        } else if (one != '\r') {
            fields.back() += one;
        }
    }
    for (auto& field : fields) {
        field = escaped(field);
    }
    return fields;
}

std::string csv_table(const std::string& caption, const std::string& text) {
    std::istringstream lines{text};
    std::string line;
    std::getline(lines, line);
    std::vector<HtmlColumn> head;
    for (auto& title : fields_of(line)) {
        head.push_back({title});
    }
    std::vector<std::vector<std::string>> rows;
    while (std::getline(lines, line)) {
        rows.push_back(fields_of(line));
        rows.back().resize(head.size());
    }
    return html_table(caption, head, rows, rows.size() > 20 ? Search::yes : Search::no);
}

struct Drawing {
    std::string title;
    std::string words;  ///< description for readers who do not see the drawing
};

/// Returns title and label of an SVG file. A drawing without them gets the title of its exhibit (the result of a tool).
Drawing drawing_in(const std::string& svg, const std::string& exhibit) {
    pugi::xml_document document;
    document.load_string(svg.c_str());
    const pugi::xml_node drawn = document.child("svg");
    const std::string title = drawn.child_value("title");
    const std::string label = drawn.attribute("aria-label").value();
    return {title.empty() ? exhibit : title, !label.empty() ? label : "Plot of the figures of " + exhibit};
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string open_points(const Exhibit& exhibit) {
    if (exhibit.open.empty()) {
        return "";
    }
    std::string text = "<h2>Open</h2>\n<ul>";
    for (const auto& sentence : exhibit.open) {
        text += fmt::format("<li>{}\n", prose(sentence));
    }
    return text + "</ul>\n";
}

}  // namespace

std::string exhibit_page(const Exhibit& exhibit) {
    std::string text = fmt::format("<p>{} {}</p>\n", html_state(word_of(exhibit.state)), prose(exhibit.says));
    if (!exhibit.figures.empty()) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& [name, value] : exhibit.figures) {
            rows.push_back({escaped(name), escaped(value)});
        }
        text += html_table("Figures: " + exhibit.title, {{"Figure", 50}, {"Value"}}, rows);
    }
    text += open_points(exhibit);
    for (const auto& [path, bytes] : exhibit.files) {
        text += fmt::format("<h2><a href=\"{0}\">{1}</a></h2>\n", escaped(path),
                            escaped(std::filesystem::path{path}.filename().string()));
        if (ends_with(path, ".csv")) {
            text += csv_table(std::filesystem::path{path}.filename().string(), bytes);
        } else if (ends_with(path, ".svg")) {
            const Drawing drawing = drawing_in(bytes, exhibit.title);
            text += html_figure(fmt::format("<img src=\"{}\" alt=\"{}\">", escaped(path), escaped(drawing.words)),
                                drawing.title);
        }
    }
    return text;
}

std::string framed_page(const Exhibit& exhibit, const PageFrame& frame) {
    const std::string& page = exhibit.files.at(exhibit.page);
    const std::string begins = "<main>";
    const auto begin = page.find(begins);
    const auto end = page.rfind("</main>");
    if (begin == std::string::npos || end == std::string::npos || end < begin) {
        return page;
    }
    std::string body = page.substr(begin + begins.size(), end - begin - begins.size());
    const std::string heading_ends = "</h1>";
    if (const auto heading = body.find(heading_ends); heading != std::string::npos) {
        body.erase(0, heading + heading_ends.size());
    }
    std::string way_back;
    for (auto depth = std::count(exhibit.page.begin(), exhibit.page.end(), '/'); depth > 0; --depth) {
        way_back += "../";
    }
    // the relative links in the body start from the exhibit's folder, so the page must not have a <base> element
    PageFrame own{frame.navigation, frame.origin};
    for (auto& entry : own.navigation) {
        entry.page.insert(0, way_back);
    }
    return html_page(exhibit.title, way_back + exhibit.page, own,
                     fmt::format("<p>{}</p>\n{}{}", html_state(word_of(exhibit.state)), open_points(exhibit), body));
}

}  // namespace canproof::host
