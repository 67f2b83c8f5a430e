// SPDX-License-Identifier: Apache-2.0
#include "host/assess/fuzz/finding_store.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "host/assess/fuzz/campaign_display.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

constexpr double replay_limit = 60.0;

void copy_over(const std::filesystem::path& from, const std::filesystem::path& to) {
    std::ifstream in{from, std::ios::binary};
    std::ostringstream bytes;
    if (!in || (in.peek() != std::ifstream::traits_type::eof() && !(bytes << in.rdbuf()))) {
        throw InputError{
            fmt::format("cannot read {}; check that the file exists and that you may read it", from.string())};
    }
    write_text(to, bytes.str());
}

/// Starts the target's replay program, which writes frames.log with all frames up to the failure. A target that sends
/// no CAN frames writes nothing. Does nothing when the replay program is not built.
void write_frames(const CampaignContext& context, const FoundInput& found, const std::filesystem::path& folder) {
    const auto program = std::filesystem::path{context.options.replay_build} / (found.target->name + "_fuzz");
    if (!std::filesystem::exists(program)) {
        return;
    }
    Task task;
    task.command = {std::filesystem::absolute(program).string(), "--frames", folder.string(),
                    (folder / "input").string()};
    task.log = context.files.log("frames-" + found.target->name);
    task.limit_seconds = replay_limit;
    run_tasks(
        {task}, 1, [] { return false; }, [] {});
}

std::string land(const CampaignContext& context, const FuzzTarget& target, const Finding& finding,
                 const std::filesystem::path& input) {
    const auto& elsewhere = context.options.land;
    if (!finding.reproduces || (elsewhere && elsewhere->empty())) {
        return "";
    }
    const auto folder = elsewhere ? std::filesystem::path{*elsewhere} / target.name : target.seeds;
    std::filesystem::create_directories(folder);
    const auto test = folder / ("found_" + finding.signature);
    copy_over(input, test);
    return test.string();
}

}  // namespace

void store_finding(const CampaignContext& context, const FoundInput& found) {
    Finding finding;
    finding.target = found.target->name;
    finding.title = found.failure.title();
    finding.signature = found.failure.signature();
    auto& all = context.state.findings;
    const auto known = std::find_if(all.begin(), all.end(), [&](const Finding& one) {
        return one.target == finding.target && one.signature == finding.signature;
    });
    if (known != all.end()) {
        known->times += found.times;
        return;
    }
    const auto folder = context.files.findings() / (finding.target + "-" + finding.signature);
    const auto before = read_json(folder / "finding.json");
    std::filesystem::create_directories(folder);
    copy_over(found.input, folder / "input");
    copy_over(found.output, folder / "output.txt");
    write_frames(context, found, folder);
    finding.first_seen = before.is_object() ? before.value("first_seen", utc_now()) : utc_now();
    finding.folder = folder.string();
    finding.pass = found.pass;
    finding.bytes = std::filesystem::file_size(found.input);
    finding.times = found.times;
    finding.reproduces = found.reproduces;
    finding.regression = land(context, *found.target, finding, found.input);
    write_json(folder / "finding.json", finding);
    context.display.say(fmt::format("FINDING {}: {}\n  {} ({} bytes, {} time(s)){}{}", finding.target, finding.title,
                                    finding.folder, finding.bytes, finding.times,
                                    finding.regression.empty() ? "" : "\n  kept as ", finding.regression));
    all.push_back(std::move(finding));
}

}  // namespace canproof::host
