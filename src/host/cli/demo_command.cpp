// demo: all four devices boot, and answer what their manuals print.
#include <fmt/format.h>

#include <vector>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/devices/simulated_device.hpp"

namespace canproof::host {

namespace {

struct Example {
    const char* section;
    const char* what;
    const char* frame;
};

struct Scene {
    const char* device;
    const char* title;
    const char* boot_section;
    std::vector<Example> examples;
};

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all{
        {"cbx-ao412",
         "CAN-CBX-AO412, node 3: the telegrams of its manual",
         "7.2",
         {{"7.9.2", "read the device type 1000h", "603#4000100000000000"},
          {"7.10.2.3", "set output 1 to 5.0 V (3EB3h)", "603#2B116401B33E0000"},
          {"7.10.2.3", "set output 2 to -5.0 V (C14Dh)", "603#2B1164024DC10000"}}},
        {"ax130751",
         "AX130751, node 127 as shipped",
         "3.1",
         {{"3.2.1", "read the device type 1000h", "67F#4000100000000000"},
          {"3.1", "LSS: configuration state", "7E5#0401000000000000"},
          {"3.1", "LSS: which node-ID?", "7E5#5E00000000000000"}}},
        {"ax188001",
         "AX188001, node 127 as shipped",
         "3.1",
         {{"3.2.1", "read the device type 1000h", "67F#4000100000000000"},
          {"3.3.7", "read thermocouple 1 as 7130h:1", "67F#4030710100000000"}}},
        {"ax060805",
         "AX060805, node 127 as shipped",
         "4.1",
         {{"4.2.1", "read the device type 1000h", "67F#4000100000000000"},
          {"4.2.2", "read the error register 1001h", "67F#4001100000000000"}}},
    };
    return all;
}

std::string next_frame(SimulatedDevice& device) {
    return device.queue().empty() ? "(silence)" : format_frame(device.queue().pop());
}

void play(const Scene& scene) {
    const auto device = make_device(scene.device);
    fmt::print("{}\n", scene.title);
    Instant now{};
    device->power_on(now);
    fmt::print("  {:<10}{:<36}{:<24}{}\n", scene.boot_section, "boot-up", "", next_frame(*device));
    for (const auto& example : scene.examples) {
        now = now + milliseconds(10);
        while (device->next_deadline() <= now) {
            device->advance(now);
        }
        while (!device->queue().empty()) {
            device->queue().pop();  // what it says of its own accord is not the answer
        }
        device->receive(parse_frame(example.frame, example.section), now);
        fmt::print("  {:<10}{:<36}{:<24}{}\n", example.section, example.what, example.frame, next_frame(*device));
    }
    if (std::string{scene.device} == "cbx-ao412") {
        const auto volts = device->outputs();
        fmt::print("  outputs: {:.3f} V, {:.3f} V, {:.3f} V, {:.3f} V\n", volts[0], volts[1], volts[2], volts[3]);
    }
}

}  // namespace

int play_examples() {
    for (const Scene& scene : scenes()) {
        play(scene);
    }
    return 0;
}

}  // namespace canproof::host
