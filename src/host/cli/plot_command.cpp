// plot: what `--outputs` wrote as an SVG file.
#include <fstream>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/plot/output_plot.hpp"

namespace canproof::host {

int plot_outputs(const PlotOptions& options) {
    auto in = open_input(options.csv);
    const LinePlot plot = output_plot(in, options.csv, options.signals);
    std::ofstream out{options.svg};
    out << write_svg(plot);
    if (!out.flush()) {
        throw InputError{"cannot write " + options.svg + "; name a file in a folder that exists"};
    }
    return 0;
}

}  // namespace canproof::host
