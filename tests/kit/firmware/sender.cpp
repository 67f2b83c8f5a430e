// SPDX-License-Identifier: Apache-2.0
// Uses one function of each library of the shared firmware. Ends with status 0 when each function did what its header
// says.
#include <array>

#include "firmware/base/bytes.hpp"
#include "firmware/blocks/bounds.hpp"
#include "firmware/canopen/transmit_queue.hpp"

namespace {

/// Returns whether the emergency message overtakes the TPDO, which has waited longer.
bool has_priority() {
    constexpr std::uint32_t tpdo = 0x185U;
    constexpr std::uint32_t emergency = 0x085U;
    canproof::TransmitQueue queue;
    return queue.push(tpdo, 2U, 0x3412U) && queue.push(emergency, 0U, 0U) && (queue.pop().id == emergency) &&
           (queue.pop().id == tpdo);
}

/// Returns whether the bytes of a number go onto the bus in CANopen's order, the lowest first.
bool is_little_endian() {
    std::array<std::uint8_t, 2U> bytes{};
    canproof::write_le(canproof::MutableBytes{bytes.data(), bytes.size()}, 0U, 2U, 0x1234U);
    return (bytes[0] == 0x34U) && (bytes[1] == 0x12U);
}

}  // namespace

int main() {
    const bool is_clamped = canproof::lesser(2.0, 1.0) < 1.5;
    return (has_priority() && is_little_endian() && is_clamped) ? 0 : 1;
}
