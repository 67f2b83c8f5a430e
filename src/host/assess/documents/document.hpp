// A document that is generated from the register: plain text and tables, to be written as HTML, Markdown or JSON.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

struct DocumentTable {
    std::string caption;
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< cells are plain text, as many as the head has
};

struct Chapter {
    std::string title;
    std::vector<std::string> text;  ///< a paragraph each
    std::vector<DocumentTable> tables;
};

struct Document {
    std::string name;   ///< `safety-manual`: of the file, without its ending
    std::string title;  ///< `Safety manual of the CAN-CBX-AO412`
    std::string about;  ///< what a reader finds in it, in one sentence
    std::vector<Chapter> chapters;
};

/// What stands in a cell where the register has nothing.
inline constexpr const char* missing = "missing";

/// Cells that say `missing`.
std::size_t count_missing(const Document& document);

}  // namespace canproof::host
