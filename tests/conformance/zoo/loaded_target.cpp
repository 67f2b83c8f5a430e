// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/zoo/loaded_target.hpp"

#include <array>

namespace canproof::test::zoo {

namespace {

constexpr double mean_bits = 85.0;  // mean length of a frame with four data bytes in bits, with the intermission after
                                    // it
constexpr std::uint64_t most_waiting = 16;

// Restricted identifiers (CiA 301, 7.3.5): 101h to 120h have high priority on the bus, 6E0h to 6FFh low priority.
constexpr std::uint32_t first_high = 0x101;
constexpr std::uint32_t first_low = 0x6E0;
constexpr std::uint64_t ids_of_a_kind = 0x20;

constexpr std::uint8_t foreign_node = 0x4D;
/// Base identifiers of the services that every node has: EMCY, four TPDOs and RPDOs, SDO, error control.
constexpr std::array<std::uint32_t, 12> services{0x080, 0x180, 0x200, 0x280, 0x300, 0x380,
                                                 0x400, 0x480, 0x500, 0x580, 0x600, 0x700};
constexpr std::uint32_t parameter_group = 0x18FEF100;  // a 29-bit identifier as SAE J1939 uses it

}  // namespace

LoadedTarget::LoadedTarget(std::unique_ptr<host::SimulatedDevice> device, std::uint8_t node_id, double load,
                           std::uint64_t seed)
    : inner_{std::move(device), node_id}, node_id_{node_id}, load_{load}, generator_{seed} {
    inner_.listen([this](const host::conform::FrameRecord& record) { tell(record); });
}

void LoadedTarget::advance(Instant until) {
    inner_.advance(earliest(until, next_));
    if (inner_.now() < next_) {
        return;
    }
    next_ = inner_.now() + random_gap();
    if (inner_.waiting() < most_waiting) {
        inner_.send(random_frame());
    }
}

/// Returns a random gap between two frames: 0 to twice the mean gap.
Duration LoadedTarget::random_gap() {
    const double mean_us = mean_bits / static_cast<double>(inner_.bit_rate()) * 1.0e6 / load_;
    return microseconds(1 + draw(static_cast<std::uint64_t>(2.0 * mean_us)));
}

Frame LoadedTarget::random_frame() {
    Frame frame = data_frame(0U, static_cast<std::uint8_t>(draw(max_frame_length + 1)));
    for (std::size_t at = 0; at < frame.length; ++at) {
        frame.data.at(at) = static_cast<std::uint8_t>(draw(256));
    }
    switch (draw(6)) {
        case 0:
            frame.id = first_high + static_cast<std::uint32_t>(draw(ids_of_a_kind));
            break;
        case 1:
            frame.id = first_low + static_cast<std::uint32_t>(draw(ids_of_a_kind));
            break;
        case 2:  // a 29-bit frame whose identifier has the value of an 11-bit identifier of the slave
            frame.id = services.at(draw(services.size())) + node_id_;
            frame.extended = true;
            break;
        case 3:
            frame.id = parameter_group + static_cast<std::uint32_t>(draw(256));
            frame.extended = true;
            break;
        case 4:  // NMT command start or enter pre-operational, for another node
            frame = data_frame(0U, 2U);
            frame.data[0] = draw(2) == 0 ? 0x01 : 0x80;
            frame.data[1] = foreign_node;
            break;
        default:
            frame.id = services.at(draw(services.size())) + foreign_node;
            break;
    }
    return frame;
}

}  // namespace canproof::test::zoo
