// SPDX-License-Identifier: Apache-2.0
// The `demo` command: boots each device of the catalogue and prints its answers to the examples in its manual.
#include "host/app/cli/demo_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "devices/catalogue.hpp"
#include "firmware/base/time.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/devices/advance_device.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

namespace {

std::string next_frame(SimulatedDevice& device) {
    return device.queue().empty() ? "(silence)" : format_frame(device.queue().pop());
}

/// Returns a text such as `5.000 V` for each of the named outputs.
std::vector<std::string> volts_of(const SimulatedDevice& device, const std::vector<std::string>& names) {
    const std::vector<double> values = device.outputs();
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::find(names.begin(), names.end(), device.output_names()[i]) != names.end()) {
            texts.push_back(fmt::format("{:.3f} V", values[i]));
        }
    }
    return texts;
}

void play(const DeviceModel& model) {
    const DemoScene& scene = model.demo;
    const auto device = model.make({});
    fmt::print("{}\n", scene.title);
    Instant now{};
    device->power_on(now);
    fmt::print("  {:<10}{:<36}{:<24}{}\n", scene.boot_section, "boot-up", "", next_frame(*device));
    for (const auto& example : scene.requests) {
        now = now + milliseconds(10);
        while (device->next_deadline() <= now) {
            advance_device(*device, scene.title, now);
        }
        while (!device->queue().empty()) {
            device->queue().pop();  // the device sends these frames by itself; they are not the answer
        }
        device->receive(parse_frame(example.frame, example.section), now);
        fmt::print("  {:<10}{:<36}{:<24}{}\n", example.section, example.what, example.frame, next_frame(*device));
    }
    if (!scene.outputs.empty()) {
        fmt::print("  outputs: {}\n", fmt::join(volts_of(*device, scene.outputs), ", "));
    }
}

}  // namespace

int play_examples() {
    for (const CatalogueEntry& entry : catalogue()) {
        play(*entry.model);
    }
    return 0;
}

}  // namespace canproof::host
