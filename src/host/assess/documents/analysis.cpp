// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/analysis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "host/assess/documents/error_tables.hpp"
#include "host/base/input_error.hpp"
#include "host/register/toml_records.hpp"

namespace canproof::host {

namespace {

void read_failures(TomlItem& whole, Analysis& into) {
    for (auto& item : whole.items("failure_mode")) {
        FailureMode one;
        one.devices = item.texts("devices", true);
        one.signals = item.texts("signals", false);
        one.at = item.text_or("at", "");
        one.mode = item.text("mode");
        one.detected = item.texts("detected", false);
        one.reaction = item.texts("reaction", false);
        one.errors = item.texts("errors", false);
        one.note = item.text_or("note", "");
        one.place = item.place();
        if (one.signals.empty() == one.at.empty()) {
            item.fault("a failure mode must name either `signals` or `at`, not both", "write one of the two");
        }
        into.failure_modes.push_back(one);
        item.finish();
    }
    for (auto& item : whole.items("lamp")) {
        into.lamps.push_back(
            {item.text("device"), item.text("error"), item.text("shows"), item.texts("by", true), item.place()});
        item.finish();
    }
}

Condition read_condition(TomlItem& item) {
    Condition made{item.texts("objects", false), item.texts("without", false), item.boolean_or("lss", false),
                   item.boolean_or("block", false)};
    for (const auto* objects : {&made.objects, &made.without}) {
        for (const auto& one : *objects) {
            if (!names_objects(one)) {
                item.fault(fmt::format("`{}` names no objects", one), "write `1010h`, `1400h-15FFh` or `1400h:05`");
            }
        }
    }
    return made;
}

void read_shared(TomlItem& whole, Analysis& into) {
    for (auto& item : whole.items("shared")) {
        SharedCondition one{item.texts("items", true), read_condition(item), item.text_or("elsewhere", ""),
                            item.place()};
        into.shared.push_back(std::move(one));
        item.finish();
    }
    for (auto& item : whole.items("simulated")) {
        into.simulated.push_back({item.text("device"), item.texts("signals", true), item.place()});
        item.finish();
    }
    for (auto& item : whole.items("message")) {
        into.messages.push_back({item.text("device"), item.text("message"),
                                 item.word("direction", {"sent", "received"}, ""), item.text("cob_id"),
                                 item.text("bytes"), item.text_or("object", ""), item.texts("by", true), item.place()});
        item.finish();
    }
}

void read_threats(TomlItem& whole, Analysis& into) {
    for (auto& item : whole.items("threat")) {
        into.threats.push_back({item.text("service"), read_condition(item), item.text("requirement"), item.text("text"),
                                item.texts("by", false), item.text("rest"), item.place()});
        item.finish();
    }
    for (auto& item : whole.items("communication_error")) {
        into.communication.push_back(
            {item.text("error"), item.texts("by", false), item.text_or("rest", ""), item.place()});
        item.finish();
    }
}

/// Checks the names in an analysis against the requirements register.
class AnalysisCheck {
  public:
    AnalysisCheck(const Register& content, const Analysis& analysis) : content_{content}, analysis_{analysis} {
        for (const auto& part : content.parts) {
            for (const auto& requirement : part.requirements) {
                if (requirement.retired.empty()) {
                    in_force_[requirement.id] = &part;
                }
            }
        }
    }

    void check() const {
        check_shared();
        for (const auto& one : analysis_.failure_modes) {
            for (const auto& name : one.devices) {
                check_of_device(device(name, one.place), one);
            }
        }
        for (const auto& one : analysis_.lamps) {
            check_error(device(one.device, one.place), one.error, one.place);
            requirements_of(device(one.device, one.place), one.by, one.place);
        }
        for (const auto& one : analysis_.messages) {
            requirements_of(device(one.device, one.place), one.by, one.place);
        }
        for (const auto& one : analysis_.threats) {
            requirements(one.by, one.place);
            for (const auto& part : content_.parts) {
                if (part.is_device() && holds(one.condition, part)) {
                    requirements_of(part, one.by, one.place);
                }
            }
        }
        for (const auto& one : analysis_.communication) {
            requirements(one.by, one.place);
            concern_a_device(one.by, one.place);
        }
        for (const auto& one : analysis_.simulated) {
            for (const auto& id : one.signals) {
                check_input(device(one.device, one.place), id, one.place);
            }
        }
    }

  private:
    [[noreturn]] static void fail(const Place& place, const std::string& what) {
        throw InputError{fmt::format("{}:{}: {}", place.file, place.line, what)};
    }

    const Part& device(const std::string& name, const Place& place) const {
        const Part* part = content_.part(name);
        if (part == nullptr || !part->is_device()) {
            fail(place, fmt::format("`{}` is no device; `canproof devices` lists the devices", name));
        }
        return *part;
    }

    /// Checks that the analysis says of each shared requirement and decision which devices it concerns.
    void check_shared() const {
        const Part* rules = content_.part("canopen");
        if (rules == nullptr || analysis_.shared.empty()) {
            return;
        }
        const auto check = [this](const Item& item) {
            if (!is_named(analysis_.shared, item.id)) {
                fail(item.id_place, fmt::format("no [[shared]] of reports/analysis names `{}` or its group; write the "
                                                "condition under which it concerns a device",
                                                item.id));
            }
        };
        for (const auto& one : rules->requirements) {
            if (one.retired.empty()) {
                check(one);
            }
        }
        std::for_each(rules->decisions.begin(), rules->decisions.end(), check);
    }

    /// Checks that each of the requirements concerns at least one device.
    void concern_a_device(const std::vector<std::string>& ids, const Place& place) const {
        for (const auto& id : ids) {
            if (std::none_of(content_.parts.begin(), content_.parts.end(), [&](const Part& part) {
                    return part.is_device() && concerns(analysis_.shared, id, part);
                })) {
                fail(place, fmt::format("`{}` concerns no device; name another requirement", id));
            }
        }
    }

    /// Checks that the requirements exist, and that they belong to the device or are shared ones that concern it.
    void requirements_of(const Part& part, const std::vector<std::string>& ids, const Place& place) const {
        requirements(ids, place);
        for (const auto& id : ids) {
            const Part* owner = in_force_.at(id);
            if (owner != &part && (owner->is_device() || !concerns(analysis_.shared, id, part))) {
                fail(place, fmt::format("`{}` does not concern {}; name a requirement of this device, or correct the "
                                        "[[shared]] record of `{}`",
                                        id, part.name, id));
            }
        }
    }

    void requirements(const std::vector<std::string>& ids, const Place& place) const {
        for (const auto& id : ids) {
            if (in_force_.count(id) == 0) {
                fail(place, fmt::format("`{}` is no requirement or is retired; name another requirement", id));
            }
        }
    }

    void check_of_device(const Part& part, const FailureMode& one) const {
        requirements_of(part, one.detected, one.place);
        requirements_of(part, one.reaction, one.place);
        for (const auto& id : one.signals) {
            check_mode(part, id, one);
        }
        for (const auto& error : one.errors) {
            check_error(part, error, one.place);
        }
    }

    static const Signal& signal_of(const Part& part, const std::string& id, const Place& place) {
        const auto signal = std::find_if(part.signals.begin(), part.signals.end(),
                                         [&id](const Signal& candidate) { return candidate.id == id; });
        if (signal == part.signals.end()) {
            fail(place, fmt::format("{} has no signal `{}`; `canproof signals {}` lists its signals", part.name, id,
                                    part.name));
        }
        return *signal;
    }

    static void check_input(const Part& part, const std::string& id, const Place& place) {
        if (!signal_of(part, id, place).input) {
            fail(place, fmt::format("`{}` is an output; name inputs of the simulated world", id));
        }
    }

    void check_mode(const Part& part, const std::string& id, const FailureMode& one) const {
        if (is_simulated(analysis_, part, id)) {
            fail(one.place, fmt::format("the signal `{}` belongs to the simulated world; it has no failure mode", id));
        }
        const auto modes = modes_of(signal_of(part, id, one.place));
        if (std::find(modes.begin(), modes.end(), one.mode) == modes.end()) {
            fail(one.place,
                 fmt::format("the signal `{}` has no failure mode `{}`; name one of its modes (an output has none): {}",
                             id, one.mode, fmt::join(modes, ", ")));
        }
    }

    void check_error(const Part& part, const std::string& error, const Place& place) const {
        if (emergency_code(content_, part, error).empty()) {
            fail(place,
                 fmt::format(
                     "no table of errors of {} contains the error `{}`; name an error of the requirements register",
                     part.name, error));
        }
    }

    const Register& content_;
    const Analysis& analysis_;
    std::map<std::string, const Part*> in_force_;  ///< the part of each requirement that is not retired, by its id
};

}  // namespace

std::vector<std::string> modes_of(const Signal& signal) {
    if (!signal.input) {
        return {};  // the analysis treats inputs only: the hazards in the register describe the failures of outputs
    }
    if (signal.type == "BOOLEAN") {
        return {"stuck at true", "stuck at false"};
    }
    if (signal.type == "REAL32" || signal.type == "REAL64") {
        return {"too low", "too high", "NaN", "plausible and wrong"};
    }
    return {"outside its range", "plausible and wrong"};
}

bool is_simulated(const Analysis& analysis, const Part& part, const std::string& signal) {
    return std::any_of(analysis.simulated.begin(), analysis.simulated.end(), [&](const SimulatedInputs& one) {
        return one.device == part.name &&
               std::find(one.signals.begin(), one.signals.end(), signal) != one.signals.end();
    });
}

std::string emergency_code(const Register& content, const Part& part, const std::string& error) {
    for (const auto& one : errors_of(content, part)) {
        if (one.error == error) {
            return one.code;
        }
    }
    return "";
}

Analysis read_analysis(const std::filesystem::path& folder, const Register& content) {
    Analysis analysis;
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& file : std::filesystem::directory_iterator{folder}) {
            if (file.path().extension() == ".toml") {
                files.push_back(file.path());
            }
        }
    }
    std::sort(files.begin(), files.end());
    for (const auto& file : files) {
        read_toml_records(file, [&analysis](TomlItem& whole) {
            read_failures(whole, analysis);
            read_threats(whole, analysis);
            read_shared(whole, analysis);
        });
    }
    AnalysisCheck{content, analysis}.check();
    return analysis;
}

}  // namespace canproof::host
