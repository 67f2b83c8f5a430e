// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/failure_modes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/assess/documents/words.hpp"

namespace canproof::host {

namespace {

bool is_of(const FailureMode& one, const Part& part) {
    return std::find(one.devices.begin(), one.devices.end(), part.name) != one.devices.end();
}

const FailureMode* record_of(const Analysis& analysis, const Part& part, const std::string& signal,
                             const std::string& mode) {
    const auto found =
        std::find_if(analysis.failure_modes.begin(), analysis.failure_modes.end(), [&](const FailureMode& one) {
            return is_of(one, part) && one.mode == mode &&
                   std::find(one.signals.begin(), one.signals.end(), signal) != one.signals.end();
        });
    return found == analysis.failure_modes.end() ? nullptr : &*found;
}

std::string codes_of(const Register& content, const Part& part, const FailureMode& one) {
    std::vector<std::string> words;
    for (const auto& error : one.errors) {
        words.push_back(fmt::format("{} {}", emergency_code(content, part, error), error));
    }
    return joined_or(words, missing);
}

std::vector<std::string> row_of(const Register& content, const Part& part, const std::string& what,
                                const std::string& mode, const FailureMode* record) {
    if (record == nullptr) {
        return {what, mode, missing, missing, missing, ""};
    }
    return {what,
            mode,
            joined_or(record->detected, missing),
            joined_or(record->reaction, missing),
            codes_of(content, part, *record),
            record->note};
}

DocumentTable input_table(const Register& content, const Part& part, const Analysis& analysis) {
    DocumentTable table{"Inputs", {"Signal", "Failure mode", "Detected by", "Reaction", "EMCY", "Note"}, {}};
    for (const auto& signal : part.signals) {
        if (is_simulated(analysis, part, signal.id)) {
            continue;
        }
        for (const auto& mode : modes_of(signal)) {
            table.rows.push_back(row_of(content, part, fmt::format("{} ({})", joined_or(signal.names()), signal.id),
                                        mode, record_of(analysis, part, signal.id, mode)));
        }
    }
    return table;
}

DocumentTable message_table(const Register& content, const Part& part, const Analysis& analysis) {
    DocumentTable table{"Messages and memory", {"What", "Failure mode", "Detected by", "Reaction", "EMCY", "Note"}, {}};
    for (const auto& one : analysis.failure_modes) {
        if (is_of(one, part) && !one.at.empty()) {
            table.rows.push_back(row_of(content, part, one.at, one.mode, &one));
        }
    }
    return table;
}

DocumentTable output_table(const Part& part) {
    DocumentTable table{"Outputs", {"At", "Effect", "Failure", "Prevented by", "Safe state"}, {}};
    for (const auto& hazard : part.hazards) {
        for (const auto& failure : hazard.failures) {
            table.rows.push_back({joined_or(hazard.at), fmt::format("{}: {}", hazard.id, hazard.text), failure.text,
                                  joined_or(failure.prevented_by, "not prevented: " + failure.reason),
                                  hazard.safe_state});
        }
    }
    return table;
}

}  // namespace

Document failure_modes(const Register& content, const Part& part, const Analysis& analysis) {
    Document made{
        "failure-modes",
        fmt::format("Software FMEA of the {}, a skeleton", part.info.title),
        "The requirements that detect each failure mode of an input, the reaction of the device, and the emergency "
        "message. The failures of the outputs come from the hazards of the register.",
        {Chapter{
             "Inputs, messages and memory",
             {"The modes follow from the type of a signal. A real number can be too low, too high, NaN, or plausible "
              "and wrong. Any other number can be outside its range, or plausible and wrong. A switch can be stuck.",
              "`missing` means that the analysis records no requirement or no emergency message. It does not mean that "
              "the device behaves wrongly. Failures inside the processor appear only in the table of outputs."},
             {input_table(content, part, analysis), message_table(content, part, analysis)}},
         Chapter{"Outputs",
                 {"The register lists these failures of outputs and messages with its hazards."},
                 {output_table(part)}}}};
    made.chapters.front().text.push_back(
        fmt::format("{} cells of this document contain `missing`.", count_missing(made)));
    return made;
}

}  // namespace canproof::host
