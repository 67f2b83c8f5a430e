// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/target_html.hpp"

#include <fmt/format.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "host/report/markup.hpp"
#include "host/report/page.hpp"

namespace canproof::host {

namespace {

using nlohmann::json;

/// Returns the content of a JSON file; null when the file does not exist.
json read_json(const std::filesystem::path& path) {
    std::ifstream in{path};
    return in.is_open() ? json::parse(in) : json{};
}

/// Returns a table cell with a measured value and its limit, marked as good or bad.
std::string bounded(std::uint64_t value, std::uint64_t budget) {
    return html_judged(value <= budget, fmt::format("{} <small>of {}</small>", grouped(value), grouped(budget)));
}

std::string memory_table(const json& footprint) {
    const json& budgets = footprint.at("budgets");
    std::vector<std::vector<std::string>> rows;
    for (const auto& [device, found] : footprint.at("devices").items()) {
        const json& budget = budgets.at("devices").at(device);
        const json& layer = found.at("canopen");
        std::vector<std::string> row{escaped(device)};
        for (const char* key : {"flash", "ram", "stack"}) {
            row.push_back(bounded(found.at(key), budget.at(key)));
        }
        for (const char* key : {"code", "ram", "stack"}) {
            row.push_back(bounded(layer.at(key), budgets.at("canopen").at(key)));
        }
        for (const char* key : {"flash", "ram", "stack"}) {
            row.push_back(found.contains("flashed")
                              ? bounded(found.at("flashed").at(key), found.at("flashed").at("limits").at(key))
                              : "no flashed image");
        }
        rows.push_back(row);
    }
    return html_table("Flash and RAM in bytes, each with its limit (images compiled with -Os)",
                      {{"Device", 13},
                       {"Flash"},
                       {"RAM with stack"},
                       {"Deepest stack"},
                       {"CANopen layer: code"},
                       {"CANopen layer: RAM without values"},
                       {"CANopen layer: stack"},
                       {"With drivers, loop and self-tests: flash"},
                       {"With drivers: RAM with the reserved stack"},
                       {"With drivers: deepest stack"}},
                      rows);
}

/// Returns a list entry for a goal, marked as met or open.
std::string goal_entry(const json& goal, const std::string& markup) {
    return fmt::format("<li>{}\n", html_judged(goal.at("holds").get<bool>(), markup));
}

/// Returns the words for a kind of work, such as `power-on` for `power_on`. A kind without an entry keeps its name.
std::string word_of_kind(const std::string& kind) {
    static const std::map<std::string, std::string> words{{"power_on", "power-on"},
                                                          {"first_tick", "first tick after a power-on"},
                                                          {"crowded_tick", "tick after more frames than a bus carries"},
                                                          {"due_frame", "frame at a deadline"},
                                                          {"due_command", "command at a deadline"}};
    const auto found = words.find(kind);
    return found == words.end() ? kind : found->second;
}

std::string work_table(const json& work) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& [device, kinds] : work.at("devices").items()) {
        for (const auto& [kind, one] : kinds.items()) {
            if (kind != "share") {
                rows.push_back({escaped(device), escaped(word_of_kind(kind)),
                                std::to_string(one.at("count").get<std::uint64_t>()),
                                std::to_string(one.at("instructions").get<std::uint64_t>()),
                                fmt::format("<code>{}</code>", escaped(one.at("what").get<std::string>())),
                                escaped(one.at("where").get<std::string>())});
            }
        }
    }
    std::string text = html_table(
        "Work with the most instructions, by device",
        {{"Device", 12}, {"Work", 11}, {"Times", 10}, {"Instructions at most", 12}, {"Frame", 18}, {"Where"}}, rows);
    text += fmt::format(
        "<p>The load assumes a bus at {} bit/s that is full of the frame with the most instructions per bit, {} cycles "
        "per instruction and a core of {} MHz. The load is instructions × cycles × bit rate ÷ bits ÷ clock. The bits "
        "are those of the frame and of each answer whose identifier has priority over the next such frame. Each frame "
        "counts 47 bits and its data, without stuff bits.</p><ul>\n",
        grouped(work.at("bit_rate").get<std::uint64_t>()), work.at("cycles_an_instruction").get<double>(),
        work.at("core_hz").get<std::uint64_t>() / 1000000U);
    for (const auto& [device, kinds] : work.at("devices").items()) {
        if (kinds.contains("share")) {
            const json& share = kinds.at("share");
            text += goal_entry(share, fmt::format("{}: {:.1f} % of the core by <code>{}</code>", escaped(device),
                                                  100.0 * share.at("bus_load").get<double>(),
                                                  escaped(share.at("what").get<std::string>())));
        }
        for (const char* const kind : {"power_on", "command"}) {
            if (kinds.contains(kind) && kinds.at(kind).contains("ms")) {
                const json& one = kinds.at(kind);
                text += goal_entry(one, fmt::format("{}: {:.1f} ms of the core for the worst-case {}", escaped(device),
                                                    one.at("ms").get<double>(), word_of_kind(kind)));
            }
        }
        if (kinds.contains("tick") && kinds.at("tick").contains("load")) {
            const json& tick = kinds.at("tick");
            text += goal_entry(
                tick, fmt::format("{}: {:.1f} % of the core for the worst-case tick, one every {} ms", escaped(device),
                                  100.0 * tick.at("load").get<double>(), tick.at("period_us").get<double>() / 1000.0));
        }
    }
    return text +
           "</ul><p>Frames and ticks may each take half of the core. Commands (NMT resets, LSS back to waiting, store "
           "or restore) and a power-on have limits of their own: no claim covers a bus that is full of such "
           "commands.</p>\n";
}

std::string suites_words(const json& suites) {
    std::uint64_t tests = 0;
    std::uint64_t frames = 0;
    for (const auto& [image, one] : suites.at("images").items()) {
        tests += one.at("passed").get<std::uint64_t>();
        frames += one.at("frames").get<std::uint64_t>();
    }
    return fmt::format(
        "<p>{} tests passed on QEMU's STM32F405; {} frames compared with this machine, {} difference(s).</p>\n",
        grouped(tests), grouped(frames), suites.at("differences").get<std::uint64_t>());
}

}  // namespace

std::string write_target_html(const std::filesystem::path& build) {
    const json footprint = read_json(build / "footprint.json");
    const json suites = read_json(build / "suites.json");
    const json work = read_json(build / "work.json");
    std::string text = "<h2 id=\"target\">Performance and memory</h2>\n<p>STM32F405 (Cortex-M4F).</p>\n";
    if (footprint.is_null() && suites.is_null()) {
        return text + "<p class=open>Flash, RAM and tests were not measured in this build; ./test measures them.</p>\n";
    }
    text += footprint.is_null() ? "" : memory_table(footprint);
    text += suites.is_null() ? "" : suites_words(suites);
    text += work.is_null() ? "" : work_table(work);
    return text;
}

}  // namespace canproof::host
