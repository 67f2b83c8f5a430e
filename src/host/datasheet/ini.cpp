// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/ini.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <numeric>

namespace canproof::host {

namespace {

/// Bit n is set when the character n is a blank.
constexpr std::uint64_t blank_bits = [] {
    std::uint64_t bits = 0;
    for (const char c : ini_blanks) {
        bits |= std::uint64_t{1} << static_cast<unsigned char>(c);
    }
    return bits;
}();

constexpr bool is_blank(char c) {
    const auto u = static_cast<unsigned char>(c);
    return u <= ' ' && ((blank_bits >> u) & 1U) != 0;
}

std::string_view without_leading_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) {
        text.remove_prefix(1);
    }
    return text;
}

std::string_view without_trailing_blanks(std::string_view text) {
    while (!text.empty() && is_blank(text.back())) {
        text.remove_suffix(1);
    }
    return text;
}

/// Returns the text without blanks at its two ends.
std::string_view without_blanks(std::string_view text) {
    return without_trailing_blanks(without_leading_blanks(text));
}

/// Returns the place of the first `c` in the text from `at` on, or the length of the text.
std::size_t place_of_first(std::string_view text, char c, std::size_t at) {
    const void* const found = at < text.size() ? std::memchr(text.data() + at, c, text.size() - at) : nullptr;
    return found == nullptr ? text.size() : static_cast<std::size_t>(static_cast<const char*>(found) - text.data());
}

constexpr std::size_t usual_values = 8;  ///< usual number of keys of an entry; avoids repeated allocation

/// Compares a text in lower case with a text in any case. Returns a number below, equal to or above 0, as
/// std::string::compare() does.
int compare_lower(std::string_view lower, std::string_view text) {
    const std::size_t common = std::min(lower.size(), text.size());
    for (std::size_t i = 0; i < common; ++i) {
        const char c = lower_case(text[i]);
        if (lower[i] != c) {
            return static_cast<unsigned char>(lower[i]) < static_cast<unsigned char>(c) ? -1 : 1;
        }
    }
    return lower.size() < text.size() ? -1 : lower.size() > text.size() ? 1 : 0;
}

/// Sorts the values of sections; see IniFile::sort_values(). A data sheet has thousands of sections with the same keys
/// in the same order. So the order of the last section with the same number of values is tried first.
class SectionSorter {
  public:
    void sort(IniSection& section) {
        Order& order = section.values.size() < orders_.size() ? orders_[section.values.size()] : long_order_;
        if (!is_sorted_by(order, section.values)) {
            find_order(order, section.values);
            arrange(order, section.values);
            drop_repeated();
        }
        section.values.swap(sorted_);
    }
    std::vector<IniRepetition> take_repeated() { return std::move(repeated_); }

  private:
    using Value = std::pair<std::string_view, IniValue>;
    using Order = std::vector<std::size_t>;  ///< positions of the values before sorting, ascending by key

    static bool goes_before(const Value& a, const Value& b) {
        const auto first = [](const Value& one) {  // most keys differ in their first character
            return one.first.empty() ? 0 : static_cast<unsigned char>(one.first.front());
        };
        return first(a) != first(b) ? first(a) < first(b) : a.first < b.first;
    }
    bool is_sorted_by(const Order& order, const std::vector<Value>& values) {
        if (order.size() != values.size()) {
            return false;
        }
        arrange(order, values);
        return std::adjacent_find(sorted_.begin(), sorted_.end(),
                                  [](const Value& a, const Value& b) { return !goes_before(a, b); }) == sorted_.end();
    }
    static void find_order(Order& order, const std::vector<Value>& values) {
        order.resize(values.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::sort(order.begin(), order.end(), [&values](std::size_t a, std::size_t b) {
            return goes_before(values[a], values[b]) ||
                   (values[a].first == values[b].first && values[a].second.line < values[b].second.line);
        });
    }
    void arrange(const Order& order, const std::vector<Value>& values) {
        sorted_.clear();
        for (const std::size_t place : order) {
            sorted_.push_back(values[place]);
        }
    }
    void drop_repeated() {
        const auto same = [](const Value& a, const Value& b) { return a.first == b.first; };
        if (std::adjacent_find(sorted_.begin(), sorted_.end(), same) == sorted_.end()) {
            return;
        }
        std::vector<Value> kept;
        for (const Value& one : sorted_) {
            if (kept.empty() || !same(kept.back(), one)) {
                kept.push_back(one);
            } else {
                repeated_.push_back({one.first, kept.back().second.line, one.second.line});
            }
        }
        sorted_ = std::move(kept);
    }

    std::array<Order, 16> orders_;  ///< element n: order of the keys in the last section with n values
    Order long_order_;              ///< order of the keys in the last section with 16 or more values
    std::vector<Value> sorted_;
    std::vector<IniRepetition> repeated_;
};

class IniReader {
  public:
    IniReader(const std::string& text, const EdsTelling& tell)
        : tell_{tell}, written_{text}, text_{file_.texts.emplace_front(text)} {}

    void read_lines() {
        const bool marked = text_.rfind("\xEF\xBB\xBF", 0) == 0;  // UTF-8 byte order mark
        for (std::size_t at = marked ? 3 : 0; at < text_.size() && !is_strange();) {
            const std::size_t end = place_of_first(text_, '\n', at);
            read_line(std::string_view{text_}.substr(at, end - at));
            at = end + 1;
        }
    }
    bool is_strange() const { return strange_ > most_strange_lines; }
    IniFile take() {
        for (const IniRepetition& one : file_.sort_values()) {
            tell_.note(one.line, fmt::format("key {} is already in line {}", as_written(one.key), one.first),
                       "the first counts");
        }
        return std::move(file_);
    }

  private:
    void read_line(std::string_view raw) {
        ++line_;
        if (raw.size() > longest_ini_line) {
            strange(fmt::format("line has more than {} characters", longest_ini_line));
            return;
        }
        const std::string_view text = without_blanks(raw);
        if (text.empty() || text.front() == ';' || text.front() == '#') {
            return;
        }
        if (has_control(text)) {
            strange("line contains control characters");
        } else if (text.front() == '[') {
            open_section(text);
        } else {
            add_value(text);
        }
    }
    void strange(std::string what) {
        ++strange_;
        tell_.note(line_, std::move(what), "it is ignored");
    }

    void open_section(std::string_view text) {
        const auto close = text.find(']');
        const std::string_view name = close == std::string_view::npos ? "" : without_blanks(text.substr(1, close - 1));
        if (name.empty()) {
            ++strange_;
            tell_.note(line_, fmt::format("`{}` is no name of a section", text.substr(0, 40)),
                       "it is ignored with the lines below it");
            section_ = nullptr;
            skips_ = true;
            return;
        }
        const std::string_view rest = without_blanks(text.substr(close + 1));
        if (!rest.empty() && rest.front() != ';' && rest.front() != '#') {
            tell_.note(line_, fmt::format("`{}` follows the name of the section", rest.substr(0, 40)), "it is ignored");
        }
        const std::size_t before = file_.sections().size();
        // most files have their sections in alphabetical order, so a new section usually follows the last one
        const auto hint = section_ == nullptr ? file_.sections().end() : std::next(place_);
        place_ = file_.sections().try_emplace(hint, lower_case(name));
        section_ = &place_->second;
        if (file_.sections().size() == before) {
            tell_.note(line_, fmt::format("section [{}] is already in line {}", name, section_->line),
                       "both are combined");
        } else {
            section_->name = name;
            section_->line = line_;
            section_->values.reserve(usual_values);
        }
        skips_ = false;
    }

    void add_value(std::string_view text) {
        const std::size_t equals = place_of_first(text, '=', 0);
        const std::string_view key = without_trailing_blanks(text.substr(0, equals));
        if (skips_) {
            return;  // a note already reports the invalid section
        }
        if (equals == text.size() || key.empty()) {
            strange(fmt::format("`{}` is neither [Section] nor Key=Value", text.substr(0, 40)));
        } else if (section_ == nullptr) {
            strange(fmt::format("key {} is before the first section", key));
        } else {
            make_lower_case(text_.data() + place_of(key), key.size());
            section_->values.emplace_back(key, IniValue{without_leading_blanks(text.substr(equals + 1)), line_});
        }
    }

    std::size_t place_of(std::string_view part) const { return static_cast<std::size_t>(part.data() - text_.data()); }
    std::string_view as_written(std::string_view part) const { return written_.substr(place_of(part), part.size()); }

    const EdsTelling& tell_;
    std::string_view written_;
    IniFile file_;
    std::string& text_;  ///< copy of written_, with keys in lower case
    IniSection* section_{nullptr};
    /// place of section_ in the sections; valid if section_ is not nullptr
    IniSections::iterator place_;
    bool skips_{false};  ///< whether the current line is in a section whose first line is invalid
    std::size_t strange_{0};
    unsigned line_{0};
};

}  // namespace

std::string lower_case(std::string_view text) {
    std::string out{text};
    make_lower_case(out.data(), out.size());
    return out;
}

const IniValue* IniSection::find(std::string_view key) const {
    const auto found = std::lower_bound(values.begin(), values.end(), key, [](const auto& one, std::string_view text) {
        return compare_lower(one.first, text) < 0;
    });
    return found == values.end() || compare_lower(found->first, key) != 0 ? nullptr : &found->second;
}

const IniValue* IniSection::filled(std::string_view key) const {
    const IniValue* found = find(key);
    return found == nullptr || found->text.empty() ? nullptr : found;
}

const IniSection* IniFile::find(std::string_view name) const {
    const auto found = sections().find(lower_case(name));
    return found == sections().end() ? nullptr : &found->second;
}

std::vector<IniRepetition> IniFile::sort_values() {
    SectionSorter sorter;
    for (auto& [name, section] : sections()) {
        sorter.sort(section);
    }
    return sorter.take_repeated();
}

IniFile read_ini(const std::string& text, const EdsTelling& tell) {
    IniReader reader{text, tell};
    reader.read_lines();
    if (reader.is_strange()) {
        tell.fault(1, fmt::format("more than {} lines are neither [Section] nor Key=Value", most_strange_lines),
                   "name an EDS, DCF or XDD file");
        return {};
    }
    return reader.take();
}

}  // namespace canproof::host
