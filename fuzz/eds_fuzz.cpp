// EDS files of any bytes: refused with lines and mends, or a device that switches on, runs and is written and read back
// the same.
#include <algorithm>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "host/datasheet/read_eds.hpp"
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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const host::EdsResult read = host::read_eds({data, data + size}, "fuzz.eds");
    for (const host::Faults* all : {&read.faults, &read.notes}) {
        for (const host::Fault& one : *all) {
            require(one.place.line > 0 && !one.what.empty() && !one.mend.empty());
        }
    }
    if (!read.faults.empty()) {
        return 0;
    }
    run(read.part);
    // The first writing settles what a data sheet cannot say in two ways.
    const host::EdsResult again = host::read_eds(host::write_eds({}, read.part), "fuzz.eds");
    require(again.faults.empty());
    const std::string written = host::write_eds({}, again.part);
    const host::EdsResult last = host::read_eds(written, "fuzz.eds");
    require(last.faults.empty() && host::write_eds({}, last.part) == written);
    return 0;
}
