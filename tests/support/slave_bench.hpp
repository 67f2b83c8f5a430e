// The conformance slave on a bench: frames as in a candump log, a fake clock, a memory that survives.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/bus/candump.hpp"
#include "host/devices/generic_device.hpp"
#include "host/devices/memory.hpp"
#include "support/slave_register.hpp"

namespace canproof::test {

using Frames = std::vector<std::string>;

/// Node 5 with every service. `send` gives its answers as text: `585#6000200100000000`.
class SlaveBench {
  public:
    static constexpr std::uint16_t program_index = 0x2400;  ///< the DOMAIN, and the memory that the slave lends for it
    static constexpr std::size_t program_size = 65536;

    SlaveBench() { power_on(); }

    /// Makes the slave anew on the same memory and switches it on: what a power cycle is. Returns what it sends.
    Frames power_on() {
        queue = TransmitQueue{};
        slave = std::make_unique<host::GenericDevice>(slave_part(), memory, queue);
        slave->lend(program_index, 0, program_size);
        slave->power_on(node_id, now);
        return sent();
    }
    Frames send(const std::string& frame) {
        slave->receive(host::parse_frame(frame, "test"), now);
        return sent();
    }
    /// Lets time pass; every deadline on the way is kept. Frames as `milliseconds:frame`, counted from the call.
    Frames pass(std::uint64_t ms) {
        const Instant start = now;
        const Instant end = now + milliseconds(ms);
        Frames all;
        while (slave->next_deadline() <= end) {
            now = slave->next_deadline() < now ? now : slave->next_deadline();
            slave->advance(now);
            for (const auto& frame : sent()) {
                all.push_back(std::to_string(elapsed(start, now).us / 1000) + ":" + frame);
            }
        }
        now = end;
        return all;
    }
    Frames sent() {
        Frames all;
        while (!queue.empty()) {
            all.push_back(host::format_frame(queue.pop()));
        }
        return all;
    }

    std::uint8_t node_id{5};
    host::Memory memory{4096};
    TransmitQueue queue;
    Instant now{};
    std::unique_ptr<host::GenericDevice> slave;
};

}  // namespace canproof::test
