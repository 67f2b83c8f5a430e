// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/error_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "host/assess/documents/error_tables.hpp"
#include "host/assess/documents/words.hpp"
#include "host/datasheet/eds_values.hpp"

namespace canproof::host {

namespace {

constexpr const char* no_error = "0000h";  ///< code of the message that all errors are gone

/// Returns whether the number that ends before `end` is the 32-bit entry of an error in 1003h (error list), such as
/// `80nn8130h` and `00008130h`. Abort codes of SDO begin with 05, 06 or 08.
bool is_listed_entry(const std::string& text, const std::size_t begin, const std::size_t end) {
    constexpr std::size_t entry_digits = 8;
    const std::string head = text.substr(begin, 2);
    return end - begin == entry_digits && head != "05" && head != "06" && head != "08";
}

/// Returns whether the place at `at` names an object of the device. A text calls a code with the index of an object
/// `error 3100h` or `code 3100h`.
bool is_object_at(const std::string& text, const std::size_t at, const std::string& code, const bool has_object) {
    const auto follows = [&](const std::string& word) {
        return at >= word.size() && text.compare(at - word.size(), word.size(), word) == 0;
    };
    return text.compare(at + code.size(), 1, ":") == 0 || (has_object && !follows("error ") && !follows("code "));
}

/// Returns whether the text contains the emergency code, such as `8130h`, alone or in an entry of 1003h (error list).
/// `has_object` says whether the device has an object with this number.
bool names_code(const std::string& text, const std::string& code, const bool has_object) {
    static const std::string digits = "0123456789ABCDEFn";
    for (auto at = text.find(code); at != std::string::npos; at = text.find(code, at + 1)) {
        std::size_t begin = at;
        while (begin > 0 && digits.find(text[begin - 1]) != std::string::npos) {
            --begin;
        }
        const bool listed = code != no_error && is_listed_entry(text, begin, at + code.size() - 1);
        if (begin == at ? !is_object_at(text, at, code, has_object) : listed) {
            return true;
        }
    }
    return false;
}

bool has_object(const Part& part, const std::string& code) {
    constexpr int hexadecimal = 16;
    const auto index = static_cast<unsigned>(std::strtoul(code.c_str(), nullptr, hexadecimal));
    return count_objects(part, index, index) != 0;
}

std::vector<std::string> requirements_with(const Part& part, const std::string& code) {
    const bool object = has_object(part, code);
    std::vector<std::string> ids;
    for (const auto& one : part.requirements) {
        if (one.retired.empty() && names_code(one.text, code, object)) {
            ids.push_back(one.id);
        }
    }
    return ids;
}

bool has_lamps(const Part& part) {
    return std::any_of(part.signals.begin(), part.signals.end(),
                       [](const Signal& one) { return !one.input && one.name.rfind("led", 0) == 0; });
}

std::string lamp_of(const Part& part, const std::string& error, const Analysis& analysis) {
    if (!has_lamps(part)) {
        return "no lamp";
    }
    std::vector<std::string> words;
    for (const auto& lamp : analysis.lamps) {
        if (lamp.device == part.name && lamp.error == error) {
            words.push_back(fmt::format("{} ({})", lamp.shows, joined_or(lamp.by)));
        }
    }
    return joined_or(words, missing);
}

std::string others_of(const ErrorRow& row) {
    std::vector<std::string> words;
    for (const auto& [column, value] : row.others) {
        if (column != "register_bits") {
            words.push_back(fmt::format("{} {}", column, value));
        }
    }
    return joined_or(words);
}

std::string register_bits(const ErrorRow& row) {
    const auto found = std::find_if(row.others.begin(), row.others.end(),
                                    [](const auto& one) { return one.first == "register_bits"; });
    return found == row.others.end() ? "by requirement" : found->second;
}

}  // namespace

Document error_matrix(const Register& content, const Part& part, const Analysis& analysis) {
    DocumentTable table{
        "Errors",
        {"Error", "Code", "Bits of 1001h", "Further columns", "Requirements that name the code", "Lamp", "Table"},
        {}};
    for (const auto& row : errors_of(content, part)) {
        table.rows.push_back({row.error, row.code, register_bits(row), others_of(row),
                              joined_or(requirements_with(part, row.code), missing), lamp_of(part, row.error, analysis),
                              row.table});
    }
    Chapter behaviour{
        "Behaviour",
        {"These requirements define how errors are set, reported, listed and cleared, and the behaviour of the device "
         "during an error."},
        {{"Requirements of kind fault", {"Requirement", "Text", "Source"}, requirement_rows(part, "fault")}}};
    return {"error-matrix",
            fmt::format("Errors and emergency messages of the {}", part.info.title),
            "Each error of the device with its emergency code, its bits of 1001h (error register), the lamps, and the "
            "requirements that name the code. The device sends no emergency message for an error whose column `sent` "
            "is false.",
            {Chapter{"Matrix",
                     {"The rows come from the register's tables of errors. `missing` means that no requirement of this "
                      "device names the code, or that no lamp is recorded; the shared requirements may still "
                      "cover it."},
                     {table}},
             behaviour}};
}

}  // namespace canproof::host
