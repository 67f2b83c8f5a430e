// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/analysis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

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

void read_threats(TomlItem& whole, Analysis& into) {
    for (auto& item : whole.items("threat")) {
        into.threats.push_back({item.text("service"), item.texts("objects", false), item.boolean_or("lss", false),
                                item.text("requirement"), item.text("text"), item.texts("by", false), item.text("rest"),
                                item.place()});
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
    explicit AnalysisCheck(const Register& content) : content_{content} {
        for (const auto& part : content.parts) {
            for (const auto& requirement : part.requirements) {
                if (requirement.retired.empty()) {
                    in_force_.insert(requirement.id);
                }
            }
        }
    }

    void check(const Analysis& analysis) const {
        for (const auto& one : analysis.failure_modes) {
            requirements(one.detected, one.place);
            requirements(one.reaction, one.place);
            for (const auto& name : one.devices) {
                check_of_device(device(name, one.place), one);
            }
        }
        for (const auto& one : analysis.lamps) {
            check_error(device(one.device, one.place), one.error, one.place);
            requirements(one.by, one.place);
        }
        for (const auto& one : analysis.threats) {
            requirements(one.by, one.place);
        }
        for (const auto& one : analysis.communication) {
            requirements(one.by, one.place);
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

    void requirements(const std::vector<std::string>& ids, const Place& place) const {
        for (const auto& id : ids) {
            if (in_force_.count(id) == 0) {
                fail(place, fmt::format("`{}` is no requirement or is retired; name another requirement", id));
            }
        }
    }

    void check_of_device(const Part& part, const FailureMode& one) const {
        for (const auto& id : one.signals) {
            check_mode(part, id, one);
        }
        for (const auto& error : one.errors) {
            check_error(part, error, one.place);
        }
    }

    static void check_mode(const Part& part, const std::string& id, const FailureMode& one) {
        const auto signal = std::find_if(part.signals.begin(), part.signals.end(),
                                         [&id](const Signal& candidate) { return candidate.id == id; });
        if (signal == part.signals.end()) {
            fail(one.place, fmt::format("{} has no signal `{}`; `canproof signals {}` lists its signals", part.name, id,
                                        part.name));
        }
        const auto modes = modes_of(*signal);
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
    std::set<std::string> in_force_;
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
        });
    }
    AnalysisCheck{content}.check(analysis);
    return analysis;
}

}  // namespace canproof::host
