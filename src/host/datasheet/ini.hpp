// The INI form of CiA 306: sections of `key=value` lines. Every line knows its number; names are compared without
// regard to case.
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "host/register/fault.hpp"

namespace canproof::host {

struct IniValue {
    std::string text;  ///< without blanks at its ends
    unsigned line{0};
};

struct IniSection {
    std::string name;  ///< as written
    unsigned line{0};
    std::map<std::string, IniValue, std::less<>> values;  ///< by key in lower case

    /// nullptr when the key is absent.
    const IniValue* find(std::string_view key) const;
    /// Text of a key that is present and not empty; nullptr otherwise.
    const IniValue* filled(std::string_view key) const;
};

struct IniFile {
    std::map<std::string, IniSection, std::less<>> sections;  ///< by name in lower case

    const IniSection* find(std::string_view name) const;
};

/// What CiA 306 allows around names and values, and what real files have there.
constexpr std::string_view ini_blanks = " \t\r\v\f";

/// Longer lines are none of CiA 306's.
constexpr std::size_t longest_ini_line = 8192;

/// A file with more lines that are none of CiA 306's is something else.
constexpr std::size_t most_strange_lines = 1000;

/// Where faults and notes of a file go.
struct EdsTelling {
    const std::string& file;
    Faults& faults;
    Faults& notes;

    /// The file cannot be given a meaning.
    void fault(unsigned line, std::string what, std::string mend) const {
        faults.emplace_back(Place{file, line}, std::move(what), std::move(mend));
    }
    /// What is wrong, and what is assumed instead.
    void note(unsigned line, std::string what, std::string assumed) const {
        notes.emplace_back(Place{file, line}, std::move(what), std::move(assumed));
    }
};

/// Lines that say nothing are notes, and passed over; what cannot be a data sheet at all is a fault.
IniFile read_ini(const std::string& text, const EdsTelling& tell);

/// `A` to `Z` as `a` to `z`; every other byte as it is.
constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string lower_case(std::string_view text);

}  // namespace canproof::host
