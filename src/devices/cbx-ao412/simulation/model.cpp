// SPDX-License-Identifier: Apache-2.0
// The CBX-AO412 in the catalogue: its simulation, figures and demo.
#include "devices/cbx-ao412/simulation/output_figures.hpp"
#include "devices/cbx-ao412/simulation/simulation.hpp"
#include "devices/device_model.hpp"

namespace canproof::cbx_ao412 {

namespace {

std::map<std::string, host::LinePlot> figures() {
    using namespace host;
    return {
        {"cbx-ao412-outputs.svg", analog_outputs_plot()},
    };
}

}  // namespace

const host::DeviceModel& model() {
    static const host::DeviceModel device{{},
                                          make_simulation,
                                          figures,
                                          {"CAN-CBX-AO412, node 3: the telegrams of its manual",
                                           "7.2",
                                           {{"7.9.2", "read the device type 1000h", "603#4000100000000000"},
                                            {"7.10.2.3", "set output 1 to 5.0 V (3EB3h)", "603#2B116401B33E0000"},
                                            {"7.10.2.3", "set output 2 to -5.0 V (C14Dh)", "603#2B1164024DC10000"}},
                                           {"aout1", "aout2", "aout3", "aout4"}},
                                          nullptr};
    return device;
}

}  // namespace canproof::cbx_ao412
