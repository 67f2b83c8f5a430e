#include "host/cli/prepared_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "host/bus/candump.hpp"
#include "host/cli/files.hpp"
#include "host/cli/make_bus.hpp"

namespace canproof::host {

namespace {

std::vector<ChosenDevice> chosen_devices(const RunOptions& options) {
    std::vector<ChosenDevice> all;
    for (const auto& text : options.devices) {
        all.push_back(choose_device(text));
    }
    for (const auto& text : options.eds) {
        all.push_back(choose_eds(text));
    }
    if (all.empty()) {
        all = choose_catalogue();
    }
    std::set<std::string> names;
    for (const ChosenDevice& one : all) {
        if (!names.insert(one.name).second) {
            throw InputError{fmt::format("{} is named twice; write NAME@NODE with different node-IDs", one.name)};
        }
    }
    return all;
}

/// `device.signal` must name a device that runs; the rest is checked as without it.
void check_targets(const std::vector<Stimulus>& stimuli, const std::vector<ChosenDevice>& devices) {
    std::vector<const Part*> parts;
    for (const ChosenDevice& one : devices) {
        if (one.part != nullptr) {
            parts.push_back(one.part);
        }
    }
    for (Stimulus one : stimuli) {
        const auto point = one.signal.rfind('.');
        if (point == std::string::npos) {
            check_stimuli({one}, parts);
            continue;
        }
        const std::string name = one.signal.substr(0, point);
        const auto found =
            std::find_if(devices.begin(), devices.end(), [&](const auto& device) { return device.name == name; });
        if (found == devices.end() || found->part == nullptr) {
            throw InputError{fmt::format("{}: no device {} with signals runs here", one.where, name)};
        }
        one.signal = one.signal.substr(point + 1);
        check_stimuli({one}, {found->part});
    }
}

std::vector<Stimulus> read_stimulus_file(const std::string& path, const std::vector<ChosenDevice>& devices) {
    if (path.empty()) {
        return {};
    }
    auto in = open_input(path);
    std::vector<Stimulus> stimuli = read_stimuli(in, path);
    check_targets(stimuli, devices);
    return stimuli;
}

}  // namespace

PreparedRun::PreparedRun(const RunOptions& options, std::ostream* frames, SessionObserver* observer,
                         NoticeListener notice)
    : nvm_folder_{options.nvm}, stimulus_{options.stimulus}, log_{options.log}, outputs_{options.outputs} {
    std::vector<ChosenDevice> devices = chosen_devices(options);
    std::vector<Stimulus> stimuli = read_stimulus_file(options.stimulus, devices);
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    std::uint32_t bit_rate = 0;
    for (ChosenDevice& one : devices) {
        load_own_memory(one);
        bit_rate = bit_rate == 0 ? one.bit_rate : bit_rate;
        parts_.push_back(one.part);
        nodes.push_back(std::make_unique<DeviceNode>(one.name, std::move(one.device)));
    }
    std::unique_ptr<Bus> bus = make_bus(options, bit_rate);
    bus->on_notice(std::move(notice));
    SessionOutputs outputs;
    outputs.frames = frames;
    outputs.log = log_.stream();
    outputs.log_format = log_format(options.log, options.log_marks);
    outputs.outputs = outputs_.stream();
    outputs.observer = observer;
    session_ = std::make_unique<RunSession>(std::move(bus), std::move(nodes), std::move(stimuli), outputs);
}

std::string PreparedRun::memory_file(const std::string& name) const {
    return (std::filesystem::path{nvm_folder_} / (name + ".bin")).string();
}

void PreparedRun::load_own_memory(ChosenDevice& one) const {
    if (!nvm_folder_.empty()) {
        std::filesystem::create_directories(nvm_folder_);
        load_memory(one.device->memory(), memory_file(one.name));
    }
}

void PreparedRun::open_outputs() {
    OutputFile::open({&log_, &outputs_}, {stimulus_});
}

void PreparedRun::flush() {
    log_.flush();
    outputs_.flush();
}

void PreparedRun::finish() {
    for (const auto& node : session_->nodes()) {
        if (!nvm_folder_.empty()) {
            save_memory(node->device().memory(), memory_file(node->name()));
        }
    }
    log_.finish();
    outputs_.finish();
}

}  // namespace canproof::host
