#include <fmt/format.h>
#include <toml++/toml.h>

#include "host/bus/candump.hpp"
#include "host/mutation/mutation.hpp"

namespace canproof::host {

namespace {

std::string required(const toml::table& record, const char* key, const std::filesystem::path& file) {
    const auto text = record[key].value<std::string>();
    if (!text || text->empty()) {
        throw InputError{fmt::format("{}:{}: a record without `{}`; every one has item, cell, change and reason",
                                     file.string(), record.source().begin.line, key)};
    }
    return *text;
}

}  // namespace

std::vector<SurvivorRecord> read_survivor_records(const std::filesystem::path& file) {
    std::vector<SurvivorRecord> records;
    if (!std::filesystem::exists(file)) {
        return records;
    }
    try {
        const toml::table content = toml::parse_file(file.string());
        if (const auto* list = content["survivor"].as_array()) {
            for (const auto& node : *list) {
                if (const auto* record = node.as_table()) {
                    records.push_back({required(*record, "item", file), required(*record, "cell", file),
                                       required(*record, "change", file), required(*record, "reason", file),
                                       static_cast<unsigned>(record->source().begin.line)});
                }
            }
        }
    } catch (const toml::parse_error& error) {
        throw InputError{fmt::format("{}:{}: {}; write [[survivor]] with item, cell, change and reason", file.string(),
                                     error.source().begin.line, error.description())};
    }
    return records;
}

bool matches(const std::string& pattern, const std::string& text) {
    // Position after the last star, and where its match began: on a mismatch the star takes one more character.
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = std::string::npos;
    std::size_t from = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = ++p;
            from = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p;
            ++t;
        } else if (star != std::string::npos) {
            p = star;
            t = ++from;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') {
        ++p;
    }
    return p == pattern.size();
}

std::vector<const SurvivorRecord*> justify(std::vector<MutationOutcome>& outcomes,
                                           const std::vector<SurvivorRecord>& records) {
    std::vector<bool> used(records.size());
    for (MutationOutcome& outcome : outcomes) {
        for (std::size_t i = 0; i < records.size() && outcome.open(); ++i) {
            const SurvivorRecord& record = records[i];
            if (matches(record.item, outcome.cell.item) && matches(record.cell, outcome.cell.cell) &&
                matches(record.change, outcome.cell.change)) {
                outcome.record = &record;
                used[i] = true;
            }
        }
    }
    std::vector<const SurvivorRecord*> idle;
    for (std::size_t i = 0; i < records.size(); ++i) {
        if (!used[i]) {
            idle.push_back(&records[i]);
        }
    }
    return idle;
}

}  // namespace canproof::host
