// SPDX-License-Identifier: Apache-2.0
// Checks the three lists of objects: mandatory, optional and manufacturer objects.
#include "host/datasheet/check/list_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "host/base/cia301.hpp"
#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* source = "CiA 306, object lists";

constexpr std::array<const char*, 3> names{"MandatoryObjects", "OptionalObjects", "ManufacturerObjects"};

/// Returns the number of the list that must contain an object: 0 mandatory, 1 optional, 2 manufacturer.
std::size_t list_of(unsigned index) {
    const bool mandatory = index == cia301::device_type || index == cia301::error_register || index == cia301::identity;
    if (mandatory) {
        return 0;
    }
    return cia301::is_of_manufacturer(index) ? 2 : 1;
}

struct ListEntry {
    unsigned key{0};
    unsigned index{0};
    const IniValue* value{nullptr};
};

struct List {
    const IniSection* section{nullptr};
    std::vector<ListEntry> entries;  ///< ascending by key
    bool all_known{true};            ///< whether all lines are valid, so that a fix can rewrite the list
};

class ListCheck {
  public:
    ListCheck(const EdsSheet& sheet, EdsFindings& findings) : sheet_{sheet}, findings_{findings} {}

    void run() {
        for (std::size_t i = 0; i < names.size(); ++i) {
            read(i);
        }
        make_fix();
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (lists_[i].section == nullptr) {
                findings_.add("list-missing", 1, fmt::format("there is no section [{}]", names[i]), fix_);
            } else {
                check_numbers(i);
                check_entries(i);
            }
        }
        check_unlisted();
    }

  private:
    void read(std::size_t at) {
        List& list = lists_[at];
        list.section = sheet_.section(names[at]);
        if (list.section == nullptr) {
            return;
        }
        for (const auto& [key, value] : list.section->values) {
            if (key == "supportedobjects") {
                continue;
            }
            const bool numbered = key.size() <= 6 && key.find_first_not_of("0123456789") == std::string::npos;
            const auto index = eds_unsigned(value.text);
            if (!numbered) {
                findings_.add("list-key", value.line,
                              fmt::format("key {} is no valid number of a list entry", sheet_.line(value.line).name));
            } else if (!index || *index == 0 || *index > 0xFFFF) {
                findings_.add("list-no-index", value.line,
                              fmt::format("{} is not an index from 0x0001 to 0xFFFF", value.text));
            } else {
                list.entries.push_back(
                    {static_cast<unsigned>(std::stoul(std::string{key})), static_cast<unsigned>(*index), &value});
                continue;
            }
            list.all_known = false;
        }
        std::sort(list.entries.begin(), list.entries.end(),
                  [](const ListEntry& a, const ListEntry& b) { return a.key < b.key; });
    }

    /// Makes one fix that rewrites all three lists. All findings that this fix removes share the fix. Makes no fix when
    /// a list has an invalid line.
    void make_fix() {
        std::array<std::set<unsigned>, 3> right;
        for (const List& list : lists_) {
            if (!list.all_known) {
                return;
            }
            for (const ListEntry& entry : list.entries) {
                right[list_of(entry.index)].insert(entry.index);
            }
        }
        for (const auto& [index, object] : sheet_.objects()) {
            if (object.section != nullptr && index >= cia301::first_object) {
                right[list_of(index)].insert(index);
            }
        }
        std::vector<EdsEdit> edits;
        for (std::size_t i = 0; i < names.size(); ++i) {
            std::string text = fmt::format("SupportedObjects={}", right[i].size());
            unsigned number = 0;
            for (const unsigned index : right[i]) {
                text += fmt::format("\n{}=0x{:04X}", ++number, index);
            }
            const IniSection* section = lists_[i].section;
            if (section == nullptr) {
                edits.push_back({EdsEdit::Kind::insert_after, static_cast<unsigned>(sheet_.lines().size()),
                                 fmt::format("[{}]\n{}", names[i], text)});
                continue;
            }
            for (const auto& [key, value] : section->values) {
                edits.push_back({EdsEdit::Kind::erase, value.line, {}});
            }
            edits.push_back({EdsEdit::Kind::insert_after, section->line, text});
        }
        fix_ = std::make_shared<const std::vector<EdsEdit>>(std::move(edits));
    }

    void check_numbers(std::size_t at) {
        const List& list = lists_[at];
        const IniValue* said = list.section->find("SupportedObjects");
        const auto count = said == nullptr ? std::nullopt : eds_unsigned(said->text);
        if (!count) {
            findings_.add("list-count-missing", said == nullptr ? list.section->line : said->line,
                          fmt::format("SupportedObjects of [{}] is missing or not a number", names[at]), fix_);
        } else if (*count != list.entries.size()) {
            findings_.add("list-count", said->line,
                          fmt::format("SupportedObjects is {}, but [{}] lists {} object(s)", *count, names[at],
                                      list.entries.size()),
                          fix_);
        }
        unsigned due = 0;
        unsigned last = 0;
        bool in_order = true;
        bool numbered = true;
        for (const ListEntry& entry : list.entries) {
            if (numbered && entry.key != ++due) {
                numbered = false;
                findings_.add("list-numbering", entry.value->line,
                              fmt::format("the entry has the number {} instead of {}", entry.key, due), fix_);
            }
            if (in_order && entry.index < last) {
                in_order = false;
                findings_.add("list-order", entry.value->line,
                              fmt::format("{} follows {}", eds_index_text(entry.index), eds_index_text(last)), fix_);
            }
            last = entry.index;
        }
    }

    void check_entries(std::size_t at) {
        for (const ListEntry& entry : lists_[at].entries) {
            const std::string title = eds_index_text(entry.index);
            const auto [first, is_new] = listed_.emplace(entry.index, Listed{at, entry.value->line});
            if (!is_new) {
                const bool same = first->second.list == at;
                findings_.add(same ? "list-duplicate" : "list-two", entry.value->line,
                              fmt::format("{} is already listed in line {}", title, first->second.line), fix_);
            }
            const std::string digits = lower_case(entry.value->text);
            if (digits.rfind("0x", 0) != 0) {
                findings_.add("list-form", entry.value->line,
                              fmt::format("index {} is not written in hexadecimal (0x…)", entry.value->text), fix_);
            }
            const EdsSheetObject* object = sheet_.object(entry.index);
            if (object == nullptr || object->section == nullptr) {
                findings_.add("list-no-section", entry.value->line,
                              fmt::format("{} is listed, but there is no section [{:04X}]", title, entry.index));
            }
            if (entry.index < cia301::first_object) {
                findings_.add("list-data-type", entry.value->line,
                              fmt::format("{} is the index of a data type", title));
            } else if (list_of(entry.index) != at) {
                findings_.add(
                    "list-wrong", entry.value->line,
                    fmt::format("{} is listed in [{}] instead of [{}]", title, names[at], names[list_of(entry.index)]),
                    fix_);
            }
        }
    }

    void check_unlisted() {
        for (const auto& [index, object] : sheet_.objects()) {
            if (object.section != nullptr && index >= cia301::first_object && listed_.count(index) == 0) {
                findings_.add(
                    "list-none", object.section->line,
                    fmt::format("[{}] describes an object that is in none of the three lists", object.section->name),
                    fix_);
            }
        }
    }

    struct Listed {
        std::size_t list{0};
        unsigned line{0};
    };

    const EdsSheet& sheet_;
    EdsFindings& findings_;
    std::array<List, 3> lists_;
    std::map<unsigned, Listed> listed_;
    EdsEdits fix_;  ///< fixes the findings of all three lists together; nullptr: there is no fix
};

}  // namespace

const std::vector<EdsRule>& list_rules() {
    static const std::vector<EdsRule> rules{
        {"list-missing", error, "a list of objects is missing",
         "add the section, with SupportedObjects=0 when the list is empty", source},
        {"list-count-missing", error, "SupportedObjects of a list is missing or not a number",
         "write the number of objects in the list", source},
        {"list-count", error, "SupportedObjects differs from the number of listed objects",
         "write the number of listed objects", source},
        {"list-key", warning, "a key of a list is not a number", "write the entries as 1=0x1000, 2=0x1001 …", source},
        {"list-no-index", error, "an entry of a list is no index", "write an index from 0x1000 to 0xFFFF", source},
        {"list-numbering", error, "the entries of a list are not numbered from 1 without gap",
         "number the entries from 1 on", source},
        {"list-order", warning, "a list is not in ascending order", "list the objects by ascending index", source},
        {"list-duplicate", error, "an object is in a list twice", "list the object once", source},
        {"list-two", error, "an object is in two lists",
         "list the object once, as mandatory, optional or manufacturer's object", source},
        {"list-form", warning, "an index is not hexadecimal", "write the index as 0x and four digits", source},
        {"list-no-section", error, "an object is listed but not described",
         "describe the object, or remove it from the list", source},
        {"list-data-type", error, "a data type is listed as an object", "remove the data type from the list", source},
        {"list-wrong", error, "an object is in the wrong list",
         "list 1000h, 1001h and 1018h as mandatory, 2000h to 5FFFh as manufacturer's, all other objects as optional",
         source},
        {"list-none", error, "an object is described but not listed",
         "list the object as mandatory, optional or manufacturer's object", source}};
    return rules;
}

void check_list(const EdsSheet& sheet, EdsFindings& findings) {
    ListCheck{sheet, findings}.run();
}

}  // namespace canproof::host
