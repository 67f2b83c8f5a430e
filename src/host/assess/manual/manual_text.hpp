// SPDX-License-Identifier: Apache-2.0
// The text of a manual in the form from which passage marks (hashes of passages) are computed: its ASCII letters and
// digits with their positions.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

class ManualText {
  public:
    explicit ManualText(const std::string& text);

    const std::vector<std::string>& lines() const { return lines_; }
    /// Returns the letters and digits of all lines in lower case.
    const std::string& letters() const { return letters_; }
    /// Returns the positions at which words begin, ascending. A word begins at the start of a line or after a character
    /// that is neither a letter nor a digit.
    const std::vector<std::size_t>& word_begins() const { return word_begins_; }
    /// Returns whether a word ends before this position.
    bool is_word_end(std::size_t at) const { return word_end_[at]; }
    /// Returns the position of the line's first letter or digit. end_of() returns the position after its last one.
    /// Lines count from 0.
    std::size_t begin_of(std::size_t line) const { return line_begins_[line]; }
    std::size_t end_of(std::size_t line) const { return line_begins_[line + 1]; }

  private:
    std::vector<std::string> lines_;
    std::string letters_;
    std::vector<std::size_t> word_begins_;
    std::vector<bool> word_end_;  ///< whether a word ends before each position; the last element is for the end of the
                                  ///< text
    std::vector<std::size_t> line_begins_;
};

/// Returns the line without leading `#`, `*`, `<b>` and spaces.
std::string without_markup(const std::string& line);

}  // namespace canproof::host
