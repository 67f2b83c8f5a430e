// SPDX-License-Identifier: Apache-2.0
// The host's interface to a simulated device: frames, named signals and virtual time.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "firmware/base/time.hpp"
#include "firmware/canopen/frame.hpp"
#include "firmware/canopen/object_dictionary.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "host/sim/devices/factory_values.hpp"
#include "host/sim/devices/memory.hpp"
#include "host/sim/devices/node_id.hpp"

namespace canproof::host {

/// A part of the memory of a device.
struct MemoryRegion {
    const char* name;
    std::uint8_t* data;
    std::size_t size;  ///< size in bytes
};

class SimulatedDevice {
  public:
    virtual ~SimulatedDevice() = default;

    /// Sets the node-ID where the device reads it from: its coding switches, or the value that LSS has stored.
    virtual void set_node_id(NodeId node_id) = 0;
    /// Sets the coding switches to any value, even to one that is no node-ID. Returns false when the device has no
    /// switches.
    virtual bool set_coding_switches(std::uint8_t) { return false; }
    virtual void power_on(Instant now) = 0;
    virtual void receive(const Frame& frame, Instant now) = 0;
    virtual void advance(Instant now) = 0;
    virtual Instant next_deadline() const = 0;
    /// Sets an input. Returns false when there is no input with this name.
    virtual bool set_input(const std::string& name, double value, Instant now) = 0;
    /// Returns the value of each input in the order of input_names(): the value that was set, or that the simulated
    /// plant has computed.
    virtual std::vector<double> inputs() const = 0;
    virtual const std::vector<std::string>& input_names() const = 0;
    /// Returns the value of each output, in the order of output_names().
    virtual std::vector<double> outputs() const = 0;
    virtual const std::vector<std::string>& output_names() const = 0;

    /// Returns the active node-ID; unconfigured_node_id when there is none.
    virtual std::uint8_t node_id() const = 0;
    virtual NmtState state() const = 0;
    /// Returns the bit rate of the CAN controller in bit/s, as the device's switches or LSS set it; 0 when the device
    /// does not set a bit rate.
    virtual std::uint32_t bit_rate() const = 0;
    /// Returns the present dictionary of the device; nullptr when the device does not expose it.
    virtual const ObjectDictionary* objects() const { return nullptr; }
    /// Returns the memory that contains the state of the firmware. Fault injection inverts bits in it. Returns nothing
    /// when the memory is not known.
    virtual std::vector<MemoryRegion> regions() { return {}; }

    TransmitQueue& queue() { return queue_; }
    Memory& memory() { return memory_; }

  protected:
    explicit SimulatedDevice(std::size_t memory_size) : memory_{memory_size} {}

    TransmitQueue queue_;
    Memory memory_;
};

}  // namespace canproof::host
