// SPDX-License-Identifier: Apache-2.0
#include "host/selection/eds_device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/standard_streams.hpp"
#include "host/datasheet/read_eds.hpp"
#include "host/sim/devices/served_pdos.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t most_told = 100;

std::string faults_text(const Faults& faults) {
    std::string text;
    for (std::size_t i = 0; i < std::min(faults.size(), most_told); ++i) {
        text += faults[i].text() + "\n";
    }
    if (faults.size() > most_told) {
        text += fmt::format("… and {} more\n", faults.size() - most_told + faults.left_out());
    }
    return text;
}

}  // namespace

Part read_eds_part(const std::string& path) {
    EdsResult read = read_eds(read_file(path, longest_eds_file), path);
    if (!read.faults.empty()) {
        std::string all = faults_text(read.faults);
        all.pop_back();
        throw InputError{fmt::format("{} describes no device that can be run; fix its {} fault(s):\n{}", path,
                                     read.faults.size() + read.faults.left_out(), all)};
    }
    if (std::string notes = faults_text(read.notes); !notes.empty()) {
        notes.pop_back();
        tell(notes);
    }
    return std::move(read.part);
}

std::unique_ptr<GenericSimulation> read_eds_device(const std::string& path) {
    Part part = read_eds_part(path);
    check_served_pdos(part);
    return std::make_unique<GenericSimulation>(std::move(part));
}

}  // namespace canproof::host
