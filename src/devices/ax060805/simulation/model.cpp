// SPDX-License-Identifier: Apache-2.0
// The AX060805 in the catalogue: its simulation, figures and demo.
#include "devices/ax060805/simulation/inclinometer_figures.hpp"
#include "devices/ax060805/simulation/sensor_keys.hpp"
#include "devices/ax060805/simulation/simulation.hpp"
#include "devices/device_model.hpp"

namespace canproof::ax060805 {

namespace {

std::map<std::string, host::LinePlot> figures() {
    using namespace host;
    return {
        {"ax060805-tumble.svg", tumble_plot()},
        {"ax060805-euler-tumble.svg", euler_tumble_plot()},
        {"ax060805-angle-error.svg", angle_error_plot()},
        {"ax060805-settling.svg", settling_plot()},
    };
}

}  // namespace

const host::DeviceModel& model() {
    static const host::DeviceModel device{{},
                                          make_simulation,
                                          figures,
                                          {"AX060805, node 127 as shipped",
                                           "4.1",
                                           {{"4.2.1", "read the device type 1000h", "67F#4000100000000000"},
                                            {"4.2.2", "read the error register 1001h", "67F#4001100000000000"}},
                                           {}},
                                          ax060805::sensor_keys};
    return device;
}

}  // namespace canproof::ax060805
