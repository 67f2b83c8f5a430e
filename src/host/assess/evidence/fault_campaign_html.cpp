// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/fault_campaign_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "host/base/input_error.hpp"
#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

using nlohmann::json;

json read_campaign(const std::filesystem::path& path) {
    std::ifstream in{path};
    if (!in.is_open()) {
        return {};
    }
    try {
        return json::parse(in);
    } catch (const json::exception& error) {
        throw InputError{fmt::format("{} is no file of src/target/faults/run: {}", path.string(), error.what())};
    }
}

std::size_t count_of(const json& row, const char* key) {
    return row.at(key).get<std::size_t>();
}

double percent(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

/// Returns the names of the mechanisms that detected a fault, with the most frequent one first.
std::string mechanisms_of(const json& row) {
    static const std::vector<std::string> no_detection{"masked",     "wrong output", "wrong PDO",
                                                       "safe state", "wrong answer", "PDO missing or late"};
    std::vector<std::pair<std::size_t, std::string>> found;
    for (const auto& [name, count] : row.at("mechanisms").items()) {
        if (std::find(no_detection.begin(), no_detection.end(), name) == no_detection.end()) {
            found.emplace_back(count.get<std::size_t>(), name);
        }
    }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    std::string text;
    for (const auto& [count, name] : found) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", escaped(name), count);
    }
    return text.empty() ? "nothing" : text;
}

/// Returns, for the run without self-tests, the share of the faults of this kind that no mechanism detected.
std::string silent_without(const json& without, const std::string& kind) {
    if (!without.is_object() || !without.at("table").contains(kind)) {
        return "not measured";
    }
    const json& row = without.at("table").at(kind);
    return fmt::format("{} of {} ({:.2f} %)", count_of(row, "silent"), count_of(row, "faults"),
                       percent(count_of(row, "silent"), count_of(row, "faults")));
}

std::vector<std::string> row_of(const std::string& device, const std::string& kind, const json& row,
                                const json& without) {
    const std::size_t faults = count_of(row, "faults");
    const std::size_t effective = count_of(row, "effective");
    const std::size_t silent = count_of(row, "silent");
    return {escaped(device),
            escaped(kind),
            std::to_string(faults),
            std::to_string(faults - effective),
            fmt::format("{}: {}", count_of(row, "detected"), mechanisms_of(row)),
            fmt::format("{}, at most {:.1f} ms", count_of(row, "detected after a wrong value"),
                        row.at("longest ms").get<double>()),
            std::to_string(count_of(row, "safe")),
            std::to_string(count_of(row, "other")),
            fmt::format("{} ({:.2f} % of those with an effect)", silent, percent(silent, effective)),
            silent_without(without, kind)};
}

}  // namespace

std::string write_fault_campaign_html(const std::filesystem::path& build) {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder = build / "faults";
    if (std::filesystem::is_directory(folder)) {
        for (const auto& entry : std::filesystem::directory_iterator{folder}) {
            const std::string name = entry.path().stem().string();
            if (entry.path().extension() == ".json" && name.find("-without") == std::string::npos) {
                files.push_back(entry.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    std::string text = "<h2 id=\"faults\">Faults of the processor (FMEDA)</h2>\n";
    if (files.empty()) {
        return fmt::format("{}<p>{}: src/target/faults/run injects the faults into an emulated processor.</p>\n", text,
                           html_state("not measured"));
    }
    std::vector<std::vector<std::string>> rows;
    for (const auto& file : files) {
        const json campaign = read_campaign(file);
        const json without = read_campaign(folder / (file.stem().string() + "-without.json"));
        for (const auto& [kind, row] : campaign.at("table").items()) {
            rows.push_back(row_of(file.stem().string(), kind, row, without));
        }
    }
    text +=
        "<p>Each fault inverts one bit at a random time of the main loop, on QEMU's Cortex-M4. The drivers of "
        "the chip are not part of this image. Detected: a self-test, an exception or the watchdog stops the device, or "
        "the device reports the fault by EMCY, boot-up or heartbeat. Late: a wrong output or PDO came before that. "
        "Silent: a wrong output or PDO came, and nothing noticed the fault until the end.</p>\n";
    return text + html_table("Faults of the processor",
                             {{"Device", 8},
                              {"Part", 10},
                              {"Faults", 6},
                              {"Masked", 6},
                              {"Detected by", 26},
                              {"Late", 10},
                              {"Safe state", 6},
                              {"Other frame", 6},
                              {"Silent", 11},
                              {"Silent without self-tests", 11}},
                             rows);
}

}  // namespace canproof::host
