// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/campaign_state.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <numeric>
#include <system_error>

#include "host/base/input_error.hpp"
#include "host/base/replace_file.hpp"

namespace canproof::host {

double TargetRecord::last_gain() const {
    double at = 0.0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        at = samples[i].edges > samples[i - 1].edges ? samples[i].seconds : at;
    }
    return at;
}

std::uint64_t LineCoverage::lines() const {
    return std::accumulate(files.begin(), files.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const FileLines& file) { return sum + file.lines; });
}

std::uint64_t LineCoverage::hit() const {
    return std::accumulate(files.begin(), files.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const FileLines& file) { return sum + file.hit; });
}

std::uint64_t CampaignState::executions() const {
    return std::accumulate(targets.begin(), targets.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const TargetRecord& target) { return sum + target.executions; });
}

double CampaignState::seconds() const {
    return std::accumulate(targets.begin(), targets.end(), 0.0,
                           [](double sum, const TargetRecord& target) { return sum + target.seconds; });
}

nlohmann::json read_json(const std::filesystem::path& file) {
    std::ifstream in{file};
    if (!in) {
        return {};
    }
    try {
        return nlohmann::json::parse(in);
    } catch (const nlohmann::json::exception& error) {
        throw InputError{fmt::format("{} is no valid JSON ({}); remove this file", file.string(), error.what())};
    }
}

void write_text(const std::filesystem::path& file, const std::string& text) {
    try {
        replace_file(file, text);
    } catch (const std::system_error& error) {
        throw InputError{
            fmt::format("cannot write {}: {}; name another folder", file.string(), error.code().message())};
    }
}

void write_json(const std::filesystem::path& file, const nlohmann::json& content) {
    write_text(file, content.dump(1) + "\n");
}

std::string minutes_text(double minutes) {
    return fmt::format("{:.6g} minutes", minutes);
}

std::string utc_now() {
    return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
}

}  // namespace canproof::host
