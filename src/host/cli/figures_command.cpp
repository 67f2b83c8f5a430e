// figures: what the devices do, drawn.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/plot/figures.hpp"

namespace canproof::host {

int draw_figures(const std::string& folder) {
    std::filesystem::create_directories(folder);
    for (const auto& [file, plot] : all_figures()) {
        const auto path = std::filesystem::path{folder} / file;
        std::ofstream out{path};
        out << write_svg(plot);
        if (!out.flush()) {
            throw InputError{fmt::format("cannot write {}", path.string())};
        }
        fmt::print("{}: {}\n", path.string(), plot.title);
    }
    return 0;
}

}  // namespace canproof::host
