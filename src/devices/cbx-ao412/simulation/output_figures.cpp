// SPDX-License-Identifier: Apache-2.0
#include "devices/cbx-ao412/simulation/output_figures.hpp"

#include <sstream>

#include "devices/cbx-ao412/simulation/simulation.hpp"
#include "firmware/base/time.hpp"
#include "host/report/output_plot.hpp"
#include "host/sim/bus/candump.hpp"
#include "host/sim/replay/replay.hpp"

namespace canproof::cbx_ao412 {

using namespace host;

LinePlot analog_outputs_plot() {
    std::istringstream log{
        "(0.010000) can0 603#2B116401B33E0000\n"  // output 1 to 5.0 V
        "(0.020000) can0 603#2B1164024DC10000\n"  // output 2 to -5.0 V
        "(0.030000) can0 000#0103\n"
        "(0.040000) can0 303#0020B33EA041A041\n"
        "(0.050000) can0 303#0040B33E00E0A041\n"
        "(0.060000) can0 303#00604DC100C0A041\n"
        "(0.070000) can0 303#000000000000A041\n"
        "(0.080000) can0 303#0000000000000000\n"};
    const auto device = cbx_ao412::make_simulation();
    device->set_node_id(3);
    std::ostringstream frames;
    std::stringstream outputs;
    ReplayInput input;
    input.frames = read_candump_log(log, "example");
    input.until = Instant{90000};
    replay(*device, input, frames, &outputs);
    LinePlot plot = output_plot(outputs, "CBX-AO412", {"aout1", "aout2", "aout3", "aout4"});
    plot.title = "CAN-CBX-AO412: outputs set by SDO and by RPDO";
    plot.y_label = "voltage, V";
    return plot;
}

}  // namespace canproof::cbx_ao412
