// SPDX-License-Identifier: Apache-2.0
#include "devices/cbx-ao412/simulation/simulation.hpp"

#include <fmt/format.h>

#include "devices/cbx-ao412/firmware/cbx_ao412.hpp"
#include "host/sim/devices/simulation.hpp"

namespace canproof::cbx_ao412 {

using namespace host;

namespace {

// The manual guarantees a memory of at least 256 bytes (2.2); two banks of parameters need more.
constexpr std::size_t eeprom_size = 256 * 4;

cbx_ao412::FactoryData factory_data(const FactoryValues& values) {
    cbx_ao412::FactoryData data;
    values.take("revision_number", data.revision);
    values.take("serial_number", data.serial_number);
    values.take("manufacturer_hardware_version", data.hardware_version);
    values.take("manufacturer_software_version", data.software_version);
    values.take("application_software_date", data.software_date);
    values.take("application_software_time", data.software_time);
    for (std::size_t i = 0; i < data.offset.size(); ++i) {
        values.take(fmt::format("calibration_offset_value_{}", i + 1), data.offset[i]);
        values.take(fmt::format("calibration_gain_value_{}", i + 1), data.gain[i]);
    }
    return data;
}

class CbxAo412Simulation final
    : public Simulation<cbx_ao412::Device, cbx_ao412::Inputs, cbx_ao412::Outputs, cbx_ao412::FactoryData> {
  public:
    explicit CbxAo412Simulation(const FactoryValues& factory) : Simulation{eeprom_size, factory_data(factory)} {}

    void set_node_id(NodeId node_id) override { set_coding_switches(node_id.value()); }
    bool set_coding_switches(std::uint8_t value) override {
        inputs_.switch_high = static_cast<std::uint8_t>(value / 16);
        inputs_.switch_low = static_cast<std::uint8_t>(value % 16);
        return true;
    }
    /// Returns the node-ID that the switches select; none when their position is not a node-ID.
    std::uint8_t node_id() const override {
        const int at_switches = device_.node_id();
        return NodeId{NodeId::is_one(at_switches) ? at_switches : NodeId::none}.value();
    }
};

}  // namespace

std::unique_ptr<host::SimulatedDevice> make_simulation(const host::FactoryValues& factory) {
    return std::make_unique<CbxAo412Simulation>(factory);
}

}  // namespace canproof::cbx_ao412
