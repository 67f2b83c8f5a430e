// SPDX-License-Identifier: Apache-2.0
// Loads register files of any bytes. The reader must report faults, each with a place and a fix, or return a dictionary
// that a node can run and that can be written as an EDS file. Input: a byte that selects one of four files, then the
// text.
#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "generated/canopen/requirements.hpp"
#include "host/codegen/write_tables.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/datasheet/write_eds.hpp"
#include "host/register/load.hpp"
#include "host/register/spec_files.hpp"
#include "host/sim/devices/generic_simulation.hpp"
#include "tests/support/slave_register.hpp"

CANPROOF_FUZZ_CLAIMS()

namespace {

using namespace canproof;
using fuzz::require;

host::SpecFiles files_with(const std::uint8_t* data, std::size_t size) {
    host::SpecFiles files = test::slave_files();
    const char* const names[]{"spec/devices/slave/objects.toml", "spec/devices/slave/device.toml",
                              "spec/manuals/s.toml", "spec/devices/slave/behaviour/more.toml"};
    files[names[size == 0 ? 0 : data[0] % 4U]] = size == 0 ? std::string{} : std::string{data + 1, data + size};
    return files;
}

void run(const host::Part& part) {
    host::GenericSimulation device{part};
    device.power_on(Instant{});
    for (const host::Object& object : part.objects) {
        Frame request = data_frame(0x600U + static_cast<std::uint32_t>(part.info.node_id), 8);
        request.data = {0x40, static_cast<std::uint8_t>(object.index), static_cast<std::uint8_t>(object.index >> 8U)};
        device.receive(request, Instant{});
        while (!device.queue().empty()) {
            require(device.queue().pop().length <= max_frame_length);
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const host::LoadResult loaded = host::load_register(files_with(data, size));
    for (const host::Fault& one : loaded.faults) {
        require(one.place.file.rfind("spec/", 0) == 0 && !one.what.empty() && !one.fix.empty(), "a fault says all");
    }
    const host::Part* const part = loaded.content.part("slave");
    if (loaded.faults.empty() && part != nullptr) {
        run(*part);
        require(!host::write_eds(loaded.content, *part).empty() && !host::write_tables(loaded.content, *part).empty());
    }
    return 0;
}
