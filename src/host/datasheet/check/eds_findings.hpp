// SPDX-License-Identifier: Apache-2.0
// Collects the findings of a data sheet check.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

class EdsFindings {
  public:
    /// Keeps a reference to `rules`, which contains the rules by id.
    explicit EdsFindings(const std::map<std::string, EdsRule>& rules) : rules_{rules} {}

    /// Adds a finding of the rule with this id, unless there are Faults::most findings already. Throws
    /// std::out_of_range for an unknown rule.
    void add(const std::string& rule, unsigned line, std::string what, std::vector<EdsEdit> edits = {});
    void add(const std::string& rule, unsigned line, std::string what, EdsEdits edits);
    /// Returns the findings in ascending order of their lines, and empties this object.
    std::vector<EdsFinding> take();

  private:
    const std::map<std::string, EdsRule>& rules_;
    std::vector<EdsFinding> all_;
};

/// Returns an edit that replaces the line. The next two functions return an edit that inserts text after the line, and
/// an edit that erases the line.
inline std::vector<EdsEdit> replace_line(unsigned line, std::string text) {
    return {{EdsEdit::Kind::replace, line, std::move(text)}};
}
inline std::vector<EdsEdit> insert_after_line(unsigned line, std::string text) {
    return {{EdsEdit::Kind::insert_after, line, std::move(text)}};
}
inline std::vector<EdsEdit> erase_line(unsigned line) {
    return {{EdsEdit::Kind::erase, line, {}}};
}

}  // namespace canproof::host
