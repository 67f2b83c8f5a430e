// The text of a manual as marks see it: its ASCII letters and digits, and where they stand.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace canproof::host {

class ManualText {
  public:
    explicit ManualText(const std::string& text);

    const std::vector<std::string>& lines() const { return lines_; }
    /// The letters and digits of all lines, in lower case.
    const std::string& letters() const { return letters_; }
    /// Where words begin in it, ascending: a word follows the begin of the text or a character that is no letter or
    /// digit.
    const std::vector<std::size_t>& word_begins() const { return word_begins_; }
    /// Whether a word ends before this position.
    bool is_word_end(std::size_t at) const { return word_end_[at]; }
    /// Positions of the letters and digits of a line, which counts from 0: [first, last).
    std::size_t begin_of(std::size_t line) const { return line_begins_[line]; }
    std::size_t end_of(std::size_t line) const { return line_begins_[line + 1]; }

  private:
    std::vector<std::string> lines_;
    std::string letters_;
    std::vector<std::size_t> word_begins_;
    std::vector<bool> word_end_;  ///< one more than letters and digits
    std::vector<std::size_t> line_begins_;
};

/// The line without `#`, `*`, `<b>` and spaces in front.
std::string without_markup(const std::string& line);

}  // namespace canproof::host
