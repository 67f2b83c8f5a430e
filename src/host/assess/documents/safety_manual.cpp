// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/safety_manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "host/assess/documents/applicability.hpp"
#include "host/assess/documents/words.hpp"

namespace canproof::host {

namespace {

Chapter device_chapter(const Register& content, const Part& part) {
    DocumentTable table{"The device", {"What", "Which"}, {}};
    table.rows = {
        {"Device", part.info.title},
        {"Manufacturer of the original", part.info.vendor},
        {"Part numbers", joined_or(part.info.part_numbers)},
        {"Variants", joined_or(part.info.variants, "none")},
        {"Manual", manual_words(content, part)},
        {"Node-ID as shipped",
         fmt::format("{}{}{}", part.info.node_id, part.info.node_id_note.empty() ? "" : ", ", part.info.node_id_note)},
        {"Bit rate as shipped", fmt::format("{} bit/s", part.info.bit_rate)}};
    return {"Scope",
            {"This manual is generated from the requirements register. It covers the firmware of this repository. It "
             "does not cover electronics, electromagnetic compatibility, or the plant.",
             "The firmware has no safety integrity level and no certificate. Nobody outside the project has "
             "reviewed the register. The list of hazards has no severities and no probabilities."},
            {table}};
}

Chapter hazard_chapter(const Part& part) {
    Chapter chapter{
        "Hazards, and what prevents them",
        {"Each hazard of an output or a message has a safe state. The requirements in the last column prevent "
         "the failure; the audit says whether passed tests show them."},
        {}};
    for (const auto& hazard : part.hazards) {
        DocumentTable table{fmt::format("{}: {} Safe state: {}", hazard.id, hazard.text, hazard.safe_state),
                            {"Failure", "Prevented by"},
                            {}};
        for (const auto& failure : hazard.failures) {
            table.rows.push_back({failure.text, joined_or(failure.prevented_by, "not prevented by the device")});
        }
        chapter.tables.push_back(table);
    }
    if (part.hazards.empty()) {
        chapter.text.emplace_back("The register has no hazards for this device.");
    }
    return chapter;
}

Chapter integrator_chapter(const Register& content, const Part& part) {
    DocumentTable left{"Failures that the device does not prevent", {"Hazard", "Failure", "Why"}, {}};
    for (const auto& hazard : part.hazards) {
        for (const auto& failure : hazard.failures) {
            if (failure.prevented_by.empty()) {
                left.rows.push_back({hazard.id, failure.text, failure.reason});
            }
        }
    }
    DocumentTable conditions{"Conditions of use that the manual states", {"Section", "Title", "Condition"}, {}};
    if (const Manual* manual = content.manual(part.info.manual)) {
        for (const auto& section : manual->sections) {
            for (const auto& condition : section.conditions) {
                conditions.rows.push_back({section.ref, section.title, condition});
            }
        }
    }
    return {"What the integrator must do",
            {"The firmware does not prevent these failures and cannot ensure these conditions. The integrator must "
             "handle each failure and ensure each condition."},
            {left, conditions}};
}

Chapter limits_chapter(const Part& part, const Analysis& analysis) {
    DocumentTable signals{"Limits of the signals", {"Signal", "Direction", "Range", "Meaning", "Source"}, {}};
    for (const auto& signal : part.signals) {
        const std::string range = range_of(signal);
        if (!range.empty() && !is_simulated(analysis, part, signal.id)) {
            signals.rows.push_back({joined_or(signal.names()), signal.input ? "input" : "output", range, signal.text,
                                    joined_or(origins(signal))});
        }
    }
    DocumentTable constants{"Constants with a unit", {"Constant", "Value", "Meaning", "Source"}, {}};
    for (const auto& constant : part.constants) {
        if (!constant.unit.empty()) {
            constants.rows.push_back({constant.id, fmt::format("{} {}", to_text(constant.value), constant.unit),
                                      constant.text, joined_or(origins(constant))});
        }
    }
    return {"Limits",
            {"The range of an input is what the simulation accepts; it is no limit of the hardware."},
            {signals, constants}};
}

/// Returns the chapter with the decisions that concern an integrator: those that a hazard names, and those of severity
/// high. Of the shared decisions, it lists those that concern the device. The chapter states the number of the other
/// decisions.
Chapter decisions_chapter(const Register& content, const Part& part, const Analysis& analysis) {
    std::set<std::string> of_hazards;
    for (const auto& hazard : part.hazards) {
        of_hazards.insert(hazard.decisions.begin(), hazard.decisions.end());
    }
    DocumentTable table{"Decisions of severity high, or named by a hazard",
                        {"Decision", "Question", "Chosen", "Because", "Severity"},
                        {}};
    std::size_t others = 0;
    const auto add = [&](const Part& of) {
        for (const auto& one : of.decisions) {
            if (one.severity == "high" || of_hazards.count(one.id) != 0) {
                table.rows.push_back({one.id, one.text, one.chosen, one.because, one.severity});
            } else {
                ++others;
            }
        }
    };
    add(part);
    add(shared_rules_of(content, analysis.shared, part));
    return {
        "Decisions for the integrator",
        {"Where the manual contradicts itself or another document, or is silent, a recorded decision states the "
         "behaviour. The authors judge that these decisions matter most to an integrator who expects another "
         "behaviour.",
         fmt::format("{} further decisions of medium or low severity concern the device; the page of decisions lists "
                     "them.",
                     others)},
        {table}};
}

}  // namespace

Document safety_manual(const Register& content, const Part& part, const Analysis& analysis) {
    DocumentTable faults{
        "Requirements of kind fault", {"Requirement", "Text", "Source"}, requirement_rows(part, "fault")};
    return {"safety-manual",
            fmt::format("Safety manual of the {}", part.info.title),
            "Information for the integrator of this device: hazards, failures that the device does not prevent, "
            "conditions of use, limits, decisions, and reactions to faults.",
            {device_chapter(content, part), hazard_chapter(part), integrator_chapter(content, part),
             limits_chapter(part, analysis), decisions_chapter(content, part, analysis),
             Chapter{"Reactions to faults", {}, {faults}}}};
}

}  // namespace canproof::host
