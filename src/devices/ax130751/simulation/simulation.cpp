// SPDX-License-Identifier: Apache-2.0
#include "devices/ax130751/simulation/simulation.hpp"

#include "devices/ax130751/firmware/ax130751.hpp"
#include "generated/ax130751/constants.hpp"
#include "host/sim/devices/simulation.hpp"

namespace canproof::ax130751 {

using namespace host;

namespace {

// Two banks of about 1.6 kB of parameters, and the settings of LSS at the end; the STM32F405 (chapter 4) has more
// memory.
constexpr std::size_t memory_size = 8192;

ax130751::FactoryData factory_data(const FactoryValues& values) {
    ax130751::FactoryData data;
    values.take("revision_number", data.revision);
    values.take("serial_number", data.serial_number);
    values.take("configuration_date", data.made_on);
    values.take("configuration_time", data.made_at);
    return data;
}

/// The AX130751 or AX130771: both have the same firmware and the same product code in 1018h:2 (identity object).
class Ax130751Simulation final
    : public Simulation<ax130751::Device, ax130751::Inputs, ax130751::Outputs, ax130751::FactoryData> {
  public:
    explicit Ax130751Simulation(const FactoryValues& factory) : Simulation{memory_size, factory_data(factory)} {}

    void set_node_id(NodeId node_id) override {
        namespace own = generated::ax130751;
        store_node_id(node_id, {own::shipped_node_id, own::shipped_bit_rate});
    }
};

}  // namespace

std::unique_ptr<host::SimulatedDevice> make_simulation(const host::FactoryValues& factory) {
    return std::make_unique<Ax130751Simulation>(factory);
}

}  // namespace canproof::ax130751
