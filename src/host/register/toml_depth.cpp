// SPDX-License-Identifier: Apache-2.0
#include "host/register/toml_depth.hpp"

#include <algorithm>

namespace canproof::host {

namespace {

/// Scans a TOML text once, and counts the open brackets and the parts of each dotted key. Ignores strings and comments.
class DepthScan {
  public:
    explicit DepthScan(const std::string& text) : text_{text} {}

    std::optional<unsigned> run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (c == '"' || c == '\'') {
                skip_string(c);
                continue;
            }
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
                continue;
            }
            take(c);
            if (parts_ > deepest_toml || brackets_ > deepest_toml) {
                return line_;
            }
            ++at_;
        }
        return std::nullopt;
    }

  private:
    void take(char c) {
        if (c == '.') {
            ++parts_;
        } else if (c == '\n') {
            ++line_;
            parts_ = 1;
        } else if (c == '[' || c == '{') {
            ++brackets_;
            parts_ = 1;
        } else if (c == ']' || c == '}') {
            brackets_ -= brackets_ > 0 ? 1U : 0U;
            parts_ = 1;
        } else if (c == '=' || c == ',') {
            parts_ = 1;
        }
    }

    /// Skips a string. One quote opens a string on one line; three quotes open a string on several lines. A backslash
    /// escapes the next character in "…" strings only.
    void skip_string(char quote) {
        const std::string three(3, quote);
        const bool many = text_.compare(at_, 3, three) == 0;
        at_ += many ? 3U : 1U;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (many && text_.compare(at_, 3, three) == 0) {
                const std::size_t end = std::min(text_.find_first_not_of(quote, at_), text_.size());
                // the string may end with one or two quotes of its own, directly before the three closing quotes
                at_ += std::min<std::size_t>(end - at_, 5);
                return;
            }
            if (!many && (c == quote || c == '\n')) {
                at_ += c == quote ? 1U : 0U;
                return;
            }
            line_ += c == '\n' ? 1U : 0U;
            if (c == '\\' && quote == '"' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n') {
                ++at_;
            }
            ++at_;
        }
    }

    const std::string& text_;
    std::size_t at_{0};
    unsigned line_{1};
    unsigned parts_{1};
    unsigned brackets_{0};
};

}  // namespace

std::optional<unsigned> too_deep_in(const std::string& text) {
    return DepthScan{text}.run();
}

}  // namespace canproof::host
