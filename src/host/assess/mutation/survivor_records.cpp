// SPDX-License-Identifier: Apache-2.0
#include "host/assess/mutation/survivor_records.hpp"

#include <algorithm>

#include "host/assess/mutation/mutation_outcome.hpp"
#include "host/register/toml_records.hpp"

namespace canproof::host {

std::vector<SurvivorRecord> read_survivor_records(const std::filesystem::path& file) {
    std::vector<SurvivorRecord> records;
    if (!std::filesystem::exists(file)) {
        return records;
    }
    read_toml_records(file, [&records](TomlItem& whole) {
        for (auto& item : whole.items("survivor")) {
            records.push_back(
                {item.text("item"), item.text("cell"), item.text("change"), item.text("reason"), item.place().line});
            item.finish();
        }
    });
    return records;
}

bool matches(const std::string& pattern, const std::string& text) {
    // `star` is the position after the last star in the pattern. `from` is the position in the text at which the match
    // of this star begins. After a mismatch, the star matches one more character.
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

bool is_about(const SurvivorRecord& record, const AlteredCell& cell) {
    return matches(record.item, cell.item) && matches(record.cell, cell.cell) && matches(record.change, cell.change);
}

std::vector<const SurvivorRecord*> without_alteration(const std::vector<SurvivorRecord>& records,
                                                      const std::vector<AlteredCell>& cells) {
    std::vector<const SurvivorRecord*> idle;
    for (const SurvivorRecord& record : records) {
        if (std::none_of(cells.begin(), cells.end(), [&](const AlteredCell& cell) { return is_about(record, cell); })) {
            idle.push_back(&record);
        }
    }
    return idle;
}

std::vector<const SurvivorRecord*> justify(std::vector<MutationOutcome>& outcomes,
                                           const std::vector<SurvivorRecord>& records) {
    std::vector<bool> used(records.size());
    for (MutationOutcome& outcome : outcomes) {
        for (std::size_t i = 0; i < records.size() && outcome.open(); ++i) {
            const SurvivorRecord& record = records[i];
            if (is_about(record, outcome.cell)) {
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
