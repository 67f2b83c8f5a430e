// SPDX-License-Identifier: Apache-2.0
// A generated document: plain text and tables, for output as HTML, Markdown or JSON.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct DocumentTable {
    std::string caption;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< plain text; each row has as many cells as `head`
};

struct Chapter {
    std::string title;
    std::vector<std::string> text;  ///< one element per paragraph
    std::vector<DocumentTable> tables;
};

struct Document {
    std::string name;   ///< name of the file without extension: `safety-manual`
    std::string title;  ///< `Safety manual of the CAN-CBX-AO412`
    std::string about;  ///< one sentence about the content
    std::vector<Chapter> chapters;
};

/// Text of a table cell for which neither the requirements register nor reports/analysis has data.
inline constexpr const char* missing = "missing";

/// Returns the number of cells with the text `missing`.
std::size_t count_missing(const Document& document);

}  // namespace canproof::host
