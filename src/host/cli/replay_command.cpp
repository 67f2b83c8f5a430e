// replay: files in, the device's frames out.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "host/cli/chosen_devices.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

int replay_log(const ReplayOptions& options) {
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
        load_memory(device->memory(), options.nvm);
    }
    std::ofstream outputs;
    if (!options.outputs.empty()) {
        outputs.open(options.outputs);
        if (!outputs) {
            throw InputError{fmt::format("cannot write {}", options.outputs)};
        }
    }
    replay(*device, input, std::cout, options.outputs.empty() ? nullptr : &outputs);
    if (!options.nvm.empty()) {
        save_memory(device->memory(), options.nvm);
    }
    return 0;
}

}  // namespace canproof::host
