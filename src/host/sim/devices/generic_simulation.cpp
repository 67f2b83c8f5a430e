// SPDX-License-Identifier: Apache-2.0
#include "host/sim/devices/generic_simulation.hpp"

#include <algorithm>

namespace canproof::host {

namespace {

constexpr std::size_t bank_overhead = 64;  // bytes for header and CRC of one bank of parameters, with a reserve

/// Returns the size of the memory in bytes: two banks of parameters, each at most as long as the image of all values,
/// and the LSS record.
std::size_t memory_size(const Part& part) {
    return 2 * (image_size(part) + bank_overhead) + LssStore::size;
}

Signal input(const char* name, const char* type, double highest, const char* text) {
    Signal signal;
    signal.name = name;
    signal.input = true;
    signal.type = type;
    signal.minimum = 0.0;
    signal.maximum = highest;
    signal.text = text;
    return signal;
}

Part with_signals(Part part) {
    part.signals = {input("can_state", "UNSIGNED8", 3.0, "error active, warning, error passive, bus-off"),
                    input("can_overrun", "BOOLEAN", 1.0, "a frame was lost because the receive buffer was full")};
    return part;
}

}  // namespace

GenericSimulation::GenericSimulation(Part part)
    : SimulatedDevice{memory_size(part)},
      part_{with_signals(std::move(part))},
      device_{part_, memory_, queue_},
      store_{memory_},
      shipped_{static_cast<std::uint8_t>(part_.info.node_id), static_cast<std::uint32_t>(part_.info.bit_rate)} {
    std::vector<std::pair<std::uint16_t, std::uint8_t>> domains;
    for (const Object& object : part_.objects) {
        for (const Entry& entry : object.entries) {
            if (entry.type == "DOMAIN") {
                domains.emplace_back(object.index, entry.subindex);
            }
        }
    }
    for (const auto& [index, subindex] : domains) {
        device_.lend(index, subindex, std::min(domain_size, all_domains_size / domains.size()));
    }
    device_.store_in(store_);
}

void GenericSimulation::set_node_id(NodeId node_id) {
    shipped_.node_id = node_id.value();
}

void GenericSimulation::power_on(Instant now) {
    device_.power_on(store_.load(shipped_), now, can_state_, overrun_);
}

void GenericSimulation::receive(const Frame& frame, Instant now) {
    device_.receive(frame, now);
}

void GenericSimulation::advance(Instant now) {
    device_.advance(now);
}

bool GenericSimulation::set_input(const std::string& name, double value, Instant now) {
    if (name == "can_state") {
        can_state_ = static_cast<std::uint8_t>(value);
    } else if (name == "can_overrun") {
        overrun_ = value != 0.0;
    } else {
        return false;
    }
    device_.node().set_controller(can_state_, overrun_, now);
    return true;
}

const std::vector<std::string>& GenericSimulation::input_names() const {
    static const std::vector<std::string> names{"can_state", "can_overrun"};
    return names;
}

const std::vector<std::string>& GenericSimulation::output_names() const {
    static const std::vector<std::string> none;
    return none;
}

}  // namespace canproof::host
