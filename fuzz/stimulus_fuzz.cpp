// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as stimuli (changes of physical inputs). The reader must refuse them and name the place of the fault,
// or return changes in time order with finite values. If the values also pass the check of the devices, they are within
// the range of an input.
#include <cmath>
#include <sstream>

#include "firmware/base/time.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "host/base/input_error.hpp"
#include "host/register/embedded_spec.hpp"
#include "host/register/load.hpp"
#include "host/sim/replay/stimulus.hpp"

CANPROOF_FUZZ_CLAIMS()

namespace {

using namespace canproof;
using fuzz::require;

std::vector<const host::Part*> find_devices() {
    static const host::LoadResult loaded = host::load_register(host::embedded_spec());
    std::vector<const host::Part*> all;
    for (const host::Part& part : loaded.content.parts) {
        if (part.is_device()) {
            all.push_back(&part);
        }
    }
    return all;
}

const std::vector<const host::Part*>& devices() {
    static const std::vector<const host::Part*> all = find_devices();
    return all;
}

/// Returns whether any device has an input that accepts this stimulus.
bool is_taken(const host::Stimulus& one) {
    for (const host::Part* device : devices()) {
        for (const host::Signal& signal : device->signals) {
            for (const std::string& name : signal.names()) {
                const bool fits = (!signal.minimum || one.value >= *signal.minimum) &&
                                  (!signal.maximum || one.value <= *signal.maximum);
                if (signal.input && name == one.signal && fits) {
                    return true;
                }
            }
        }
    }
    return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in{std::string{data, data + size}};
    try {
        const std::vector<host::Stimulus> read = host::read_stimuli(in, "fuzz");
        Instant last{};
        for (const host::Stimulus& one : read) {
            require(last <= one.time && std::isfinite(one.value) && one.where.rfind("fuzz:", 0) == 0);
            require(one.signal.find(',') == std::string::npos);
            last = one.time;
        }
        host::check_stimuli(read, devices());
        for (const host::Stimulus& one : read) {
            require(is_taken(one));
        }
    } catch (const host::InputError& error) {
        require(std::string{error.what()}.rfind("fuzz:", 0) == 0);
    }
    return 0;
}
