// SPDX-License-Identifier: Apache-2.0
#include "host/assess/trace/kill_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <sstream>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

const char* const heading = "test,body,kills,without mutants,code";
const char* const older_heading = "test,body,kills,without mutants";
constexpr std::size_t mark_digits = 8;

std::vector<std::string> parts_of(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in{text};
    for (std::string part; std::getline(in, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

}  // namespace

std::map<std::string, std::string> code_by_test(const Evidence& evidence) {
    std::map<std::string, std::set<std::string>> claims;
    for (const auto& [id, verdicts] : evidence.verdicts) {
        const auto work = evidence.work.find(id);
        const std::string claim = fmt::format("{} {}", id, work == evidence.work.end() ? "" : work->second.code);
        for (const Verdict& verdict : verdicts) {
            claims[verdict.test].insert(claim);
        }
    }
    std::map<std::string, std::string> marks;
    for (const auto& [test, all] : claims) {
        marks[test] = sha256(fmt::format("{}", fmt::join(all, "\n"))).substr(0, mark_digits);
    }
    return marks;
}

KillRecord read_kill_record(const std::filesystem::path& file) {
    KillRecord record;
    if (!std::filesystem::exists(file)) {
        return record;
    }
    std::istringstream in{read_file(file)};
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (number == 1 && (line == heading || line == older_heading)) {
            continue;
        }
        const auto fields = parts_of(line + ",.", ',');
        if (fields.size() < 5 || fields.size() > 6 || fields[0].empty() || fields[1].empty()) {
            throw InputError{fmt::format(
                "{}:{}: the line does not have the form `{}`; remove this line, then run `canproof mutate --kills`",
                file.string(), number, heading)};
        }
        record[fields[0]] = {fields[1], parts_of(fields[2], ' '), parts_of(fields[3], ' '),
                             fields.size() == 6 ? fields[4] : ""};
    }
    return record;
}

std::string write_kill_record(const KillRecord& record) {
    std::string text = std::string{heading} + "\n";
    for (const auto& [test, line] : record) {
        text += fmt::format("{},{},{},{},{}\n", test, line.body, fmt::join(line.kills, " "),
                            fmt::join(line.without_mutants, " "), line.code);
    }
    return text;
}

}  // namespace canproof::host
