// SPDX-License-Identifier: Apache-2.0
// One line of a case, read from left to right.
#pragma once

#include <cstddef>
#include <string>

#include "host/register/fault.hpp"

namespace canproof::host::conform {

/// A line that is not a valid step. The fault contains the place, the problem and its fix.
class LanguageError {
  public:
    explicit LanguageError(Fault of) : fault{std::move(of)} {}
    Fault fault;
};

class Scanner {
  public:
    Scanner(std::string line, Place place) : line_{std::move(line)}, place_{std::move(place)} {}

    bool at_end();
    /// Returns the next character that is not a blank; 0 at the end.
    char peek();
    /// Skips `text` if the rest begins with it. Returns whether it did.
    bool take(const std::string& text);
    /// Does the same for one character, without skipping blanks before it.
    bool take_close(char c);
    /// Skips a whole word if the rest begins with it: no letter, digit or `_` follows the word. Returns whether it did.
    bool take_word(const std::string& word);
    /// Returns whether the rest begins with `text`.
    bool sees(const std::string& text);
    bool sees_word(const std::string& word);
    /// Skips `text`; fails when the rest does not begin with it.
    void want(const std::string& text, const std::string& fix);
    /// Reads the letters, digits and `_` that follow; with `dashes` also `-` inside. Empty when there are none.
    std::string word(bool dashes = false);
    /// Reads up to the next blank; empty at the end. peek_token() returns the same without moving on.
    std::string token();
    std::string peek_token();
    /// Reads the text between double quotes. Fails when there is none.
    std::string quoted();
    /// Reads up to `end` and skips it; up to the end of the line if `end` is empty.
    std::string up_to(const std::string& end);
    std::string rest() { return up_to(""); }
    /// Fails unless the line is at its end.
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
