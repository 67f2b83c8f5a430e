// SPDX-License-Identifier: Apache-2.0
#include "host/app/cli/prepared_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "host/app/cli/make_bus.hpp"
#include "host/app/cli/same_file.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/devices/stored_memory_file.hpp"
#include "host/sim/run/device_names.hpp"

namespace canproof::host {

namespace {

std::vector<ChosenDevice> chosen_devices(const RunOptions& options) {
    std::vector<ChosenDevice> all;
    FactoryOptions factory{options.factory};
    for (const auto& text : options.devices) {
        all.push_back(choose_device(text, factory));
    }
    for (const auto& text : options.eds) {
        all.push_back(choose_eds(text));
    }
    for (const auto& text : options.arm) {
        all.push_back(choose_image(text));
    }
    if (all.empty()) {
        all = choose_catalogue(factory);
    }
    factory.check_used();
    std::set<std::string> names;
    for (const ChosenDevice& one : all) {
        if (!names.insert(one.name).second) {
            throw InputError{fmt::format(
                "two devices of this run have the name {}; write NAME@NODE or FILE@NODE with different node-IDs",
                one.name)};
        }
    }
    return all;
}

const ChosenDevice& target_of(const Stimulus& one, const std::vector<std::string>& names,
                              const std::vector<ChosenDevice>& devices) {
    try {
        return devices[find_device(names, one.signal.substr(0, one.signal.rfind('.')))];
    } catch (const InputError& error) {
        throw InputError{fmt::format("{}: {}", one.where, error.what())};
    }
}

/// Checks each stimulus (a timed change of an input) against the devices of the run. In `device.signal`, replaces a
/// short device name by the complete name. Throws InputError when the named device lacks the signal or, without a
/// device name, when all devices lack it.
void check_targets(std::vector<Stimulus>& stimuli, const std::vector<ChosenDevice>& devices) {
    std::vector<const Part*> parts;
    std::vector<std::string> names;
    for (const ChosenDevice& one : devices) {
        names.push_back(one.name);
        if (one.part != nullptr) {
            parts.push_back(one.part);
        }
    }
    for (Stimulus& one : stimuli) {
        const auto point = one.signal.rfind('.');
        if (point == std::string::npos) {
            check_stimuli({one}, parts);
            continue;
        }
        const ChosenDevice& device = target_of(one, names, devices);
        Stimulus plain = one;
        plain.signal = one.signal.substr(point + 1);
        check_stimuli({plain}, {device.part});
        one.signal = device.name + "." + plain.signal;
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

/// Returns the file that keeps the device's non-volatile memory in `folder`.
std::string memory_file(const ChosenDevice& one, const std::string& folder) {
    return std::filesystem::path{folder} / (one.name + ".bin");
}

/// Returns the files that the run reads or keeps. None of them may be the log or the outputs.
std::vector<std::string> inputs_of(const RunOptions& options, const std::vector<ChosenDevice>& devices) {
    std::vector<std::string> all{options.stimulus};
    for (const auto* const texts : {&options.eds, &options.arm}) {
        for (const std::string& text : *texts) {
            all.push_back(file_of(text));
        }
    }
    for (const ChosenDevice& one : devices) {
        all.push_back(options.nvm.empty() ? "" : memory_file(one, options.nvm));
    }
    return all;
}

/// Keeps the device's non-volatile memory in a file of `folder`. Creates a missing folder. Does nothing when `folder`
/// is empty.
void keep_memory(const ChosenDevice& one, const std::string& folder, const NoticeListener& notice) {
    if (!folder.empty()) {
        make_folder(folder);
        keep_in_file(one.device->memory(), memory_file(one, folder), notice);
    }
}

}  // namespace

PreparedRun::PreparedRun(const RunOptions& options, std::ostream* frames, SessionObserver* observer,
                         NoticeListener notice)
    : notice_{std::move(notice)}, log_{options.log}, outputs_{options.outputs} {
    if (options.log_marks && log_format(options.log, true) != LogFormat::marked) {
        throw InputError{
            fmt::format("--log-marks applies only to a candump log, and {} is none; remove --log-marks", options.log)};
    }
    std::vector<ChosenDevice> devices = chosen_devices(options);
    std::vector<Stimulus> stimuli = read_stimulus_file(options.stimulus, devices);
    inputs_ = inputs_of(options, devices);
    refuse_same_file({options.log, options.outputs}, inputs_);
    std::vector<std::unique_ptr<DeviceNode>> nodes;
    std::uint32_t bit_rate = 0;
    for (ChosenDevice& one : devices) {
        keep_memory(one, options.nvm, notice_);
        if (!one.notice.empty()) {
            notice_(one.notice);
        }
        bit_rate = bit_rate == 0 ? one.bit_rate : bit_rate;
        parts_.push_back(one.part);
        nodes.push_back(std::make_unique<DeviceNode>(one.name, std::move(one.device)));
    }
    std::unique_ptr<Bus> bus = make_bus(options, bit_rate);
    bus->on_notice(notice_);
    SessionOutputs outputs;
    outputs.frames = frames;
    outputs.log = log_.stream();
    outputs.log_format = log_format(options.log, options.log_marks);
    outputs.outputs = outputs_.stream();
    outputs.observer = observer;
    session_ = std::make_unique<RunSession>(std::move(bus), std::move(nodes), std::move(stimuli), outputs);
}

void PreparedRun::open_outputs() {
    OutputFile::open({&log_, &outputs_}, inputs_);
}

void PreparedRun::tell_node_ids() {
    for (const std::string& text : clashes_.found(session_->nodes())) {
        notice_(text);
    }
}

void PreparedRun::flush() {
    started_ = started_ || !is_joining(session_->bus());
    if (!started_) {
        return;  // the run may still fail to start, and then leaves the files as they are
    }
    log_.flush();
    outputs_.flush();
}

void PreparedRun::finish() {
    log_.finish();
    outputs_.finish();
}

}  // namespace canproof::host
