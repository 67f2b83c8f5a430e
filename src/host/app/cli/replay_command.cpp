// SPDX-License-Identifier: Apache-2.0
// The `replay` command: reads a log and prints the frames that the device sends.
#include "host/app/cli/replay_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "host/app/cli/output_file.hpp"
#include "host/app/cli/same_file.hpp"
#include "host/base/files.hpp"
#include "host/base/standard_streams.hpp"
#include "host/selection/chosen_devices.hpp"
#include "host/selection/own_stimuli.hpp"
#include "host/sim/devices/stored_memory_file.hpp"
#include "host/sim/replay/replay.hpp"

namespace canproof::host {

namespace {

std::optional<Instant> instant_of(const std::optional<double>& seconds) {
    if (!seconds) {
        return std::nullopt;
    }
    return Instant{static_cast<std::uint64_t>(std::llround(*seconds * 1.0e6))};
}

void tell_counts(const LogCounts& counts) {
    if (counts.error_frames != 0) {
        tell(fmt::format("the log contains {} error frame(s), which no node receives", counts.error_frames));
    }
    if (counts.coded_lengths != 0) {
        tell(fmt::format("the log contains {} frame(s) with a length code above 8, which are received as eight bytes",
                         counts.coded_lengths));
    }
}

}  // namespace

int replay_log(const ReplayOptions& options) {
    std::ios::sync_with_stdio(false);  // otherwise a read error of standard input looks like the end of the input
    FactoryOptions factory{options.factory};
    ChosenDevice chosen = options.eds.empty() ? choose_device(options.device, factory) : choose_eds(options.eds);
    factory.check_used();
    SimulatedDevice* const device = chosen.device.get();
    ReplayInput input;
    std::ifstream file;
    if (options.log != "-") {
        file = open_input(options.log);
    }
    CandumpReader log{options.log == "-" ? std::cin : file, options.log == "-" ? "standard input" : options.log};
    input.source = [&log](LoggedFrame& frame) { return log.next(frame); };
    input.notice = tell;
    if (!options.stimulus.empty()) {
        auto in = open_input(options.stimulus);
        OwnStimuli own = own_stimuli(read_stimuli(in, options.stimulus), chosen, options.node);
        input.stimuli = std::move(own.stimuli);
        if (!own.others.empty()) {
            tell(fmt::format("{}: the stimuli of other devices are left out: {}", options.stimulus,
                             fmt::join(own.others, ", ")));
        }
    }
    input.start = instant_of(options.start);
    input.until = instant_of(options.until);
    if (options.node) {
        set_node(chosen, *options.node);
    }
    if (!chosen.notice.empty()) {
        tell(chosen.notice);
    }
    const std::vector<std::string> inputs{options.log == "-" ? "" : options.log, options.stimulus,
                                          file_of(options.eds)};
    refuse_same_file({options.outputs, options.nvm}, inputs);
    if (!options.nvm.empty()) {
        keep_in_file(device->memory(), options.nvm, tell);
    }
    OutputFile outputs{options.outputs};
    OutputFile::open({&outputs}, inputs);
    replay(*device, input, std::cout, outputs.stream());
    outputs.finish();
    tell_counts(log.counts());
    return 0;
}

}  // namespace canproof::host
