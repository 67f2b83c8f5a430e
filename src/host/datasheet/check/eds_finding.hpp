// What a check of a data sheet finds.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace canproof::host {

enum class EdsSeverity {
    warning,  ///< tools take the sheet, but it says something doubtful
    error     ///< the sheet is against CiA 306 or CiA 301, or contradicts itself
};

/// `error` or `warning`.
const char* to_text(EdsSeverity severity);

struct EdsRule {
    const char* id;        ///< small letters and dashes
    EdsSeverity severity;  ///< of each finding
    const char* what;      ///< what is wrong, in general
    const char* fix;       ///< what to do about it
    const char* source;    ///< which part of CiA 301 or CiA 306 asks for it
};

/// A change of one line that fixes a finding without a change of meaning.
struct EdsEdit {
    enum class Kind { replace, insert_after, erase, crlf } kind{Kind::replace};
    unsigned line{0};  ///< from 1
    std::string text;  ///< of replace and insert_after; without an end of line, may hold several lines
};

/// The edits of one fix; several findings may share them, as those of a list do.
using EdsEdits = std::shared_ptr<const std::vector<EdsEdit>>;

struct EdsFinding {
    EdsRule rule{};
    unsigned line{0};      ///< from 1
    std::string what;      ///< what is wrong here
    std::string fix;       ///< what to do about it
    EdsEdits edits;        ///< the safe fix; nullptr: a person must decide
    std::size_t order{0};  ///< among the findings of a line

    bool is_fixable() const { return edits != nullptr; }
};

}  // namespace canproof::host
