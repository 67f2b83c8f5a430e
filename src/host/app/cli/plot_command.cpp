// SPDX-License-Identifier: Apache-2.0
// The `plot` command: draws an SVG plot of the CSV file that `--outputs` of `run`, `panel` or `replay` wrote.
#include "host/app/cli/plot_command.hpp"

#include "host/app/cli/same_file.hpp"
#include "host/base/files.hpp"
#include "host/report/output_plot.hpp"

namespace canproof::host {

int plot_outputs(const PlotOptions& options) {
    refuse_same_file({options.svg}, {options.csv});
    auto in = open_input(options.csv);
    const LinePlot plot = output_plot(in, options.csv, options.signals);
    write_file(options.svg, write_svg(plot));
    return 0;
}

}  // namespace canproof::host
