// SPDX-License-Identifier: Apache-2.0
// A device whose clock, bus, terminals and parameter memory are simulated by a program on another machine. It executes
// one command at a time, and reports its state after each command (host/sim/image/message.hpp).
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "target/bridge/channel.hpp"
#include "target/bridge/host_memory.hpp"

namespace canproof::target {

/// Reads the time and then the inputs from a command. Returns the time.
template <typename Inputs>
Instant take_time_and_inputs(bridge::Message& command, Inputs& inputs) {
    const Instant now{command.take<std::uint64_t>()};
    for_each_input(inputs, [&command](const char*, auto& input) {
        input = static_cast<std::decay_t<decltype(input)>>(command.take<double>());
    });
    return now;
}

/// Makes the message that answers a command. `waiting` are the frames that wait to be sent.
template <typename Device>
bridge::Message make_state(const Device& device, TransmitQueue waiting, const std::uint32_t bit_rate) {
    bridge::Message message{bridge::Kind::state};
    message.put(device.next_deadline().us);
    message.put(device.node_id());
    message.put(device.state());
    message.put(bit_rate);
    message.put(static_cast<std::uint8_t>(waiting.boot_up_waits() ? 1U : 0U));
    message.put(static_cast<std::uint8_t>(waiting.size()));
    while (!waiting.empty()) {
        message.put_frame(waiting.pop());
    }
    for_each_output(device.outputs(),
                    [&message](const char*, const auto& output) { message.put(static_cast<double>(output)); });
    return message;
}

/// The image's side of the connection. `Inputs` and `Outputs` are the generated signal groups of the device; their
/// functions for_each_input() and for_each_output() are found in their namespace.
template <typename Device, typename Inputs, typename Outputs, typename FactoryData>
class Bridge {
  public:
    Bridge(Channel& channel, const std::size_t memory_size) : channel_{channel}, memory_{channel, memory_size} {}

    /// Executes commands until the program on the host has ended or sends a message that is not a valid command.
    void serve() {
        bridge::Message message;
        bool goes_on{true};
        while (goes_on) {
            goes_on = channel_.receive(message) && obey(message);
            if (goes_on) {
                message = make_state(device_, queue_, device_.bit_rate());
                goes_on = channel_.send(message);
            }
        }
    }

  private:
    bool obey(bridge::Message& command) {
        for (auto sent = command.take<std::uint8_t>(); sent != 0U; --sent) {
            static_cast<void>(queue_.pop());
        }
        switch (command.kind()) {
            case bridge::Kind::power_on: {
                const Instant now = take_time_and_inputs(command, inputs_);
                device_.power_on(inputs_, now);
                break;
            }
            case bridge::Kind::set_inputs: {
                const Instant now = take_time_and_inputs(command, inputs_);
                device_.set_inputs(inputs_, now);
                break;
            }
            case bridge::Kind::receive: {
                const Instant now{command.take<std::uint64_t>()};
                device_.receive(command.take_frame(), now);
                break;
            }
            case bridge::Kind::advance:
                device_.advance(Instant{command.take<std::uint64_t>()});
                break;
            case bridge::Kind::look:
                break;
            default:
                return false;
        }
        return command.is_sound();
    }

    Channel& channel_;
    HostMemory memory_;
    TransmitQueue queue_;
    Device device_{memory_, queue_, FactoryData{}};
    Inputs inputs_{};
};

/// Makes the first message of an image. `name` is the name of the device, at most 32 characters.
template <typename Inputs, typename Outputs>
bridge::Message greeting(const char* const name, const std::uint32_t protocol) {
    std::uint8_t inputs{0U};
    std::uint8_t outputs{0U};
    const Inputs any_inputs{};
    const Outputs any_outputs{};
    for_each_input(any_inputs, [&inputs](const char*, const auto&) { ++inputs; });
    for_each_output(any_outputs, [&outputs](const char*, const auto&) { ++outputs; });
    const std::size_t length = std::strlen(name);
    bridge::Message message{bridge::Kind::greeting};
    message.put(protocol);
    message.put(inputs);
    message.put(outputs);
    message.put(static_cast<std::uint8_t>(length));
    for (std::size_t i = 0U; i < length; ++i) {
        message.put(static_cast<std::uint8_t>(name[i]));
    }
    return message;
}

/// Sends the greeting and waits for its answer. Returns the size of the parameter memory; 0 when no answer came.
template <typename Inputs, typename Outputs>
std::size_t greet(Channel& channel, const char* const name, const std::uint32_t protocol) {
    bridge::Message message = greeting<Inputs, Outputs>(name, protocol);
    const bool answered = channel.send(message) && channel.receive(message) && (message.kind() == bridge::Kind::begin);
    return answered ? message.take<std::uint32_t>() : std::size_t{0U};
}

/// Runs the image: sends the greeting, then executes commands until the program on the host has ended.
template <typename Device, typename Inputs, typename Outputs, typename FactoryData>
void serve(Channel& channel, const char* const name) {
    const std::size_t memory_size = greet<Inputs, Outputs>(channel, name, bridge::protocol);
    if (memory_size != 0U) {
        Bridge<Device, Inputs, Outputs, FactoryData> bridge{channel, memory_size};
        bridge.serve();
    }
}

}  // namespace canproof::target
