// SPDX-License-Identifier: Apache-2.0
// A device on CAN0 of a Zynq UltraScale+, and a relay on CAN1. The relay connects to a program on the host, which
// simulates the bus behind it, the terminals and the parameter memory (host/sim/image/message.hpp). Both controllers
// are on one bus. Every frame passes two drivers; the device's time is that of the core's timer.
#pragma once

#include "target/bridge/bridge.hpp"
#include "target/can_port.hpp"
#include "target/zynqmp_image/core_clock.hpp"
#include "target/zynqmp_image/device_loop.hpp"
#include "target/zynqmp_image/memory_map.hpp"

namespace canproof::target {

static_assert(is_can_port<zynqmp::Can>);

template <typename Device, typename Inputs, typename Outputs, typename FactoryData>
class Relay {
  public:
    Relay(Channel& channel, const std::size_t memory_size) : channel_{channel}, memory_{channel, memory_size} {}

    /// Executes commands until the program on the host has ended or sends a message that is not a valid command.
    void serve() {
        clock_.start();
        bridge::Message message;
        bool goes_on{true};
        while (goes_on) {
            goes_on = channel_.receive(message) && obey(message);
            if (goes_on) {
                settle();
                message = make_state(device_, to_host_, rate_in_registers());
                goes_on = channel_.send(message);
            }
        }
    }

  private:
    /// Most passes of the main loop after a command. Each frame and each step of a controller takes one pass; no
    /// command causes more frames than the queues hold.
    static constexpr std::uint32_t most_passes = 200U;

    bool obey(bridge::Message& command) {
        for (auto sent = command.take<std::uint8_t>(); sent != 0U; --sent) {
            static_cast<void>(to_host_.pop());
        }
        switch (command.kind()) {
            case bridge::Kind::power_on:
                clock_.sleep(take_time_and_inputs(command, inputs_));  // until this time the device has no power
                power_on();
                break;
            case bridge::Kind::set_inputs:
                run_until(take_time_and_inputs(command, inputs_));
                follow_controller();
                device_.set_inputs(inputs_, clock_.now());
                break;
            case bridge::Kind::receive:
                run_until(Instant{command.take<std::uint64_t>()});
                static_cast<void>(from_host_.push(command.take_frame()));
                break;
            case bridge::Kind::advance:
                run_until(Instant{command.take<std::uint64_t>()});
                break;
            case bridge::Kind::look:
                break;
            default:
                return false;
        }
        return command.is_sound();
    }

    /// Powers the device on with nothing in its queues and controllers.
    void power_on() {
        queue_ = TransmitQueue{};
        admitted_ = TransmitQueue{};
        to_host_ = TransmitQueue{};
        Frame old{};
        while (device_can_.receive(old) || host_can_.receive(old)) {
        }
        device_.power_on(inputs_, clock_.now());
        device_can_.set_bit_rate(device_.bit_rate(), clock_.now());
        host_can_.set_bit_rate(device_.bit_rate(), clock_.now());
    }

    /// Gives the device the more severe state of the two buses: the emulated one and that of the host.
    void follow_controller() {
        inputs_.can_state = std::max(inputs_.can_state, static_cast<std::uint8_t>(device_can_.state()));
        inputs_.can_overrun = device_can_.take_overrun() || inputs_.can_overrun;
    }

    /// Lets the device run until the time of a command: it sleeps between its deadlines.
    void run_until(const Instant time) {
        while (clock_.now() < time) {
            clock_.sleep(earliest(device_.next_deadline(), time));
            pass();
        }
    }

    void pass() {
        // QEMU's controllers send at once, and its bus drops a frame that no other controller can receive. On a real
        // bus one frame is sent at a time, and only when two nodes have joined. This function imitates that.
        if (host_can_.is_on_bus() && to_host_.empty() && admitted_.empty() && !queue_.empty()) {
            static_cast<void>(admitted_.push(queue_.pop()));
        }
        loop_.pass(admitted_, clock_.now());
        if (host_can_.bit_rate() != device_can_.bit_rate()) {
            host_can_.set_bit_rate(device_can_.bit_rate(), clock_.now());
        }
        host_can_.advance(device_can_.is_on_bus() ? from_host_ : no_frames_, clock_.now());
        Frame frame{};
        while (host_can_.receive(frame)) {
            keep(frame);
        }
    }

    /// Keeps a frame for the host. A boot-up message goes before others, as in the device's own queue.
    void keep(const Frame& frame) {
        constexpr std::uint32_t function = 0x780U;
        constexpr std::uint32_t error_control = 0x700U;
        if (((frame.id & function) == error_control) && (frame.length == 1U) && (frame.data[0U] == 0U)) {
            to_host_.push_boot_up(frame);
        } else {
            static_cast<void>(to_host_.push(frame));
        }
    }

    /// Lets the device and both controllers do what the command has caused.
    void settle() {
        bool busy{true};
        for (std::uint32_t count = 0U; busy && (count < most_passes); ++count) {
            pass();
            const bool joins = !device_can_.is_on_bus() || !host_can_.is_on_bus();
            const bool sends = !admitted_.empty() || !from_host_.empty() || (to_host_.empty() && !queue_.empty());
            const bool receives = device_registers_.interrupt_status.has(zynqmp::isr::not_empty);
            busy = joins || sends || receives || (device_.next_deadline() <= clock_.now());
        }
    }

    /// Returns the bit rate that the registers of the device's controller give; 0 when the controller is off the bus.
    std::uint32_t rate_in_registers() {
        const std::uint32_t clocks =
            zynqmp::clocks_of_bit(device_registers_.prescaler.read(), device_registers_.bit_timing.read());
        return device_can_.is_on_bus() ? ((zynqmp::can_clock_hz + (clocks / 2U)) / clocks) : 0U;
    }

    Channel& channel_;
    HostMemory memory_;
    CoreClock clock_;
    zynqmp::CanRegisters& device_registers_{zynqmp::registers_at<zynqmp::CanRegisters>(zynqmp::can0_address)};
    zynqmp::Can device_can_{device_registers_, zynqmp::can_clock_hz};
    zynqmp::Can host_can_{zynqmp::registers_at<zynqmp::CanRegisters>(zynqmp::can1_address), zynqmp::can_clock_hz};
    TransmitQueue queue_;      ///< frames that the device wants to send
    TransmitQueue admitted_;   ///< the one frame of the device that may go to the bus now
    TransmitQueue from_host_;  ///< frames that the host wants to send to the bus
    TransmitQueue no_frames_;
    TransmitQueue to_host_;  ///< frames that CAN1 has received, until the host has sent them on its bus
    Device device_{memory_, queue_, FactoryData{}};
    zynqmp::DeviceLoop<Device> loop_{device_, device_can_};
    Inputs inputs_{};
};

}  // namespace canproof::target
