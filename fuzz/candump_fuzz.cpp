// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a candump log. The reader must refuse the log and name the place of the fault, or the log must be
// the same after it is written and read again.
#include <sstream>

#include "firmware/base/time.hpp"
#include "fuzz/support/claims.hpp"
#include "fuzz/support/require.hpp"
#include "host/base/input_error.hpp"
#include "host/sim/bus/candump.hpp"

CANPROOF_FUZZ_CLAIMS()

namespace {

using namespace canproof;
using fuzz::require;

void check_line(const host::LoggedFrame& one) {
    require(one.frame.length <= max_frame_length && one.frame.id <= (one.frame.extended ? 0x1FFFFFFFU : 0x7FFU));
    const std::string text = host::format_candump_line(one);
    require(host::format_candump_line(host::parse_candump_line(text, "again")) == text);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream in{std::string{data, data + size}};
    try {
        Instant last{};
        for (const host::LoggedFrame& one : host::read_candump_log(in, "fuzz")) {
            require(last <= one.time);
            last = one.time;
            check_line(one);
        }
    } catch (const host::InputError& error) {
        require(std::string{error.what()}.rfind("fuzz:", 0) == 0);
    }
    return 0;
}
