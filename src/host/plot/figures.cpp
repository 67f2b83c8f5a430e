#include "host/plot/figures.hpp"

#include "host/plot/converter_figures.hpp"
#include "host/plot/inclinometer_figures.hpp"
#include "host/plot/output_plot.hpp"
#include "host/plot/thermocouple_figures.hpp"

namespace canproof::host {

std::map<std::string, LinePlot> all_figures() {
    return {
        {"ax060805-tumble.svg", tumble_plot()},
        {"ax060805-euler-tumble.svg", euler_tumble_plot()},
        {"ax060805-angle-error.svg", angle_error_plot()},
        {"ax060805-settling.svg", settling_plot()},
        {"ax130751-joystick.svg", joystick_plot()},
        {"ax130751-trimmed-joystick.svg", trimmed_joystick_plot()},
        {"ax130751-thirty-slopes.svg", thirty_slopes_plot()},
        {"ax188001-conversion-error.svg", conversion_error_plot()},
        {"ax188001-inverse-error.svg", inverse_error_plot()},
        {"ax188001-channel-error.svg", channel_error_plot()},
        {"ax188001-ramp.svg", ramp_plot()},
        {"cbx-ao412-outputs.svg", analog_outputs_plot()},
    };
}

}  // namespace canproof::host
