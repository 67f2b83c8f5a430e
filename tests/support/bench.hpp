// One way to run a device in a test: frames as in a candump log, a fake clock, a memory that survives.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "firmware/devices/cbx_ao412.hpp"
#include "host/bus/candump.hpp"
#include "host/devices/memory.hpp"

namespace canproof::test {

using Frames = std::vector<std::string>;

/// A CAN-CBX-AO412 as node 3 on a bench. `send` gives its answers as text.
class CbxBench {
  public:
    explicit CbxBench(std::size_t memory_size = 1024) : memory{memory_size} {}

    /// Makes a device on the same memory and switches it on: what a power cycle is. Returns what it sends.
    Frames power_on() {
        queue = TransmitQueue{};
        device = std::make_unique<cbx_ao412::Device>(memory, queue, factory);
        device->power_on(inputs, now);
        return sent();
    }
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
    Frames set_inputs() {
        device->set_inputs(inputs, now);
        return sent();
    }
    Frames sent() {
        Frames all;
        while (!queue.empty()) {
            all.push_back(host::format_frame(queue.pop()));
        }
        return all;
    }
    float volts(int output) const { return device->outputs().aout[static_cast<std::size_t>(output - 1)]; }

    /// Writes by SDO and expects success.
    void write(const std::string& request) {
        const Frames answer = send(request);
        ASSERT_EQ(answer.size(), 1U) << request;
        EXPECT_EQ(answer[0].substr(0, 6), "583#60") << request << " was answered " << answer[0];
    }

    host::Memory memory;
    TransmitQueue queue;
    cbx_ao412::FactoryData factory{};
    cbx_ao412::Inputs inputs{};
    Instant now{};
    std::unique_ptr<cbx_ao412::Device> device;
};

/// A bench whose device has booted.
class CbxTest : public testing::Test, public CbxBench {
  protected:
    void SetUp() override { power_on(); }
};

}  // namespace canproof::test
