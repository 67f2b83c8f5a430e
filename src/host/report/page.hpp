// The frame of each page of the pack: one style, readable on a phone, in the dark and on paper; no external assets.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct NavigationEntry {
    std::string page;
    std::string title;
};

/// What stands around the body of each page.
struct PageFrame {
    std::vector<NavigationEntry> navigation;  ///< none without pages to go to
    std::string origin;                       ///< plain text below the page and on each printed sheet; may be empty
};

/// A whole HTML document. `body` is markup.
std::string html_page(const std::string& title, const std::string& own_page, const PageFrame& frame,
                      const std::string& body);

struct HtmlColumn {
    std::string title;
    int share{0};  ///< of the width, in per cent; 0: as wide as its text
};

enum class Search { no, yes };

/// A table; on a phone each row becomes a list. Cells are markup; a column of numbers stands right, in groups of three.
/// With a search field above it, rows that do not hold all of its words are hidden; all rows show where there are no
/// scripts. A caption is plain text.
std::string html_table(const std::vector<HtmlColumn>& head, const std::vector<std::vector<std::string>>& rows,
                       Search search = Search::no, const std::string& caption = "");

/// `<span class=holds>✓ holds</span>` and so on.
std::string html_state(const std::string& word);

}  // namespace canproof::host
