#include "firmware/devices/ax130751.hpp"
#include "generated/ax130751/constants.hpp"
#include "host/devices/devices.hpp"
#include "host/devices/simulation.hpp"

namespace canproof::host {

namespace {

// Two banks of about 1.6 kB of parameters, and LSS at the end; the STM32F405 (chapter 4) has more.
constexpr std::size_t memory_size = 8192;

/// AX130751 and AX130771: one firmware (1018h:2 has one value for both).
class Ax130751Simulation final
    : public Simulation<ax130751::Device, ax130751::Inputs, ax130751::Outputs, ax130751::FactoryData> {
  public:
    Ax130751Simulation() : Simulation{memory_size} {}

    /// As if LSS had stored it; the bit rate stays.
    void set_node_id(NodeId node_id) override {
        namespace own = generated::ax130751;
        LssStore store{memory_};
        LssConfiguration configuration = store.load({own::shipped_node_id, own::shipped_bit_rate});
        configuration.node_id = node_id.value();
        store.store(configuration);
    }
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_ax130751() {
    return std::make_unique<Ax130751Simulation>();
}

}  // namespace canproof::host
