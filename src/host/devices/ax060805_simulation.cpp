#include "firmware/devices/ax060805.hpp"
#include "generated/ax060805/constants.hpp"
#include "host/devices/devices.hpp"
#include "host/devices/simulation.hpp"
#include "host/plant/inclinometer_plant.hpp"

namespace canproof::host {

namespace {

namespace own = generated::ax060805;

constexpr std::size_t memory_size = 4096;  // two banks of parameters, and LSS at the end

class Ax060805Simulation final
    : public Simulation<ax060805::Device, ax060805::Inputs, ax060805::Outputs, ax060805::FactoryData> {
  public:
    Ax060805Simulation() : Simulation{memory_size} {}

    /// As if LSS had stored it; the bit rate stays.
    void set_node_id(NodeId node_id) override {
        LssStore store{memory_};
        LssConfiguration configuration = store.load({own::shipped_node_id, own::shipped_bit_rate});
        configuration.node_id = node_id.value();
        store.store(configuration);
    }
    void advance(Instant now) override {
        Simulation::advance(now);
        if (plant_.is_noisy(inputs_) && next_noise_ <= now) {
            next_noise_ = now + microseconds(own::sample_period_us);
            plant_.add_noise(inputs_);
            device_.set_inputs(inputs_, now);
        }
    }
    bool set_input(const std::string& name, double value, Instant now) override {
        if (!put_input(name, value)) {
            return false;
        }
        plant_.stimulus(name, inputs_);
        device_.set_inputs(inputs_, now);
        return true;
    }

  private:
    InclinometerPlant plant_;
    Instant next_noise_{};
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_ax060805() {
    return std::make_unique<Ax060805Simulation>();
}

}  // namespace canproof::host
