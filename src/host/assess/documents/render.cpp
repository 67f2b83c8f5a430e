// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/render.hpp"

#include <fmt/format.h>

#include <cctype>
#include <nlohmann/json.hpp>

#include "host/base/one_line.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t searched = 20;  ///< number of rows; a table with more rows gets a search field

bool stands_in_id(const char c) {
    return std::isupper(static_cast<unsigned char>(c)) != 0 || std::isdigit(static_cast<unsigned char>(c)) != 0 ||
           c == '-';
}

/// Returns the escaped text in which each id of `links` is a link. `text` must not contain backticks.
std::string linked_plain(const std::string& text, const ItemLinks& links) {
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && stands_in_id(text[end])) {
            ++end;
        }
        if (end == at) {
            end = at + 1;
            while (end < text.size() && !stands_in_id(text[end])) {
                ++end;
            }
        }
        const std::string word = text.substr(at, end - at);
        const auto link = links.find(word);
        out += link == links.end() ? escaped(word)
                                   : fmt::format("<a href=\"{}\">{}</a>", escaped(link->second), escaped(word));
        at = end;
    }
    return out;
}

/// Returns the text as markup in which each id of `links` outside of backticks is a link.
std::string linked(const std::string& text, const ItemLinks& links) {
    return prose(text, [&links](const std::string& plain) { return linked_plain(plain, links); });
}

std::string cell_html(const std::string& text, const ItemLinks& links) {
    return text == missing ? fmt::format("<span class=open>{}</span>", missing) : linked(text, links);
}

/// Returns a table as HTML, or a sentence when the table has no rows. A table without a caption gets the title of its
/// chapter.
std::string table_html(const DocumentTable& table, const std::string& chapter, const ItemLinks& links) {
    const std::string caption = table.caption.empty() ? chapter : table.caption;
    if (table.rows.empty()) {
        return fmt::format("<p>{}: none.</p>\n", escaped(caption));
    }
    std::vector<HtmlColumn> head;
    for (const auto& title : table.head) {
        head.push_back({escaped(title)});
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : table.rows) {
        auto& cells = rows.emplace_back();
        for (const auto& cell : row) {
            cells.push_back(cell_html(cell, links));
        }
    }
    const std::string text = html_table(caption, head, rows, rows.size() > searched ? Search::yes : Search::no);
    // the style sheet hides a caption directly below the chapter's heading, so a caption equal to the heading is not
    // shown twice
    return caption == chapter ? text : "<div>" + text + "</div>\n";
}

/// Returns the text for a cell of a Markdown table, without line breaks and with each `|` escaped.
std::string markdown_cell(const std::string& text) {
    std::string out;
    for (const char c : one_line(text)) {
        out += c == '|' ? std::string{"\\|"} : std::string{c};
    }
    return out;
}

std::string markdown_row(const std::vector<std::string>& cells) {
    std::string text = "|";
    for (const auto& cell : cells) {
        text += " " + markdown_cell(cell) + " |";
    }
    return text + "\n";
}

}  // namespace

std::string document_html(const Document& document, const ItemLinks& links) {
    std::string text = fmt::format("<p>{}</p>\n", linked(document.about, links));
    for (const auto& chapter : document.chapters) {
        text += fmt::format("<h2>{}</h2>\n", escaped(chapter.title));
        for (const auto& paragraph : chapter.text) {
            text += fmt::format("<p>{}</p>\n", linked(paragraph, links));
        }
        for (const auto& table : chapter.tables) {
            text += table_html(table, chapter.title, links);
        }
    }
    return text;
}

std::string document_markdown(const Document& document) {
    std::string text = fmt::format("# {}\n\n{}\n", document.title, document.about);
    for (const auto& chapter : document.chapters) {
        text += fmt::format("\n## {}\n", chapter.title);
        for (const auto& paragraph : chapter.text) {
            text += fmt::format("\n{}\n", paragraph);
        }
        for (const auto& table : chapter.tables) {
            const std::string caption = table.caption.empty() ? chapter.title : table.caption;
            if (table.rows.empty()) {
                text += fmt::format("\n{}: none.\n", caption);
                continue;
            }
            text += fmt::format("\n{}{}", caption == chapter.title ? "" : caption + "\n\n", markdown_row(table.head));
            text += markdown_row(std::vector<std::string>(table.head.size(), "---"));
            for (const auto& row : table.rows) {
                text += markdown_row(row);
            }
        }
    }
    return text;
}

std::string document_json(const Document& document) {
    using Json = nlohmann::ordered_json;
    Json chapters = Json::array();
    for (const auto& chapter : document.chapters) {
        Json tables = Json::array();
        for (const auto& table : chapter.tables) {
            Json rows = Json::array();
            for (const auto& row : table.rows) {
                Json one = Json::object();
                for (std::size_t at = 0; at < row.size(); ++at) {
                    one[table.head.at(at)] = row[at];
                }
                rows.push_back(one);
            }
            tables.push_back({{"caption", table.caption}, {"rows", rows}});
        }
        chapters.push_back({{"title", chapter.title}, {"text", chapter.text}, {"tables", tables}});
    }
    const Json json{
        {"name", document.name}, {"title", document.title}, {"about", document.about}, {"chapters", chapters}};
    return json.dump(2) + "\n";
}

}  // namespace canproof::host
