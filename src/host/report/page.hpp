// SPDX-License-Identifier: Apache-2.0
// The common frame of all pages of the evidence pack. One style sheet serves phones, dark mode and paper. The pages
// load no external files.
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
    std::vector<NavigationEntry> navigation;  ///< links to the other pages; empty when there are none
    std::string origin;                       ///< plain text below the page and on each printed sheet; may be empty
    std::string way_back{};  ///< path from the page to the folder of the evidence pack, such as `../`; links are
                             ///< relative to this folder
};

/// Returns a complete HTML document. `body` is markup. The navigation marks `own_page`, which is this page or the page
/// that links to it. If `frame.origin` is not empty, each printed sheet shows the title, the origin and the number of
/// the sheet.
std::string html_page(const std::string& title, const std::string& own_page, const PageFrame& frame,
                      const std::string& body);

struct HtmlColumn {
    std::string title;
    int share{0};  ///< share of the table's width in per cent; 0: as wide as its text
};

enum class Search { no, yes };

/// Returns a table as markup. The cells are markup. The caption is plain text. If a heading is directly above the
/// table, only screen readers present the caption. Numbers in a column of numbers are right-aligned, in groups of three
/// digits. A search field hides the rows that do not contain all of its words; without scripts, all rows show. On a
/// phone, each row becomes a list. A search field inside an element of class `filtered` searches all tables of that
/// element; see html_filter().
std::string html_table(const std::string& caption, const std::vector<HtmlColumn>& head,
                       const std::vector<std::vector<std::string>>& rows, Search search = Search::no);

/// Returns a figure as markup. `drawing` is markup; the caption below it is plain text.
std::string html_figure(const std::string& drawing, const std::string& caption);

/// A list of words, one of which the reader may choose.
struct HtmlChoice {
    std::string title;
    /// CSS selector of a part of a row; a row matches when the text of this part ends with the chosen word
    std::string of;
    std::vector<std::string> words;
};

/// Returns a search field and lists to choose from. Inside an element of class `filtered` they hide each row of its
/// tables that lacks a searched or a chosen word, and each `<details>` without a visible row.
std::string html_filter(const std::vector<HtmlChoice>& choices);

/// Returns the markup with a symbol before it, for readers who cannot see colours: `<span class=holds>✓ 7 of 9</span>`
/// when `good`, otherwise `<span class=open>✗ …`.
std::string html_judged(bool good, const std::string& markup);

/// Returns the word of a state as markup with its symbol: `<span class=holds>✓ holds</span>` and so on.
std::string html_state(const std::string& word);

}  // namespace canproof::host
