// replay: files in, the device's frames out.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iostream>

#include "host/cli/commands.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

namespace {

std::ifstream open_input(const std::string& path) {
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        throw InputError{fmt::format("cannot read {}; name an existing file", path)};
    }
    return in;
}

void load_memory(Memory& memory, const std::string& path) {
    std::ifstream in{path, std::ios::binary};
    if (!in) {
        return;  // the first run makes the file
    }
    const std::vector<char> bytes{std::istreambuf_iterator<char>{in}, {}};
    if (bytes.size() != memory.size()) {
        throw InputError{
            fmt::format("{} has {} bytes and is no image of this device's memory ({} bytes); remove it or name another",
                        path, bytes.size(), memory.size())};
    }
    memory.bytes().assign(bytes.begin(), bytes.end());
}

void save_memory(Memory& memory, const std::string& path) {
    std::ofstream out{path, std::ios::binary};
    out.write(reinterpret_cast<const char*>(memory.bytes().data()), static_cast<std::streamsize>(memory.size()));
    if (!out.flush()) {
        throw InputError{fmt::format("cannot write {}", path)};
    }
}

}  // namespace

int replay_log(const ReplayOptions& options) {
    const auto device = make_device(options.device);
    if (device == nullptr) {
        throw InputError{fmt::format("{} cannot be run; `canproof devices` says which can", options.device)};
    }
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
    }
    if (options.until) {
        input.until = Instant{static_cast<std::uint64_t>(std::llround(*options.until * 1.0e6))};
    }
    if (options.node != 0) {
        device->set_node_id(options.node);
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
