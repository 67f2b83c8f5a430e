// The INI form of CiA 306: sections of `key=value` lines. Every line knows its number; names are compared without
// regard to case.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/speccompiler/fault.hpp"

namespace canproof::host {

struct IniValue {
    std::string text;  ///< without blanks at its ends
    unsigned line{0};
};

struct IniSection {
    std::string name;  ///< as written
    unsigned line{0};
    std::map<std::string, IniValue> values;  ///< by key in lower case

    /// nullptr when the key is absent.
    const IniValue* find(const std::string& key) const;
    /// Text of a key that is present and not empty; nullptr otherwise.
    const IniValue* filled(const std::string& key) const;
};

struct IniFile {
    std::map<std::string, IniSection> sections;  ///< by name in lower case

    const IniSection* find(const std::string& name) const;
};

/// Longer lines, and longer files, are none of CiA 306's.
constexpr std::size_t longest_ini_line = 8192;
constexpr std::size_t longest_ini_file = std::size_t{16} << 20U;

/// After so many faults the rest is not read.
constexpr std::size_t most_ini_faults = 1000;

/// What is wrong is added to `faults`; the rest is read. `name` is the file's in messages.
IniFile read_ini(const std::string& text, const std::string& name, Faults& faults);

std::string lower_case(const std::string& text);

}  // namespace canproof::host
