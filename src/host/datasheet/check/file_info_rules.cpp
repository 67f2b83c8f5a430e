// SPDX-License-Identifier: Apache-2.0
// Checks versions, dates and times in [FileInfo].
#include "host/datasheet/check/file_info_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "host/datasheet/check/known_names.hpp"
#include "host/datasheet/eds_numbers.hpp"

namespace canproof::host {

namespace {

constexpr auto error = EdsSeverity::error;
constexpr auto warning = EdsSeverity::warning;
constexpr const char* source = "CiA 306, [FileInfo]";

/// Returns the numbers between the separators. Returns none when the text contains other characters, an empty part, or
/// a number with more than `most_digits` digits.
std::vector<unsigned> numbers_of(std::string_view text, char separator, std::size_t most_digits) {
    std::vector<unsigned> all;
    std::string digits;
    for (const char c : std::string{text} + separator) {
        if (c == separator) {
            if (digits.empty() || digits.size() > most_digits) {
                return {};
            }
            all.push_back(static_cast<unsigned>(std::stoul(digits)));
            digits.clear();
        } else if (c >= '0' && c <= '9') {
            digits += c;
        } else {
            return {};
        }
    }
    return all;
}

struct Day {
    unsigned year{0};
    unsigned month{0};
    unsigned day{0};

    bool exists() const {
        constexpr std::array<unsigned, 12> days{31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
        const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
        return month >= 1 && month <= 12 && day >= 1 && day <= days[month - 1] && (month != 2 || day < 29 || leap);
    }
    std::string text() const { return fmt::format("{:02}-{:02}-{:04}", month, day, year); }
};

struct Minute {
    unsigned hour{0};  ///< from 0 to 23
    unsigned minute{0};

    std::string text() const {
        const unsigned half = hour % 12;
        return fmt::format("{:02}:{:02}{}", half == 0 ? 12 : half, minute, hour < 12 ? "AM" : "PM");
    }
};

/// Parses mm-dd-yyyy and unambiguous variants: without leading zeros, yyyy-mm-dd, dd.mm.yyyy. Returns nothing for any
/// other text.
std::optional<Day> read_day(std::string_view text) {
    const auto dashes = numbers_of(text, '-', 4);
    if (dashes.size() == 3 && dashes[0] > 31) {
        return Day{dashes[0], dashes[1], dashes[2]};
    }
    if (dashes.size() == 3 && dashes[2] > 31) {
        return Day{dashes[2], dashes[0], dashes[1]};
    }
    const auto dots = numbers_of(text, '.', 4);
    return dots.size() == 3 && dots[2] > 31 ? std::optional{Day{dots[2], dots[1], dots[0]}} : std::nullopt;
}

/// Parses hh:mmAM and unambiguous variants: with a blank, in lower case, or hh:mm in 24 hours. Returns nothing for any
/// other text.
std::optional<Minute> read_minute(std::string_view given) {
    std::string text = lower_case(given);
    const bool morning = text.size() > 2 && text.compare(text.size() - 2, 2, "am") == 0;
    const bool evening = text.size() > 2 && text.compare(text.size() - 2, 2, "pm") == 0;
    if (morning || evening) {
        text.resize(text.size() - 2);
        while (!text.empty() && text.back() == ' ') {
            text.pop_back();
        }
    }
    const auto parts = numbers_of(text, ':', 2);
    if (parts.size() != 2 || parts[1] > 59) {
        return std::nullopt;
    }
    if (!morning && !evening) {
        return parts[0] <= 23 ? std::optional{Minute{parts[0], parts[1]}} : std::nullopt;
    }
    const bool fits = parts[0] >= 1 && parts[0] <= 12;
    return fits ? std::optional{Minute{parts[0] % 12 + (evening ? 12U : 0U), parts[1]}} : std::nullopt;
}

class FileInfoCheck {
  public:
    FileInfoCheck(const EdsSheet& sheet, const IniSection& section, EdsFindings& findings)
        : sheet_{sheet}, section_{section}, findings_{findings} {}

    void run() {
        check_keys();
        check_name();
        check_number("FileVersion", "fileinfo-version");
        check_number("FileRevision", "fileinfo-revision");
        check_eds_version();
        for (const char* which : {"Creation", "Modification"}) {
            check_day(fmt::format("{}Date", which));
            check_minute(fmt::format("{}Time", which));
        }
        check_order();
    }

  private:
    void check_keys() {
        for (const char* key : {"FileName", "FileVersion", "FileRevision", "EDSVersion", "Description", "CreationTime",
                                "CreationDate", "CreatedBy"}) {
            if (section_.filled(key) == nullptr) {
                findings_.add("fileinfo-key-missing", section_.line,
                              fmt::format("[FileInfo] has no value for {}", key));
            }
        }
        for (const auto& [key, value] : section_.values) {
            if (known_key("FileInfo", key).empty()) {
                findings_.add("fileinfo-key-unknown", value.line,
                              fmt::format("{} is no key of [FileInfo]", sheet_.line(value.line).name));
            }
        }
    }

    void check_name() {
        const IniValue* name = section_.filled("FileName");
        if (name == nullptr) {
            return;
        }
        const std::string lower = lower_case(name->text);
        const std::string end = sheet_.is_dcf() ? ".dcf" : ".eds";
        if (lower.size() <= end.size() || lower.compare(lower.size() - end.size(), end.size(), end) != 0) {
            findings_.add("fileinfo-name-extension", name->line,
                          fmt::format("FileName {} does not end in {}", name->text, end));
        }
        if (!sheet_.name().empty() && lower != lower_case(sheet_.name())) {
            findings_.add("fileinfo-name-differs", name->line,
                          fmt::format("FileName is {}, but the name of the file is {}", name->text, sheet_.name()));
        }
    }

    void check_number(const char* key, const char* rule) {
        const IniValue* value = section_.filled(key);
        if (value != nullptr && eds_unsigned(value->text).value_or(256) > 255) {
            findings_.add(rule, value->line, fmt::format("{} {} is not a number from 0 to 255", key, value->text));
        }
    }

    void check_eds_version() {
        const IniValue* value = section_.filled("EDSVersion");
        if (value != nullptr && value->text != "3.0" && value->text != "4.0") {
            findings_.add("fileinfo-eds-version", value->line,
                          fmt::format("EDSVersion {} is neither 3.0 nor 4.0", value->text));
        }
    }

    void check_day(const std::string& key) {
        const IniValue* value = section_.filled(key);
        if (value == nullptr) {
            return;
        }
        const auto day = read_day(value->text);
        if (day && !day->exists()) {
            findings_.add("fileinfo-no-such-day", value->line,
                          fmt::format("{} {} is no day of the calendar", key, value->text));
        } else if (!day || day->text() != value->text) {
            findings_.add("fileinfo-date", value->line,
                          fmt::format("{} {} is not of the form mm-dd-yyyy", key, value->text),
                          day ? replace_line(value->line, known_key("FileInfo", key) + "=" + day->text())
                              : std::vector<EdsEdit>{});
        }
    }

    void check_minute(const std::string& key) {
        const IniValue* value = section_.filled(key);
        if (value == nullptr) {
            return;
        }
        const auto minute = read_minute(value->text);
        if (!minute || minute->text() != value->text) {
            findings_.add("fileinfo-time", value->line,
                          fmt::format("{} {} is not of the form hh:mmAM or hh:mmPM", key, value->text),
                          minute ? replace_line(value->line, known_key("FileInfo", key) + "=" + minute->text())
                                 : std::vector<EdsEdit>{});
        }
    }

    void check_order() {
        const IniValue* created = section_.filled("CreationDate");
        const IniValue* modified = section_.filled("ModificationDate");
        const auto first = created == nullptr ? std::nullopt : read_day(created->text);
        const auto last = modified == nullptr ? std::nullopt : read_day(modified->text);
        const auto key = [](const Day& day) { return std::make_tuple(day.year, day.month, day.day); };
        if (first && last && key(*last) < key(*first)) {
            findings_.add("fileinfo-modified-before", modified->line,
                          fmt::format("ModificationDate {} is before CreationDate {}", modified->text, created->text));
        }
    }

    const EdsSheet& sheet_;
    const IniSection& section_;
    EdsFindings& findings_;
};

}  // namespace

const std::vector<EdsRule>& file_info_rules() {
    static const std::vector<EdsRule> rules{
        {"fileinfo-missing", error, "there is no [FileInfo]", "add the section", source},
        {"fileinfo-key-missing", warning, "[FileInfo] lacks a key or its value", "add the key with its value", source},
        {"fileinfo-key-unknown", warning, "[FileInfo] has a key that CiA 306 does not define",
         "correct or remove the key", source},
        {"fileinfo-name-extension", warning, "the extension of FileName does not fit the kind of file",
         "end the name in .eds, or in .dcf for a device configuration file", source},
        {"fileinfo-name-differs", warning, "FileName is not the name of the file", "write the name that the file has",
         source},
        {"fileinfo-version", error, "FileVersion is no UNSIGNED8", "write a number from 0 to 255", source},
        {"fileinfo-revision", error, "FileRevision is no UNSIGNED8", "write a number from 0 to 255", source},
        {"fileinfo-eds-version", warning, "EDSVersion is neither 3.0 nor 4.0", "write 4.0", source},
        {"fileinfo-date", error, "a date is not of the form mm-dd-yyyy", "write month, day and year as mm-dd-yyyy",
         source},
        {"fileinfo-no-such-day", error, "a date is no day of the calendar",
         "write a day that exists, as mm-dd-yyyy: the month comes first", source},
        {"fileinfo-time", error, "a time is not of the form hh:mmAM or hh:mmPM",
         "write the time with hours from 01 to 12 and AM or PM", source},
        {"fileinfo-modified-before", warning, "the file was modified before it was created",
         "correct one of the two dates", source}};
    return rules;
}

void check_file_info(const EdsSheet& sheet, EdsFindings& findings) {
    const IniSection* section = sheet.section("FileInfo");
    if (section == nullptr) {
        findings.add("fileinfo-missing", 1, "there is no section [FileInfo]");
        return;
    }
    FileInfoCheck{sheet, *section, findings}.run();
}

}  // namespace canproof::host
