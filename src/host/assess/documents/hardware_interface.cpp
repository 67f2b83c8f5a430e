// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/hardware_interface.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/documents/words.hpp"

namespace canproof::host {

namespace {

std::string hazards_at(const Part& part, const std::string& id) {
    std::vector<std::string> ids;
    for (const auto& hazard : part.hazards) {
        if (std::find(hazard.at.begin(), hazard.at.end(), id) != hazard.at.end()) {
            ids.push_back(hazard.id);
        }
    }
    return joined_or(ids);
}

enum class SignalGroup { inputs, outputs, simulated };

SignalGroup group_of(const Part& part, const Signal& signal, const Analysis& analysis) {
    return is_simulated(analysis, part, signal.id) ? SignalGroup::simulated
           : signal.input                          ? SignalGroup::inputs
                                                   : SignalGroup::outputs;
}

DocumentTable signal_table(const Part& part, const Analysis& analysis, const SignalGroup group, const char* caption) {
    DocumentTable table{
        caption, {"Signal", "Type", "Unit", "Range", "At power-on", "Meaning", "Hazards", "Id", "Source"}, {}};
    for (const auto& signal : part.signals) {
        if (group_of(part, signal, analysis) == group) {
            table.rows.push_back({joined_or(signal.names()), signal.type, signal.unit,
                                  range_of(signal).empty() ? "every value of the type" : range_of(signal),
                                  to_text(signal.value), signal.text, hazards_at(part, signal.id), signal.id,
                                  joined_or(origins(signal))});
        }
    }
    return table;
}

Chapter factory_chapter(const Part& part) {
    DocumentTable table{"Factory data", {"Object", "Entry", "Type", "Default of a simulated unit"}, {}};
    for (const auto& object : part.objects) {
        for (const auto& entry : object.entries) {
            if (entry.factory) {
                table.rows.push_back({fmt::format("{:04X}h:{:02X}", object.index, entry.subindex),
                                      object.name + (object.kind == Object::Kind::var ? "" : ": " + entry.name),
                                      entry.type, to_text(entry.value)});
            }
        }
    }
    return {"Factory data",
            {table.rows.empty() ? "The device has no factory data."
                                : "Each unit has its own factory values. The table lists the values that a simulated "
                                  "unit has by default."},
            table.rows.empty() ? std::vector<DocumentTable>{} : std::vector<DocumentTable>{table}};
}

}  // namespace

Document hardware_interface(const Part& part, const Analysis& analysis) {
    const DocumentTable physical{
        "Requirements of kind physical", {"Requirement", "Text", "Source"}, requirement_rows(part, "physical")};
    return {
        "hardware-interface",
        fmt::format("Hardware-software interface of the {}", part.info.title),
        "The values between the firmware and its hardware, with type, unit, range and source. `canproof "
        "signals` prints the same list.",
        {Chapter{"Signals",
                 {"The firmware of a device has no drivers of its own. Time comes in as microseconds, frames go out "
                  "through a queue, and "
                  "physical inputs and outputs are plain data. A driver converts each signal to and from its hardware.",
                  "This document leaves out the drivers of the image: parameter memory, time base, CAN controller, "
                  "watchdog, self-tests and pins. src/target/README.md and the pages that it links describe them.",
                  "The range of an input is what the simulation accepts. Inputs that describe the simulated world "
                  "have a table of their own: no sensor of the device measures them."},
                 {signal_table(part, analysis, SignalGroup::inputs, "Inputs"),
                  signal_table(part, analysis, SignalGroup::outputs, "Outputs"),
                  signal_table(part, analysis, SignalGroup::simulated, "Inputs of the simulated world")}},
         Chapter{"Physical behaviour", {}, {physical}}, factory_chapter(part)}};
}

}  // namespace canproof::host
