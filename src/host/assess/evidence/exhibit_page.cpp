// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/exhibit_page.hpp"

#include <fmt/format.h>

#include <sstream>

#include "host/assess/evidence/exhibit.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

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

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::string exhibit_page(const Exhibit& exhibit) {
    std::string text = fmt::format("<p>{} {}</p>\n", html_state(word_of(exhibit.state)), escaped(exhibit.says));
    if (!exhibit.figures.empty()) {
        std::vector<std::vector<std::string>> rows;
        for (const auto& [name, value] : exhibit.figures) {
            rows.push_back({escaped(name), escaped(value)});
        }
        text += html_table("Figures: " + exhibit.title, {{"Figure", 50}, {"Value"}}, rows);
    }
    if (!exhibit.open.empty()) {
        text += "<h2>Open</h2>\n<ul>";
        for (const auto& sentence : exhibit.open) {
            text += fmt::format("<li>{}\n", escaped(sentence));
        }
        text += "</ul>\n";
    }
    for (const auto& [path, bytes] : exhibit.files) {
        text += fmt::format("<h2><a href=\"{0}\">{1}</a></h2>\n", escaped(path),
                            escaped(std::filesystem::path{path}.filename().string()));
        if (ends_with(path, ".csv")) {
            text += csv_table(std::filesystem::path{path}.filename().string(), bytes);
        } else if (ends_with(path, ".svg")) {
            text += fmt::format("<figure><img src=\"{}\" alt=\"Plot of the figures of {}\"></figure>\n", escaped(path),
                                escaped(exhibit.title));
        }
    }
    return text;
}

}  // namespace canproof::host
