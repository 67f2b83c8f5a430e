// replay: files in, the device's frames out.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "host/cli/chosen_devices.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/devices/stored_memory_file.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

int replay_log(const ReplayOptions& options) {
    const ChosenDevice chosen = options.eds.empty() ? choose_device(options.device) : choose_eds(options.eds);
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
    if (options.node != 0) {
        device->set_node_id(options.node);
    }
    if (!options.nvm.empty()) {
        keep_in_file(device->memory(), options.nvm, [](const std::string& text) { fmt::print(stderr, "{}\n", text); });
    }
    std::ofstream outputs;
    if (!options.outputs.empty()) {
        outputs.open(options.outputs);
        if (!outputs) {
            throw InputError{fmt::format("cannot write {}", options.outputs)};
        }
    }
    replay(*device, input, std::cout, options.outputs.empty() ? nullptr : &outputs);
    return 0;
}

}  // namespace canproof::host
