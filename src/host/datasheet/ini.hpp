// SPDX-License-Identifier: Apache-2.0
// Parses the INI form of CiA 306: sections of `key=value` lines. Every line has its number; names are compared without
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
    std::map<std::string, IniValue, std::less<>> values;  ///< the keys are in lower case

    /// Returns the value; nullptr when the key is absent.
    const IniValue* find(std::string_view key) const;
    /// Returns the value of a key that is present and not empty; otherwise nullptr.
    const IniValue* filled(std::string_view key) const;
};

struct IniFile {
    std::map<std::string, IniSection, std::less<>> sections;  ///< the names are in lower case

    const IniSection* find(std::string_view name) const;
};

/// Blanks around names and values that CiA 306 allows or that occur in existing files.
constexpr std::string_view ini_blanks = " \t\r\v\f";

/// Greatest length of a line in bytes; CiA 306 allows less.
constexpr std::size_t longest_ini_line = 8192;

/// Greatest number of lines that do not follow CiA 306; a file with more is no data sheet.
constexpr std::size_t most_strange_lines = 1000;

/// Receives the faults and notes of a file.
struct EdsTelling {
    const std::string& file;
    Faults& faults;
    Faults& notes;

    /// Adds a fault: the file cannot be used.
    void fault(unsigned line, std::string what, std::string fix) const {
        faults.emplace_back(Place{file, line}, std::move(what), std::move(fix));
    }
    /// Adds a note: a defect, and the value that is assumed instead.
    void note(unsigned line, std::string what, std::string assumed) const {
        notes.emplace_back(Place{file, line}, std::move(what), std::move(assumed));
    }
};

/// Parses the text. Lines without meaning are ignored, with a note. A text that cannot be a data sheet is a fault.
IniFile read_ini(const std::string& text, const EdsTelling& tell);

/// Returns `a` to `z` for `A` to `Z`, and every other byte unchanged.
constexpr char lower_case(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string lower_case(std::string_view text);

}  // namespace canproof::host
