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
    const char* id;        ///< lower-case letters and dashes
    EdsSeverity severity;  ///< severity of each finding
    const char* what;      ///< description of the fault in general
    const char* fix;       ///< remedy
    const char* source;    ///< section of CiA 301 or CiA 306 that requires it
};

/// A change of one line that fixes a finding. The meaning of the sheet stays the same.
struct EdsEdit {
    enum class Kind { replace, insert_after, erase, crlf } kind{Kind::replace};
    unsigned line{0};  ///< counts from 1
    std::string text;  ///< text of a replace or insert_after: without a final line break, may contain several lines
};

/// The edits of one fix. Several findings can share them, for example those of a list.
using EdsEdits = std::shared_ptr<const std::vector<EdsEdit>>;

struct EdsFinding {
    EdsRule rule{};
    unsigned line{0};      ///< counts from 1
    std::string what;      ///< description of the fault in this place
    std::string fix;       ///< remedy
    EdsEdits edits;        ///< the safe fix; nullptr when a person must decide
    std::size_t order{0};  ///< position among the findings of a line

    bool is_fixable() const { return edits != nullptr; }
};

}  // namespace canproof::host
