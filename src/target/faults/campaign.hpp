// SPDX-License-Identifier: Apache-2.0
// A campaign of faults in an emulated processor. This is the interface between the device and the harness. The memory
// and registers of the device (subject.hpp) get the faults. The harness (campaign.cpp) injects them and judges their
// effects. The harness has its own flash, RAM and stack, which get no faults.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"

namespace canproof::faults {

/// Virtual time of a pass of the main loop.
constexpr std::uint64_t pass_us = 100;
constexpr std::size_t most_inputs = 24;
constexpr std::size_t most_bytes = 128;  ///< largest size of the Inputs or Outputs of a device

/// A line of the workload: a frame to the device, or new values of all inputs. The script `run` writes it.
struct Event {
    std::uint32_t time_us;
    std::uint32_t is_frame;
    std::uint32_t id;
    std::uint32_t length;
    std::array<std::uint8_t, 8> data;
    std::array<double, most_inputs> values;
};

using RawBytes = std::array<std::uint8_t, most_bytes>;

/// A part of the RAM that gets faults.
struct Area {
    const void* begin;
    std::size_t size;
};

/// The device with its main loop. Its functions run on the stack of the device.
class Subject {
  public:
    virtual void power_on(bool with_tests) = 0;
    virtual void pass() = 0;
    /// Returns the number of the self-test that failed; 0 when none did.
    virtual std::uint32_t failed() const = 0;
    /// Returns how often the tests of flash and RAM have been completed: the smaller of the two numbers.
    virtual std::uint32_t tested() const = 0;
    virtual void convert(const Event& event, RawBytes& inputs) const = 0;
    /// Sets the bits of `mask` that belong to a member of the outputs; the bits of padding stay 0.
    virtual void mask_outputs(RawBytes& mask) const = 0;
    /// Returns the parts of the RAM that get faults: device, queue, parameter memory, main loop with self-tests.
    virtual std::array<Area, 4> areas() const = 0;

  protected:
    ~Subject() = default;
};

/// Returns the device; each image has one.
Subject& subject();

// The functions by which the harness replaces the device's drivers.
Instant time_now();
bool take_frame(Frame& frame);
void frame_sent(const Frame& frame);
void outputs_driven(const void* outputs, std::size_t size);
const RawBytes& present_inputs();
void set_can_bit_rate(std::uint32_t rate);
std::uint32_t can_bit_rate();

}  // namespace canproof::faults
