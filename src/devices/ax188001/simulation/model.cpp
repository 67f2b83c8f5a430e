// SPDX-License-Identifier: Apache-2.0
// The AX188001 in the catalogue: its simulation, figures and demo.
#include "devices/ax188001/simulation/simulation.hpp"
#include "devices/ax188001/simulation/thermocouple_figures.hpp"
#include "devices/device_model.hpp"

namespace canproof::ax188001 {

namespace {

std::map<std::string, host::LinePlot> figures() {
    using namespace host;
    return {
        {"ax188001-conversion-error.svg", conversion_error_plot()},
        {"ax188001-inverse-error.svg", inverse_error_plot()},
        {"ax188001-channel-error.svg", channel_error_plot()},
        {"ax188001-ramp.svg", ramp_plot()},
    };
}

}  // namespace

const host::DeviceModel& model() {
    static const host::DeviceModel device{{},
                                          make_simulation,
                                          figures,
                                          {"AX188001, node 127 as shipped",
                                           "3.1",
                                           {{"3.2.1", "read the device type 1000h", "67F#4000100000000000"},
                                            {"3.3.7", "read thermocouple 1 as 7130h:1", "67F#4030710100000000"}},
                                           {}},
                                          nullptr};
    return device;
}

}  // namespace canproof::ax188001
