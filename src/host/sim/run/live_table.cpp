// SPDX-License-Identifier: Apache-2.0
#include "host/sim/run/live_table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "firmware/base/time.hpp"
#include "host/base/time_text.hpp"
#include "host/sim/bus/candump.hpp"

namespace canproof::host {

namespace {

constexpr std::size_t notices_shown = 3;

std::string bus_line(const RunSession& session, Duration lag) {
    const BusReport report = session.bus().report(session.now());
    return fmt::format(
        "{}  {}  {}load {:.1f} %  {} frames{}  {} errors  latency < {:.3f} ms  {:.1f} s", session.bus().interface(),
        report.bit_rate == 0 ? std::string{"no bit rate"} : fmt::format("{} kbit/s", report.bit_rate / 1000),
        lag.us == 0 ? std::string{} : fmt::format("{:.1f} s BEHIND  ", static_cast<double>(lag.us) / 1.0e6),
        report.load * 100.0, report.frames, report.lost == 0 ? std::string{} : fmt::format("  {} lost", report.lost),
        report.errors, static_cast<double>(report.worst_latency.us) / 1000.0,
        static_cast<double>(session.now().us) / 1.0e6);
}

std::string node_line(const DeviceNode& node, const NodeTraffic& traffic) {
    const SimulatedDevice& device = node.device();
    const std::string id =
        device.node_id() == generated::canopen::unconfigured_node_id ? "none" : std::to_string(device.node_id());
    const std::string last = traffic.last ? fmt::format("{:>12} s  {}", format_seconds(traffic.last->time),
                                                        format_frame(traffic.last->frame))
                                          : "";
    return fmt::format("{:<16}{:>5}  {:<16}{:>9}  {}", node.name(), id, state_word(device.state()), traffic.frames,
                       last);
}

}  // namespace

const char* state_word(NmtState state) {
    switch (state) {
        case NmtState::initialising:
            return "initialising";
        case NmtState::stopped:
            return "stopped";
        case NmtState::operational:
            return "operational";
        case NmtState::pre_operational:
            return "pre-operational";
        default:
            return "?";
    }
}

std::vector<std::string> table_lines(const RunSession& session, const std::vector<std::string>& notices, TableSize size,
                                     Duration lag) {
    std::vector<std::string> lines{bus_line(session, lag), fmt::format("{:<16}{:>5}  {:<16}{:>9}  {}", "device", "node",
                                                                       "state", "frames", "last frame")};
    const std::size_t notice_rows = std::min(notices.size(), notices_shown);
    const std::size_t room =
        size.rows > lines.size() + notice_rows + 2 ? size.rows - lines.size() - notice_rows - 2 : 1;
    const std::size_t count = session.nodes().size();
    const std::size_t shown = count <= room ? count : room - 1;
    for (std::size_t i = 0; i < shown; ++i) {
        lines.push_back(node_line(*session.nodes()[i], session.traffic()[i]));
    }
    if (shown < count) {
        lines.push_back(fmt::format("… and {} more", count - shown));
    }
    lines.insert(lines.end(), notices.end() - static_cast<std::ptrdiff_t>(notice_rows), notices.end());
    for (std::string& line : lines) {
        line.resize(std::min(line.size(), size.columns));
    }
    return lines;
}

}  // namespace canproof::host
