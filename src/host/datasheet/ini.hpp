// SPDX-License-Identifier: Apache-2.0
// Parses the INI form of CiA 306: sections of `key=value` lines. Each value has its line number. Names are compared
// without regard to upper and lower case.
#pragma once

#include <cstddef>
#include <forward_list>
#include <functional>
#include <map>
#include <memory>
#include <memory_resource>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host/datasheet/eight_characters.hpp"
#include "host/register/fault.hpp"

namespace canproof::host {

struct IniValue {
    std::string_view text;  ///< without blanks at its ends; a view of IniFile::texts
    unsigned line{0};
};

struct IniSection {
    std::string name;  ///< the name as it is written in the file
    unsigned line{0};
    std::vector<std::pair<std::string_view, IniValue>> values;  ///< ascending by key; the keys are in lower case

    /// Returns the value; nullptr when the key is absent.
    const IniValue* find(std::string_view key) const;
    /// Returns the value of a key that is present and not empty; otherwise returns nullptr.
    const IniValue* filled(std::string_view key) const;
};

/// A value whose key occurs in the section a second time.
struct IniRepetition {
    std::string_view key;
    unsigned first{0};  ///< line of the value that is used
    unsigned line{0};
};

/// The sections by their name in lower case.
using IniSections = std::pmr::map<std::string, IniSection, std::less<>>;

class IniFile {
  public:
    std::forward_list<std::string> texts;  ///< storage for the bytes of keys and values

    IniFile() = default;
    IniFile(const IniFile&) = delete;  // keys and values would refer to the texts of the original
    IniFile& operator=(const IniFile&) = delete;
    IniFile(IniFile&&) = default;
    IniFile& operator=(IniFile&&) = default;
    ~IniFile() = default;

    IniSections& sections() { return kept_->sections; }
    const IniSections& sections() const { return kept_->sections; }
    const IniSection* find(std::string_view name) const;
    /// Stores the text of a key or a value. Returns a view of it, which is valid as long as the file exists.
    std::string_view keep(std::string text) { return texts.emplace_front(std::move(text)); }
    /// Sorts the values of each section, which may have been appended in any order, by their keys. If a key occurs
    /// several times in a section, keeps the value of the first line and returns the other values.
    std::vector<IniRepetition> sort_values();

  private:
    /// The sections and the memory in which they are. A data sheet has thousands of sections, which are freed together.
    struct Kept {
        std::pmr::monotonic_buffer_resource memory;
        IniSections sections{&memory};
    };
    std::unique_ptr<Kept> kept_{std::make_unique<Kept>()};
};

/// Characters that count as blanks around names and values: those of CiA 306, and others that occur in existing files.
constexpr std::string_view ini_blanks = " \t\r\v\f";

/// Greatest length of a line in bytes; CiA 306 allows less.
constexpr std::size_t longest_ini_line = 8192;

/// Greatest number of lines that do not follow CiA 306. A file with more such lines is no data sheet.
constexpr std::size_t most_strange_lines = 1000;

/// Receives the faults and notes about a file.
struct EdsTelling {
    const std::string& file;
    Faults& faults;
    Faults& notes;

    /// Adds a fault, which means that the file cannot be used.
    void fault(unsigned line, std::string what, std::string fix) const {
        faults.emplace_back(Place{file, line}, std::move(what), std::move(fix));
    }
    /// Adds a note about a defect and the value that is assumed instead.
    void note(unsigned line, std::string what, std::string assumed) const {
        notes.emplace_back(Place{file, line}, std::move(what), std::move(assumed));
    }
};

/// Parses the text. Ignores invalid lines and adds a note for each. Adds a fault for a text that cannot be a data
/// sheet.
IniFile read_ini(const std::string& text, const EdsTelling& tell);

/// Returns the text in lower case.
std::string lower_case(std::string_view text);

}  // namespace canproof::host
