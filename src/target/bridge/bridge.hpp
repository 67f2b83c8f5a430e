// SPDX-License-Identifier: Apache-2.0
// A device whose clock, bus, terminals and parameter memory are simulated by a program on another machine. It executes
// one command at a time, and reports its state after each (host/sim/image/message.hpp).
#pragma once

#include "firmware/base/time.hpp"
#include "firmware/canopen/transmit_queue.hpp"
#include "target/bridge/channel.hpp"
#include "target/bridge/host_memory.hpp"

namespace canproof::target {

/// The image's side of the connection. `Inputs` and `Outputs` are the generated signal groups of the device; their
/// functions for_each_input() and for_each_output() are found in their namespace.
template <typename Device, typename Inputs, typename Outputs, typename FactoryData>
class Bridge {
  public:
    Bridge(Channel& channel, const std::size_t memory_size) : channel_{channel}, memory_{channel, memory_size} {}

    /// Executes commands until the program has ended or sends a message that is no valid command.
    void serve() {
        bridge::Message message;
        bool goes_on{true};
        while (goes_on) {
            goes_on = channel_.receive(message) && obey(message);
            if (goes_on) {
                message = state();
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
                const Instant now = time_and_inputs(command);
                device_.power_on(inputs_, now);
                break;
            }
            case bridge::Kind::set_inputs: {
                const Instant now = time_and_inputs(command);
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

    Instant time_and_inputs(bridge::Message& command) {
        const Instant now{command.take<std::uint64_t>()};
        for_each_input(inputs_, [&command](const char*, auto& input) {
            input = static_cast<std::decay_t<decltype(input)>>(command.take<double>());
        });
        return now;
    }

    bridge::Message state() const {
        bridge::Message message{bridge::Kind::state};
        message.put(device_.next_deadline().us);
        message.put(device_.node_id());
        message.put(device_.state());
        message.put(device_.bit_rate());
        message.put(static_cast<std::uint8_t>(queue_.boot_up_waits() ? 1U : 0U));
        message.put(static_cast<std::uint8_t>(queue_.size()));
        TransmitQueue waiting = queue_;
        while (!waiting.empty()) {
            message.put_frame(waiting.pop());
        }
        for_each_output(device_.outputs(),
                        [&message](const char*, const auto& output) { message.put(static_cast<double>(output)); });
        return message;
    }

    Channel& channel_;
    HostMemory memory_;
    TransmitQueue queue_;
    Device device_{memory_, queue_, FactoryData{}};
    Inputs inputs_{};
};

/// Makes the first message of an image. `name` is the name of the device, at most 32 characters.
template <typename Inputs, typename Outputs>
bridge::Message greeting(const char* const name) {
    std::uint8_t inputs{0U};
    std::uint8_t outputs{0U};
    const Inputs any_inputs{};
    const Outputs any_outputs{};
    for_each_input(any_inputs, [&inputs](const char*, const auto&) { ++inputs; });
    for_each_output(any_outputs, [&outputs](const char*, const auto&) { ++outputs; });
    const std::size_t length = std::strlen(name);
    bridge::Message message{bridge::Kind::greeting};
    message.put(bridge::protocol);
    message.put(inputs);
    message.put(outputs);
    message.put(static_cast<std::uint8_t>(length));
    for (std::size_t i = 0U; i < length; ++i) {
        message.put(static_cast<std::uint8_t>(name[i]));
    }
    return message;
}

/// Runs the image: sends the greeting, takes the size of the parameter memory, and serves commands until the program
/// has ended.
template <typename Device, typename Inputs, typename Outputs, typename FactoryData>
void serve(Channel& channel, const char* const name) {
    bridge::Message message = greeting<Inputs, Outputs>(name);
    if (channel.send(message) && channel.receive(message) && (message.kind() == bridge::Kind::begin)) {
        Bridge<Device, Inputs, Outputs, FactoryData> bridge{channel, message.take<std::uint32_t>()};
        bridge.serve();
    }
}

}  // namespace canproof::target
