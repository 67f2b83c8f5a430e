// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/kill_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"

namespace canproof::host {

namespace {

const char* const heading = "test,body,kills,without mutants";

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in{text};
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

}  // namespace

KillRecord read_kill_record(const std::filesystem::path& file) {
    KillRecord record;
    if (!std::filesystem::exists(file)) {
        return record;
    }
    std::istringstream in{read_file(file)};
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (number == 1 && line == heading) {
            continue;
        }
        const auto fields = parts_of(line + ",.", ',');
        if (fields.size() != 5 || fields[0].empty() || fields[1].empty()) {
            throw InputError{fmt::format("{}:{}: the line does not have the form `{}`; run `canproof mutate --kills`",
                                         file.string(), number, heading)};
        }
        record[fields[0]] = {fields[1], parts_of(fields[2], ' '), parts_of(fields[3], ' ')};
    }
    return record;
}

std::string write_kill_record(const KillRecord& record) {
    std::string text = std::string{heading} + "\n";
    for (const auto& [test, line] : record) {
        text += fmt::format("{},{},{},{}\n", test, line.body, fmt::join(line.kills, " "),
                            fmt::join(line.without_mutants, " "));
    }
    return text;
}

}  // namespace canproof::host
