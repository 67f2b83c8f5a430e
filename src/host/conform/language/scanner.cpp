// SPDX-License-Identifier: Apache-2.0
#include "host/conform/language/scanner.hpp"

#include <fmt/format.h>

#include <cctype>

namespace canproof::host::conform {

bool is_name_character(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

void Scanner::skip_blanks() {
    while (at_ < line_.size() && (line_[at_] == ' ' || line_[at_] == '\t')) {
        ++at_;
    }
}

bool Scanner::at_end() {
    skip_blanks();
    return at_ >= line_.size();
}

char Scanner::peek() {
    return at_end() ? '\0' : line_[at_];
}

bool Scanner::sees(const std::string& text) {
    skip_blanks();
    return line_.compare(at_, text.size(), text) == 0;
}

bool Scanner::sees_word(const std::string& word) {
    return sees(word) && (at_ + word.size() >= line_.size() || !is_name_character(line_[at_ + word.size()]));
}

bool Scanner::take(const std::string& text) {
    const bool found = sees(text);
    at_ += found ? text.size() : 0;
    return found;
}

bool Scanner::take_close(char c) {
    const bool found = at_ < line_.size() && line_[at_] == c;
    at_ += found ? 1 : 0;
    return found;
}

bool Scanner::take_word(const std::string& word) {
    const bool found = sees_word(word);
    at_ += found ? word.size() : 0;
    return found;
}

void Scanner::want(const std::string& text, const std::string& fix) {
    if (!take(text)) {
        fail(fmt::format("`{}` is missing before `{}`", text, up_to("")), fix);
    }
}

std::string Scanner::word(bool dashes) {
    skip_blanks();
    const std::size_t start = at_;
    while (at_ < line_.size() && (is_name_character(line_[at_]) || (dashes && line_[at_] == '-' && at_ > start))) {
        ++at_;
    }
    return line_.substr(start, at_ - start);
}

std::string Scanner::token() {
    skip_blanks();
    const std::size_t start = at_;
    while (at_ < line_.size() && line_[at_] != ' ' && line_[at_] != '\t') {
        ++at_;
    }
    return line_.substr(start, at_ - start);
}

std::string Scanner::peek_token() {
    const std::size_t before = at_;
    std::string found = token();
    at_ = before;
    return found;
}

std::string Scanner::quoted() {
    if (!take("\"")) {
        fail("a text in double quotes is missing", "write \"…\"");
    }
    const std::size_t end = line_.find('"', at_);
    if (end == std::string::npos) {
        fail("the text has no end", "close it with \"");
    }
    std::string text = line_.substr(at_, end - at_);
    at_ = end + 1;
    return text;
}

std::string Scanner::up_to(const std::string& end) {
    skip_blanks();
    const std::size_t found = end.empty() ? std::string::npos : line_.find(end, at_);
    if (!end.empty() && found == std::string::npos) {
        fail(fmt::format("`{}` is missing", end), fmt::format("add `{}` to the line", end));
    }
    std::string text = line_.substr(at_, found == std::string::npos ? found : found - at_);
    at_ = found == std::string::npos ? line_.size() : found + end.size();
    while (!text.empty() && text.back() == ' ') {
        text.pop_back();
    }
    return text;
}

void Scanner::finish() {
    if (!at_end()) {
        fail(fmt::format("`{}` is not expected here", rest()), "remove this text, or write it as a separate step");
    }
}

void Scanner::fail(const std::string& what, const std::string& fix) const {
    throw LanguageError{Fault{place_, fmt::format("{} (in `{}`)", what, line_), fix}};
}

}  // namespace canproof::host::conform
