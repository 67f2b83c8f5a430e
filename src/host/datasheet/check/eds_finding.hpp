// SPDX-License-Identifier: Apache-2.0
// The findings of a data sheet check.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace canproof::host {

enum class EdsSeverity {
    warning,  ///< tools accept the sheet, but its content is doubtful
    error     ///< the sheet violates CiA 306 or CiA 301, or contradicts itself
};

/// Returns `error` or `warning`.
const char* to_text(EdsSeverity severity);

struct EdsRule {
    const char* id;        ///< made of lower-case letters and dashes
    EdsSeverity severity;  ///< severity of all findings of this rule
    const char* what;      ///< general description of the fault
    const char* fix;       ///< remedy
    const char* source;    ///< section of the CiA document that the fault violates
};

/// A change of one line that belongs to the fix of a finding. The change does not alter the meaning of the sheet.
struct EdsEdit {
    enum class Kind { replace, insert_after, erase, crlf } kind{Kind::replace};
    unsigned line{0};  ///< line number from 1
    /// for replace and insert_after: the new text, which may have several lines but no final line break
    std::string text;
};

/// The edits of one fix. Several findings can share one fix, for example all findings about the lists of objects.
using EdsEdits = std::shared_ptr<const std::vector<EdsEdit>>;

struct EdsFinding {
    EdsRule rule{};
    unsigned line{0};      ///< line number from 1
    std::string what;      ///< description of this fault
    std::string fix;       ///< remedy
    EdsEdits edits;        ///< edits of the automatic fix; nullptr: there is none, so a person must decide
    std::size_t order{0};  ///< number of findings before this one; orders the findings of one line

    bool is_fixable() const { return edits != nullptr; }
};

}  // namespace canproof::host
