// SPDX-License-Identifier: Apache-2.0
// The `audit` command: prints the gaps, a list of items, or all that is known about one subject, such as a requirement.
#include "host/app/cli/audit_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <strings.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/app/cli/sound_register.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/assess/story/story.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/audit_json.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/kill_audit.hpp"
#include "host/assess/trace/statement_audit.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

/// Prints how many statements (demands) of a device's manual are shown by tests, explained, suspect, open and failed.
void print_statements(const PartAudit& audit) {
    if (audit.part->info.manual.empty()) {
        return;
    }
    if (audit.statements.empty()) {
        fmt::print("  {} has no statements: an item with a section as its source covers the whole section\n",
                   audit.part->info.manual);
        return;
    }
    auto count = count_statements(audit);
    fmt::print("  {}: {} statements, {} shown, {} explained, {} suspect, {} open, {} failed\n", audit.part->info.manual,
               audit.statements.size(), count["shown"], count["explained"], count["suspect"], count["open"],
               count["failed"]);
}

void print_part(const PartAudit& audit) {
    fmt::print("{:<12} {:>4} items, {:>3} normative sections, {:>3} decisions, {:>3} gap(s), {:>3} suspect(s)\n",
               audit.part->name, audit.items.size(), audit.sections.size(), audit.part->decisions.size(),
               audit.gaps.size(), audit.suspects.size());
    print_statements(audit);
    for (const auto* findings : {&audit.gaps, &audit.suspects}) {
        for (const auto& finding : *findings) {
            fmt::print("  {}\n", finding);
        }
    }
}

/// The items and statements that match the user's filter. `not_shown` counts the listed items with another status than
/// `shown` (proven by passed tests), and the listed open statements.
struct Listed {
    std::vector<const AuditedItem*> items;
    std::vector<const AuditedStatement*> statements;
    std::size_t not_shown{0};
};

Listed listed_of(const Register& content, const std::vector<PartAudit>& audits, const AuditFilter& filter) {
    Listed listed;
    for (const auto& audit : audits) {
        for (const auto& item : audit.items) {
            if (passes(item, filter)) {
                listed.items.push_back(&item);
                listed.not_shown += item.status() == "shown" ? 0 : 1;
            }
        }
        const Manual* manual = content.manual(audit.part->info.manual);
        for (const auto& statement : audit.statements) {
            if (passes(statement, *manual, filter)) {
                listed.statements.push_back(&statement);
                listed.not_shown += statement.open() ? 1 : 0;
            }
        }
    }
    return listed;
}

int list(const Register& content, const std::vector<PartAudit>& audits, const Evidence& evidence,
         const AuditFilter& filter, const bool json) {
    const Listed listed = listed_of(content, audits, filter);
    if (json) {
        fmt::print("{}", write_audit_json(content, audits, filter, {}, evidence));
        return listed.not_shown == 0 ? 0 : 1;
    }
    for (const auto* item : listed.items) {
        fmt::print("{}", item_line(*item));
    }
    for (const auto* statement : listed.statements) {
        fmt::print("{}", statement_line(*statement));
    }
    fmt::print("{} item(s) and {} statement(s), not shown: {}\n", listed.items.size(), listed.statements.size(),
               listed.not_shown);
    return listed.not_shown == 0 ? 0 : 1;
}

struct ConditionOfUse {
    std::string section;  ///< manual and section: `AX130751:1.3`
    std::string text;
};

/// Returns the conditions that installers and operators must meet, in the order of the sections of the device's manual.
/// If `device` is empty, returns those of the manuals of all devices. Throws InputError for an unknown device.
std::vector<ConditionOfUse> conditions_of(const Register& content, const std::string& device) {
    if (!device.empty() && content.part(device) == nullptr) {
        throw InputError{
            fmt::format("`{}` is no device; name a folder of spec/devices, or leave the argument out", device)};
    }
    std::vector<ConditionOfUse> all;
    for (const Part& part : content.parts) {
        const Manual* manual = content.manual(part.info.manual);
        if (manual == nullptr || (!device.empty() && part.name != device)) {
            continue;
        }
        for (const auto& section : manual->sections) {
            for (const auto& condition : section.conditions) {
                all.push_back({manual->key + ":" + section.ref, condition});
            }
        }
    }
    return all;
}

void print_conditions(const std::vector<ConditionOfUse>& conditions, const bool json) {
    if (json) {
        Json all = Json::array();
        for (const auto& one : conditions) {
            all.push_back({{"section", one.section}, {"text", one.text}});
        }
        fmt::print("{}\n", Json{{"conditions", all}}.dump(2));
        return;
    }
    for (const auto& one : conditions) {
        fmt::print("{} {}\n", one.section, one.text);
    }
    fmt::print("{} condition(s) of use\n", conditions.size());
}

/// Returns the audits of the device and of the shared rules (spec/canopen). Returns all audits when `device` is empty.
std::vector<PartAudit> parts_for(std::vector<PartAudit> audits, const std::string& device) {
    const auto other = [&](const PartAudit& one) {
        return !device.empty() && one.part->is_device() && one.part->name != device;
    };
    audits.erase(std::remove_if(audits.begin(), audits.end(), other), audits.end());
    return audits;
}

/// Compares the tests with reports/kills.csv, which records the mutants that each test notices. Returns nothing for a
/// project without such a record.
std::optional<KillAudit> kills_of(const std::filesystem::path& root, const std::vector<PartAudit>& audits,
                                  const Evidence& evidence) {
    const KillRecord record = read_kill_record(root / "reports" / "kills.csv");
    if (record.empty()) {
        return std::nullopt;
    }
    std::vector<std::string> ids;
    for (const auto& one : audits) {
        for (const auto& item : one.items) {
            ids.push_back(item.item->id);
        }
    }
    return audit_kills(ids, evidence, record, root);
}

int tell_story(const AuditOptions& options, const Register& content, const std::vector<PartAudit>& audits,
               const Evidence& evidence) {
    const auto mutations =
        read_mutation_json(std::filesystem::path{options.root} / "build" / "mutation" / "mutation.json");
    const auto story = StoryTeller{content, audits, evidence, mutations}.tell(options.subject);
    if (!story) {
        throw InputError{fmt::format(
            "`{}` is no device, id of an item, section (AX130751:1.3), statement (AX130751:1.3/2), source file or test "
            "(Suite.Name); `canproof audit --kind requirement` lists the ids of requirements",
            options.subject)};
    }
    if (options.json) {
        fmt::print("{}\n", Json{{"subject", options.subject}, {"open", story->open}, {"story", story->text}}.dump(2));
    } else {
        fmt::print("{}", story->text);
    }
    return story->open ? 1 : 0;
}

/// Prints everything that these audits found missing: gaps, open statements of the manuals and other open points.
/// Returns the exit status.
int tell_all(const AuditOptions& options, const Register& content, const std::vector<PartAudit>& audits,
             const Evidence& evidence) {
    const auto strays = orphans(evidence);
    const auto kills = kills_of(options.root, audits, evidence);
    const auto regressions = kills ? kills->regressions : std::vector<std::string>{};
    std::size_t gaps = 0;
    std::size_t suspects = 0;
    for (const auto& one : audits) {
        gaps += one.gaps.size();
        suspects += one.suspects.size();
    }
    if (options.json) {
        fmt::print(
            "{}", write_audit_json(content, audits, {}, {{"orphans", strays}, {"regressions", regressions}}, evidence));
    } else {
        for (const auto& one : audits) {
            print_part(one);
        }
        for (const auto& stray : strays) {
            fmt::print("orphan: {}\n", stray);
        }
        fmt::print("{}", kills ? kill_summary(*kills) : "");
        fmt::print(
            "{} test(s), {} failed, {} gap(s), {} orphan(s), {} suspect(s), {} regression(s) of noticed "
            "mutants\n",
            evidence.tests, evidence.failed, gaps, strays.size(), suspects, regressions.size());
    }
    return gaps + suspects + strays.size() + evidence.failed + regressions.size() == 0 ? 0 : 1;
}

/// Checks that the filter applies to what the user named. Throws InputError, because the command would ignore it.
void check_filter(const AuditOptions& options, const Register& content) {
    const AuditFilter& filter = options.filter;
    if (filter.kind == "condition-of-use" && !(filter.section.empty() && filter.status.empty())) {
        throw InputError{"conditions of use have no --section and no --status; leave these options out"};
    }
    if (!options.subject.empty() && !filter.empty() && content.part(options.subject) == nullptr) {
        throw InputError{fmt::format(
            "--section, --kind, --status and --untested filter the items of a device, and `{}` is no device; leave "
            "these options out, or name a device",
            options.subject)};
    }
}

/// Returns the subject as the audit names it: the device of a part number, and the path of a file in the project as
/// below the project's folder. Returns any other text unchanged.
std::string known_subject(const std::string& subject, const Register& content, const std::filesystem::path& root) {
    for (const Part& part : content.parts) {
        for (const std::string& number : part.info.part_numbers) {
            if (strcasecmp(number.c_str(), subject.c_str()) == 0) {
                return part.name;
            }
        }
    }
    std::error_code none;
    if (subject.empty() || !std::filesystem::is_regular_file(subject, none)) {
        return subject;
    }
    const auto path = std::filesystem::weakly_canonical(subject).lexically_relative(std::filesystem::canonical(root));
    return path.empty() || *path.begin() == ".." ? subject : path.generic_string();
}

}  // namespace

int audit(const AuditOptions& given) {
    const std::filesystem::path root{given.root};
    const Register content = sound_register(root / "spec");
    AuditOptions options = given;
    options.subject = known_subject(given.subject, content, root);
    check_filter(options, content);
    if (options.filter.kind == "condition-of-use") {
        print_conditions(conditions_of(content, options.subject), options.json);
        return 0;
    }
    const auto verdicts = options.verdicts.empty() ? newest_verdicts(root) : std::filesystem::path{options.verdicts};
    const Evidence evidence = collect_evidence(root, verdicts, content);
    std::vector<PartAudit> audits = audit_all(content, evidence);
    const bool is_device = content.part(options.subject) != nullptr;
    if (!options.subject.empty() && !is_device) {
        return tell_story(options, content, audits, evidence);
    }
    audits = parts_for(std::move(audits), options.subject);
    if (!options.filter.empty()) {
        return list(content, audits, evidence, resolved(options.filter, content, audits), options.json);
    }
    return tell_all(options, content, audits, evidence);
}

}  // namespace canproof::host
