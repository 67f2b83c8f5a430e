// replay: files in, the device's frames out.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "host/cli/chosen_devices.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/cli/output_file.hpp"
#include "host/devices/stored_memory_file.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

int replay_log(const ReplayOptions& options) {
    std::ios::sync_with_stdio(false);  // else a read error of standard input looks like its end
    FactoryOptions factory{options.factory};
    ChosenDevice chosen = options.eds.empty() ? choose_device(options.device, factory) : choose_eds(options.eds);
    factory.check_used();
    SimulatedDevice* const device = chosen.device.get();
    ReplayInput input;
    if (options.log == "-") {
        input.frames = read_candump_log(std::cin, "standard input");
    } else {
        auto in = open_input(options.log);
        input.frames = read_candump_log(in, options.log);
    }
    if (!options.stimulus.empty()) {
        auto in = open_input(options.stimulus);
        input.stimuli = read_stimuli(in, options.stimulus);
        check_stimuli(input.stimuli, {chosen.part});
    }
    if (options.until) {
        input.until = Instant{static_cast<std::uint64_t>(std::llround(*options.until * 1.0e6))};
    }
    if (options.node) {
        set_node(chosen, *options.node);
    }
    if (!chosen.notice.empty()) {
        fmt::print(stderr, "{}\n", chosen.notice);
    }
    if (!options.nvm.empty()) {
        keep_in_file(device->memory(), options.nvm, [](const std::string& text) { fmt::print(stderr, "{}\n", text); });
    }
    OutputFile outputs{options.outputs};
    OutputFile::open({&outputs}, {options.log, options.stimulus});
    replay(*device, input, std::cout, outputs.stream());
    outputs.finish();
    return 0;
}

}  // namespace canproof::host
