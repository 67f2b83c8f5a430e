// What every bench has: a device, frames as in a candump log, a fake clock, a memory that survives.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "host/bus/candump.hpp"
#include "host/devices/memory.hpp"

namespace canproof::test {

using Frames = std::vector<std::string>;

/// Frames and time of a device that a derived bench makes and switches on.
template <typename Device>
class FrameBench {
  public:
    explicit FrameBench(std::size_t memory_size) : memory{memory_size} {}

    Frames send(const std::string& frame) {
        device->receive(host::parse_frame(frame, "test"), now);
        return sent();
    }
    /// Lets time pass; every deadline on the way is kept. Frames as `milliseconds:frame`, counted from the call.
    Frames pass(std::uint64_t ms) {
        const Instant start = now;
        const Instant end = now + milliseconds(ms);
        Frames all;
        while (device->next_deadline() <= end) {
            now = device->next_deadline() < now ? now : device->next_deadline();
            device->advance(now);
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

    host::Memory memory;
    TransmitQueue queue;
    Instant now{};
    std::unique_ptr<Device> device;
};

/// A device of the catalogue, with its physical inputs and what belongs to one unit.
template <typename Device, typename Inputs, typename FactoryData>
class UnitBench : public FrameBench<Device> {
  public:
    using FrameBench<Device>::FrameBench;

    /// Makes a device on the same memory and switches it on: what a power cycle is. Returns what it sends.
    Frames power_on() {
        this->queue = TransmitQueue{};
        this->device = std::make_unique<Device>(this->memory, this->queue, factory);
        this->device->power_on(inputs, this->now);
        return this->sent();
    }
    Frames set_inputs() {
        this->device->set_inputs(inputs, this->now);
        return this->sent();
    }

    FactoryData factory{};
    Inputs inputs{};
};

}  // namespace canproof::test
