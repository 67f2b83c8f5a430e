#include "tests/conformance/zoo/loaded_target.hpp"

namespace canproof::test::zoo {

namespace {

constexpr double mean_bits = 85.0;  // of a frame with four bytes, the intermission included
constexpr std::uint64_t most_waiting = 16;

// Restricted identifiers (CiA 301, 7.3.5).
constexpr std::uint32_t first_high = 0x101;
constexpr std::uint32_t first_low = 0x6E0;
constexpr std::uint64_t ids_of_a_kind = 0x20;

}  // namespace

LoadedTarget::LoadedTarget(std::unique_ptr<host::SimulatedDevice> device, std::uint8_t node_id, double load,
                           std::uint64_t seed)
    : inner_{std::move(device), node_id}, load_{load}, generator_{seed} {
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

/// Returns a random gap from 0 to twice the mean.
Duration LoadedTarget::random_gap() {
    const double mean_us = mean_bits / static_cast<double>(inner_.bit_rate()) * 1.0e6 / load_;
    return microseconds(1 + draw(static_cast<std::uint64_t>(2.0 * mean_us)));
}

Frame LoadedTarget::random_frame() {
    const std::uint32_t first = draw(2) == 0 ? first_high : first_low;
    Frame frame = data_frame(first + static_cast<std::uint32_t>(draw(ids_of_a_kind)),
                             static_cast<std::uint8_t>(draw(max_frame_length + 1)));
    for (std::size_t at = 0; at < frame.length; ++at) {
        frame.data.at(at) = static_cast<std::uint8_t>(draw(256));
    }
    return frame;
}

}  // namespace canproof::test::zoo
