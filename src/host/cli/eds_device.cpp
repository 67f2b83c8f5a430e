#include "host/cli/eds_device.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iterator>

#include "host/bus/candump.hpp"
#include "host/cli/files.hpp"
#include "host/eds/read_eds.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t most_told = 100;

std::string told(const Faults& faults) {
    std::string text;
    for (std::size_t i = 0; i < std::min(faults.size(), most_told); ++i) {
        text += faults[i].text() + "\n";
    }
    if (faults.size() > most_told) {
        text += fmt::format("… and {} more\n", faults.size() - most_told);
    }
    return text;
}

}  // namespace

std::unique_ptr<GenericSimulation> read_eds_device(const std::string& path) {
    if (std::filesystem::is_directory(path)) {
        throw InputError{fmt::format("{} is a folder; name an EDS file", path)};
    }
    auto in = open_input(path);
    const std::string text{std::istreambuf_iterator<char>{in}, {}};
    EdsResult read = read_eds(text, path);
    if (!read.faults.empty()) {
        std::string all = told(read.faults);
        all.pop_back();
        throw InputError{fmt::format("{} cannot be run, {} fault(s):\n{}", path, read.faults.size(), all)};
    }
    fmt::print(stderr, "{}", told(read.notes));
    return std::make_unique<GenericSimulation>(std::move(read.part));
}

}  // namespace canproof::host
