// SPDX-License-Identifier: Apache-2.0
// canproof_scale FOLDER: measures how many AX130751 one core can simulate. Runs 1 to 2,000 devices, operational with
// default parameters, through a hundred seconds of virtual time. Writes a table, a plot and their description to
// FOLDER, as evidence (an exhibit) for the evidence pack (src/host/assess/evidence/exhibit.hpp). Exits with status 1
// when 1,000 devices are slower than real time, or when a device among 2,000 takes more than three times the CPU time
// of a device among 100.
#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "host/base/files.hpp"
#include "host/report/line_plot.hpp"
#include "tests/bench/fleet.hpp"

namespace {

constexpr double simulated_seconds = 100.0;
constexpr std::size_t required = 1000;

struct Measured {
    std::size_t devices{0};
    double processor_s{0.0};
    std::size_t frames{0};

    double times_real_time() const { return simulated_seconds / processor_s; }
    double microseconds_each() const { return processor_s * 1e6 / simulated_seconds / static_cast<double>(devices); }
};

Measured measure(std::size_t size) {
    canproof::bench::Fleet fleet{size};
    const std::clock_t begin = std::clock();
    const std::size_t frames = fleet.run(canproof::milliseconds(static_cast<std::uint64_t>(simulated_seconds * 1000)));
    return {size, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, frames};
}

/// Writes the table, the plot and their description to `folder`. Returns whether the simulation is as fast as the goals
/// require.
bool write_exhibit(const std::vector<Measured>& all, const std::filesystem::path& folder) {
    std::string csv = "devices,simulated s,processor s,frames,times real time,us of processor per device and second\n";
    canproof::host::Curve curve{"as shipped, operational", {}};
    for (const Measured& one : all) {
        csv += fmt::format("{},{:.0f},{:.4f},{},{:.1f},{:.1f}\n", one.devices, simulated_seconds, one.processor_s,
                           one.frames, one.times_real_time(), one.microseconds_each());
        curve.points.emplace_back(static_cast<double>(one.devices), one.processor_s * 1000.0 / simulated_seconds);
    }
    fmt::print("{}", csv);
    const auto of = [&all](std::size_t devices) {
        return *std::find_if(all.begin(), all.end(), [devices](const Measured& one) { return one.devices == devices; });
    };
    const Measured thousand = of(required);
    const double growth = all.back().microseconds_each() / of(100).microseconds_each();
    const bool holds = thousand.times_real_time() >= 1.0 && growth <= 3.0;
    const nlohmann::ordered_json exhibit{
        {"title", "Simulated devices per core"},
        {"state", holds ? "holds" : "open"},
        {"says", fmt::format("One core simulates 1,000 AX130751, operational with their configuration and PDOs as "
                             "shipped, {:.1f} times as fast as real time.",
                             thousand.times_real_time())},
        {"figures",
         {{"times real time, 1,000 devices", fmt::format("{:.1f}", thousand.times_real_time())},
          {"processor time per device and second", fmt::format("{:.1f} us", thousand.microseconds_each())},
          {fmt::format("a device of {} costs, against one of 100", all.back().devices),
           fmt::format("{:.2f} times as much", growth)}}},
        {"data", {"scale.csv"}}};
    canproof::host::write_file(folder / "scale.csv", csv);
    canproof::host::write_file(
        folder / "scale.svg",
        canproof::host::write_svg(
            {"AX130751 simulated on one core", "devices", "processor time for one second, ms", {curve}, {}},
            canproof::host::DrawnTitle::no));
    canproof::host::write_file(folder / "exhibit.json", exhibit.dump(1) + "\n");
    return holds;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "canproof_scale FOLDER: name the folder for table, plot and exhibit.json\n");
        return 2;
    }
    try {
        std::vector<Measured> all;
        for (const std::size_t size : {1U, 10U, 100U, 250U, 500U, 1000U, 2000U}) {
            all.push_back(measure(size));
        }
        return write_exhibit(all, argv[1]) ? 0 : 1;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
