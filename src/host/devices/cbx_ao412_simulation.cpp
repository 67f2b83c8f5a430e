#include "firmware/devices/cbx_ao412.hpp"
#include "host/devices/devices.hpp"
#include "host/devices/simulation.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t eeprom_size = 256 * 4;  // the manual promises at least 256 bytes (2.2); two banks need more

class CbxAo412Simulation final
    : public Simulation<cbx_ao412::Device, cbx_ao412::Inputs, cbx_ao412::Outputs, cbx_ao412::FactoryData> {
  public:
    CbxAo412Simulation() : Simulation{eeprom_size} {}

    void set_node_id(NodeId node_id) override { set_coding_switches(node_id.value()); }
    bool set_coding_switches(std::uint8_t value) override {
        inputs_.switch_high = static_cast<std::uint8_t>(value / 16);
        inputs_.switch_low = static_cast<std::uint8_t>(value % 16);
        return true;
    }
    /// Switches at no node-ID give none.
    std::uint8_t node_id() const override {
        const int at_switches = device_.node_id();
        return NodeId{NodeId::is_one(at_switches) ? at_switches : NodeId::none}.value();
    }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_cbx_ao412() {
    return std::make_unique<CbxAo412Simulation>();
}

}  // namespace canproof::host
