// SPDX-License-Identifier: Apache-2.0
// The common frame of all pages of the pack. One style serves phones, dark mode and paper; there are no external
// assets.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct NavigationEntry {
    std::string page;
    std::string title;
};

/// The parts of a page around its body.
struct PageFrame {
    std::vector<NavigationEntry> navigation;  ///< empty when there are no other pages
    std::string origin;                       ///< plain text below the page and on each printed sheet; may be empty
};

/// Returns a complete HTML document. `body` is markup.
std::string html_page(const std::string& title, const std::string& own_page, const PageFrame& frame,
                      const std::string& body);

struct HtmlColumn {
    std::string title;
    int share{0};  ///< share of the width in per cent; 0: as wide as its text
};

enum class Search { no, yes };

/// Returns a table; on a phone each row becomes a list. Cells are markup. A column of numbers is right-aligned with
/// groups of three digits. A search field hides the rows that do not contain all of its words; without scripts, all
/// rows show. The caption is plain text.
std::string html_table(const std::vector<HtmlColumn>& head, const std::vector<std::vector<std::string>>& rows,
                       Search search = Search::no, const std::string& caption = "");

/// Returns `<span class=holds>✓ holds</span>` and so on.
std::string html_state(const std::string& word);

}  // namespace canproof::host
