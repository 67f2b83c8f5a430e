// One line of a case, read from left to right.
#pragma once

#include <cstddef>
#include <string>

#include "host/register/fault.hpp"

namespace canproof::host::conform {

/// A line that is no step. Says where, what and how to fix it.
class LanguageError {
  public:
    explicit LanguageError(Fault of) : fault{std::move(of)} {}
    Fault fault;
};

class Scanner {
  public:
    Scanner(std::string line, Place place) : line_{std::move(line)}, place_{std::move(place)} {}

    bool at_end();
    /// The next character that is no blank; 0 at the end.
    char peek();
    /// Whether the rest begins with `text`, which is then left behind.
    bool take(const std::string& text);
    /// The same without blanks before it.
    bool take_close(char c);
    /// take() for a word, behind which no letter, digit or `_` follows.
    bool take_word(const std::string& word);
    /// Whether the rest begins with `text`.
    bool sees(const std::string& text);
    bool sees_word(const std::string& word);
    /// Fails unless take(text).
    void want(const std::string& text, const std::string& mend);
    /// Letters, digits and `_` that follow; with `dashes` also `-` inside. Empty when there are none.
    std::string word(bool dashes = false);
    /// Everything up to the next blank; empty at the end. Does not move with peek_token().
    std::string token();
    std::string peek_token();
    /// What stands between double quotes. Fails when there are none.
    std::string quoted();
    /// Everything up to `end`, which is left behind; up to the end of the line for an empty one.
    std::string up_to(const std::string& end);
    std::string rest() { return up_to(""); }
    /// Fails when anything is left.
    void finish();

    std::size_t position() const { return at_; }
    void go_back(std::size_t position) { at_ = position; }
    const Place& place() const { return place_; }
    const std::string& line() const { return line_; }

    [[noreturn]] void fail(const std::string& what, const std::string& mend) const;

  private:
    void skip_blanks();

    std::string line_;
    Place place_;
    std::size_t at_{0};
};

/// Letters, digits, `_`: what may stand in a name.
bool is_name_character(char c);

}  // namespace canproof::host::conform
