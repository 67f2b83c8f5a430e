// SPDX-License-Identifier: Apache-2.0
// The part that the simulations of all devices have in common: signals by name, and the device itself.
#pragma once

#include <type_traits>

#include "firmware/canopen/lss_store.hpp"
#include "host/sim/devices/simulated_device.hpp"

namespace canproof::host {

/// `Inputs` and `Outputs` are the generated structures of the device's signals. for_each_input() and for_each_output()
/// are found in the namespace of these structures.
template <typename Device, typename Inputs, typename Outputs, typename FactoryData>
class Simulation : public SimulatedDevice {
  public:
    void power_on(Instant now) override { device_.power_on(inputs_, now); }
    void receive(const Frame& frame, Instant now) override { device_.receive(frame, now); }
    void advance(Instant now) override { device_.advance(now); }
    Instant next_deadline() const override { return device_.next_deadline(); }

    bool set_input(const std::string& name, double value, Instant now) override {
        const bool found = put_input(name, value);
        if (found) {
            device_.set_inputs(inputs_, now);
        }
        return found;
    }

    std::vector<double> inputs() const override {
        std::vector<double> values;
        for_each_input(inputs_, [&](const char*, const auto& value) { values.push_back(static_cast<double>(value)); });
        return values;
    }
    const std::vector<std::string>& input_names() const override {
        static const std::vector<std::string> names = [] {
            std::vector<std::string> all;
            const Inputs any{};
            for_each_input(any, [&](const char* name, const auto&) { all.emplace_back(name); });
            return all;
        }();
        return names;
    }

    std::vector<double> outputs() const override {
        std::vector<double> values;
        for_each_output(device_.outputs(),
                        [&](const char*, const auto& value) { values.push_back(static_cast<double>(value)); });
        return values;
    }
    const std::vector<std::string>& output_names() const override {
        static const std::vector<std::string> names = [] {
            std::vector<std::string> all;
            const Outputs any{};
            for_each_output(any, [&](const char* name, const auto&) { all.emplace_back(name); });
            return all;
        }();
        return names;
    }

    std::uint8_t node_id() const override { return device_.node_id(); }
    NmtState state() const override { return device_.state(); }
    std::uint32_t bit_rate() const override { return device_.bit_rate(); }
    const ObjectDictionary* objects() const override { return &device_.objects(); }
    std::vector<MemoryRegion> regions() override {
        // The firmware has no heap, so these objects contain its whole state.
        return {{"device", reinterpret_cast<std::uint8_t*>(&device_), sizeof(device_)},
                {"queue", reinterpret_cast<std::uint8_t*>(&queue_), sizeof(queue_)},
                {"store", memory_.bytes().data(), memory_.bytes().size()}};
    }

  protected:
    Simulation(std::size_t memory_size, const FactoryData& factory)
        : SimulatedDevice{memory_size}, device_{memory_, queue_, factory} {}

    /// Stores the node-ID as LSS does. Keeps the stored bit rate. If no bit rate is stored, stores that of `shipped`.
    void store_node_id(NodeId node_id, const LssConfiguration& shipped) {
        LssStore store{memory_};
        LssConfiguration configuration = store.load(shipped);
        configuration.node_id = node_id.value();
        store.store(configuration);
    }
    bool put_input(const std::string& name, double value) {
        bool found = false;
        for_each_input(inputs_, [&](const char* one, auto& input) {
            if (name == one) {
                input = static_cast<std::decay_t<decltype(input)>>(value);
                found = true;
            }
        });
        return found;
    }

    Inputs inputs_{};
    Device device_;
};

}  // namespace canproof::host
