#include <algorithm>
#include <cmath>

#include "firmware/devices/cbx_ao412.hpp"
#include "host/devices/simulated_device.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t eeprom_size = 256 * 4;  // the manual promises at least 256 bytes (2.2); two banks need more

class CbxAo412Simulation final : public SimulatedDevice {
  public:
    CbxAo412Simulation() : SimulatedDevice{eeprom_size}, device_{memory_, queue_, cbx_ao412::FactoryData{}} {}

    void set_node_id(int node_id) override {
        inputs_.switch_high = static_cast<std::uint8_t>(node_id / 16);
        inputs_.switch_low = static_cast<std::uint8_t>(node_id % 16);
    }
    void power_on(Instant now) override { device_.power_on(inputs_, now); }
    void receive(const Frame& frame, Instant now) override { device_.receive(frame, now); }
    void advance(Instant now) override { device_.advance(now); }
    Instant next_deadline() const override { return device_.next_deadline(); }

    bool set_input(const std::string& name, double value, Instant now) override {
        const auto whole = static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
        const bool truth = value != 0.0;
        if (name == "switch_high") {
            inputs_.switch_high = whole;
        } else if (name == "switch_low") {
            inputs_.switch_low = whole;
        } else if (name == "switch_baud") {
            inputs_.switch_baud = whole;
        } else if (name == "can_state") {
            inputs_.can_state = whole;
        } else if (name == "can_overrun") {
            inputs_.can_overrun = truth;
        } else if (name == "internal_fault") {
            inputs_.internal_fault = truth;
        } else {
            return false;
        }
        device_.set_inputs(inputs_, now);
        return true;
    }

    std::vector<double> outputs() const override {
        const auto& out = device_.outputs();
        std::vector<double> values(out.aout.begin(), out.aout.end());
        for (const bool lit : {out.led_e, out.led_s, out.led_m, out.led_p}) {
            values.push_back(lit ? 1.0 : 0.0);
        }
        return values;
    }
    const std::vector<std::string>& output_names() const override {
        static const std::vector<std::string> names{"aout1", "aout2", "aout3", "aout4",
                                                    "led_e", "led_s", "led_m", "led_p"};
        return names;
    }

  private:
    cbx_ao412::Inputs inputs_{};
    cbx_ao412::Device device_;
};

}  // namespace

std::unique_ptr<SimulatedDevice> make_device(const std::string& name) {
    return name == "cbx-ao412" ? std::make_unique<CbxAo412Simulation>() : nullptr;
}

}  // namespace canproof::host
