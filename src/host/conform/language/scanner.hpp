// SPDX-License-Identifier: Apache-2.0
// One line of a conformance case, read from left to right.
#pragma once

#include <cstddef>
#include <string>

#include "host/register/fault.hpp"

namespace canproof::host::conform {

/// Reports a line that is not a valid step. The fault contains the place, the problem and its fix.
class LanguageError {
  public:
    explicit LanguageError(Fault of) : fault{std::move(of)} {}
    Fault fault;
};

class Scanner {
  public:
    Scanner(std::string line, Place place) : line_{std::move(line)}, place_{std::move(place)} {}

    bool at_end();
    /// Skips blanks. Returns the next character without skipping it; 0 at the end of the line.
    char peek();
    /// Skips blanks and then `text`, if it follows. Returns whether it followed.
    bool take(const std::string& text);
    /// Skips the character `c` if it follows directly, without blanks before it. Returns whether it followed.
    bool take_close(char c);
    /// Skips the word if it follows as a whole, that is, no letter, digit or `_` comes after it. Returns whether it
    /// followed.
    bool take_word(const std::string& word);
    /// Returns whether `text` follows after blanks.
    bool sees(const std::string& text);
    bool sees_word(const std::string& word);
    /// Skips `text`. Throws LanguageError with `fix` when it does not follow.
    void want(const std::string& text, const std::string& fix);
    /// Reads the letters, digits and `_` that follow; with `dashes` also `-` between them. Returns an empty text when
    /// there are none.
    std::string word(bool dashes = false);
    /// Reads up to the next blank; returns an empty text at the end of the line. peek_token() returns the same text but
    /// does not skip it.
    std::string token();
    std::string peek_token();
    /// Reads the text between double quotes. Throws LanguageError when there is none.
    std::string quoted();
    /// Reads up to `end` and skips `end`. If `end` is empty, reads up to the end of the line. Throws LanguageError when
    /// `end` is missing.
    std::string up_to(const std::string& end);
    std::string rest() { return up_to(""); }
    /// Throws LanguageError unless the line is at its end.
    void finish();

    std::size_t position() const { return at_; }
    void go_back(std::size_t position) { at_ = position; }
    const Place& place() const { return place_; }
    const std::string& line() const { return line_; }

    [[noreturn]] void fail(const std::string& what, const std::string& fix) const;

  private:
    void skip_blanks();

    std::string line_;
    Place place_;
    std::size_t at_{0};
};

/// Returns whether a character may be part of a name: letters, digits, `_`.
bool is_name_character(char c);

}  // namespace canproof::host::conform
