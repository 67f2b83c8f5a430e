// SPDX-License-Identifier: Apache-2.0
// Reads EDS files of any bytes. A file is refused with faults, each with a line and a fix, or it gives a device that
// switches on, runs, and is written and read back unchanged. The findings of `eds check` name
// existing lines. The automatic fixes of `eds check` come to an end and do not change the device.
#include <algorithm>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "host/base/input_error.hpp"
#include "host/datasheet/check/check_eds.hpp"
#include "host/datasheet/check/fix_eds.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_dbc.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/sim/devices/generic_simulation.hpp"

CANPROOF_FUZZ_CLAIMS()

namespace {

using namespace canproof;
using fuzz::require;

void run(const host::Part& part) {
    host::GenericSimulation device{part};
    Instant now{};
    device.power_on(now);
    for (int i = 0; i < 20 && device.next_deadline() != never; ++i) {
        now = now < device.next_deadline() ? device.next_deadline() : now;
        device.advance(now);
        require(device.next_deadline() > now);
        for (std::uint8_t sub = 0; sub < 3; ++sub) {
            Frame request = data_frame(0x600U + static_cast<std::uint32_t>(part.info.node_id), 8);
            const host::Object& object = part.objects[static_cast<std::size_t>(i) % part.objects.size()];
            request.data = {0x40, static_cast<std::uint8_t>(object.index),
                            static_cast<std::uint8_t>(object.index >> 8U), sub};
            device.receive(request, now);
        }
        while (!device.queue().empty()) {
            require(device.queue().pop().length <= max_frame_length);
        }
    }
}

std::vector<host::EdsFinding> findings_in(const std::string& text) {
    try {
        return host::check_eds(text, "fuzz.eds");
    } catch (const host::InputError&) {
        return {};
    }
}

void check(const std::string& text, const host::Part& part) {
    const auto lines = static_cast<unsigned>(std::count(text.begin(), text.end(), '\n') + 1);
    const std::vector<host::EdsFinding> found = findings_in(text);
    for (const host::EdsFinding& one : found) {
        require(one.line > 0 && one.line <= lines && !one.what.empty() && !one.fix.empty());
    }
    if (!found.empty()) {
        const host::EdsResult fixed = host::read_eds(host::fix_eds(text, "fuzz.eds").text, "fuzz.eds");
        require(fixed.faults.empty() && host::write_eds({}, fixed.part) == host::write_eds({}, part));
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const host::EdsResult read = host::read_eds({data, data + size}, "fuzz.eds");
    for (const host::Faults* all : {&read.faults, &read.notes}) {
        for (const host::Fault& one : *all) {
            require(one.place.line > 0 && !one.what.empty() && !one.fix.empty());
        }
    }
    if (!read.faults.empty()) {
        return 0;
    }
    run(read.part);
    check({data, data + size}, read.part);
    require(!host::write_dbc(read.part, 5).empty());
    // A data sheet can express some settings in two ways, of which write_eds() always chooses the same one. So
    // write_eds() must reproduce each file that it has written, but not each file that was read.
    const host::EdsResult again = host::read_eds(host::write_eds({}, read.part), "fuzz.eds");
    require(again.faults.empty());
    const std::string written = host::write_eds({}, again.part);
    const host::EdsResult last = host::read_eds(written, "fuzz.eds");
    require(last.faults.empty() && host::write_eds({}, last.part) == written);
    return 0;
}
