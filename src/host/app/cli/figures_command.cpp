// SPDX-License-Identifier: Apache-2.0
// The `figures` command: draws plots of how the devices behave.
#include "host/app/cli/figures_command.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "devices/catalogue.hpp"
#include "host/base/files.hpp"

namespace canproof::host {

int draw_figures(const std::string& folder) {
    for (const auto& [file, plot] : all_figures()) {
        const auto path = std::filesystem::path{folder} / file;
        write_file(path, write_svg(plot));
        fmt::print("{}: {}\n", path.string(), plot.title);
    }
    return 0;
}

}  // namespace canproof::host
