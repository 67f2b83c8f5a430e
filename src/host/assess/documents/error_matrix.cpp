// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/error_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "host/assess/documents/error_tables.hpp"
#include "host/assess/documents/words.hpp"

namespace canproof::host {

namespace {

/// Returns whether the text contains the emergency code, such as `8130h`. Other digits may precede the code, as in
/// `80nn8130h` and `00008130h`.
bool names_code(const std::string& text, const std::string& code) {
    return text.find(code) != std::string::npos;
}

std::vector<std::string> requirements_with(const Part& part, const std::string& code) {
    std::vector<std::string> ids;
    for (const auto& one : part.requirements) {
        if (one.retired.empty() && names_code(one.text, code)) {
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
