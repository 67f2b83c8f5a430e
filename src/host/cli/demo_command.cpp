// demo: the telegrams that the manuals print, sent to the devices, with their answers.
#include <fmt/format.h>

#include <sstream>

#include "host/cli/commands.hpp"
#include "host/replay/replay.hpp"

namespace canproof::host {

namespace {

struct Example {
    const char* section;
    const char* what;
    const char* frame;
};

// CAN-CBX-AO412 as node 3, as in the manual.
constexpr Example cbx_examples[] = {
    {"7.9.2", "read the device type 1000h", "603#4000100000000000"},
    {"7.10.2.3", "set output 1 to 5.0 V (3EB3h)", "603#2B116401B33E0000"},
    {"7.10.2.3", "set output 2 to -5.0 V (C14Dh)", "603#2B1164024DC10000"},
};

}  // namespace

int play_examples() {
    const auto device = make_device("cbx-ao412");
    fmt::print("CAN-CBX-AO412, node 3: the telegrams of its manual\n");
    Instant now{};
    device->power_on(now);
    while (!device->queue().empty()) {
        fmt::print("  {:<10}{:<34}{:<24}{}\n", "7.2", "boot-up", "", format_frame(device->queue().pop()));
    }
    for (const auto& example : cbx_examples) {
        now = now + milliseconds(10);
        device->receive(parse_frame(example.frame, example.section), now);
        const std::string answer = device->queue().empty() ? "(no answer)" : format_frame(device->queue().pop());
        fmt::print("  {:<10}{:<34}{:<24}{}\n", example.section, example.what, example.frame, answer);
    }
    const auto volts = device->outputs();
    fmt::print("  outputs: {:.3f} V, {:.3f} V, {:.3f} V, {:.3f} V\n", volts[0], volts[1], volts[2], volts[3]);
    return 0;
}

}  // namespace canproof::host
