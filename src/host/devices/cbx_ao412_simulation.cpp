#include <type_traits>

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
        bool found = false;
        generated::cbx_ao412::for_each_input(inputs_, [&](const char* one, auto& input) {
            if (name == one) {
                input = static_cast<std::decay_t<decltype(input)>>(value);
                found = true;
            }
        });
        if (found) {
            device_.set_inputs(inputs_, now);
        }
        return found;
    }

    std::vector<double> outputs() const override {
        std::vector<double> values;
        generated::cbx_ao412::for_each_output(
            device_.outputs(), [&](const char*, const auto& value) { values.push_back(static_cast<double>(value)); });
        return values;
    }
    const std::vector<std::string>& output_names() const override {
        static const std::vector<std::string> names = [] {
            std::vector<std::string> all;
            const cbx_ao412::Outputs any{};
            generated::cbx_ao412::for_each_output(any, [&](const char* name, const auto&) { all.emplace_back(name); });
            return all;
        }();
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
