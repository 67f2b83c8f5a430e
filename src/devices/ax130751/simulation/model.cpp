// SPDX-License-Identifier: Apache-2.0
// The AX130751 in the catalogue: its simulation, figures and demo.
#include "devices/ax130751/simulation/converter_figures.hpp"
#include "devices/ax130751/simulation/simulation.hpp"
#include "devices/device_model.hpp"

namespace canproof::ax130751 {

namespace {

std::map<std::string, host::LinePlot> figures() {
    using namespace host;
    return {
        {"ax130751-joystick.svg", joystick_plot()},
        {"ax130751-trimmed-joystick.svg", trimmed_joystick_plot()},
        {"ax130751-thirty-slopes.svg", thirty_slopes_plot()},
    };
}

}  // namespace

const host::DeviceModel& model() {
    static const host::DeviceModel device{{"ax130771"},
                                          make_simulation,
                                          figures,
                                          {"AX130751, node 127 as shipped",
                                           "3.1",
                                           {{"3.2.1", "read the device type 1000h", "67F#4000100000000000"},
                                            {"3.1", "LSS: configuration state", "7E5#0401000000000000"},
                                            {"3.1", "LSS: which node-ID?", "7E5#5E00000000000000"}},
                                           {}},
                                          nullptr};
    return device;
}

}  // namespace canproof::ax130751
