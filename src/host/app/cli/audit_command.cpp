// audit: gaps and an exit status, or one requirement's whole story.
#include "host/app/cli/audit_command.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/app/cli/sound_register.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/assess/story/story.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/audit_json.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/assess/trace/kill_audit.hpp"
#include "host/base/input_error.hpp"

namespace canproof::host {

namespace {

void print_part(const PartAudit& audit) {
    fmt::print("{:<12} {:>4} items, {:>3} normative sections, {:>3} decisions, {:>3} gap(s), {:>3} suspect(s)\n",
               audit.part->name, audit.items.size(), audit.sections.size(), audit.part->decisions.size(),
               audit.gaps.size(), audit.suspects.size());
    for (const auto* findings : {&audit.gaps, &audit.suspects}) {
        for (const auto& finding : *findings) {
            fmt::print("  {}\n", finding);
        }
    }
}

int list_items(const std::vector<PartAudit>& audits, const AuditFilter& filter) {
    std::size_t found = 0;
    std::size_t not_shown = 0;
    for (const auto& audit : audits) {
        for (const auto& item : audit.items) {
            if (passes(item, filter)) {
                fmt::print("{}", item_line(item));
                ++found;
                not_shown += item.status() == "shown" ? 0 : 1;
            }
        }
    }
    fmt::print("{} item(s), {} of them not shown\n", found, not_shown);
    return not_shown == 0 ? 0 : 1;
}

/// Lists what installers and operators must keep, by section of the device's manual, or of all manuals.
int list_conditions(const Register& content, const std::string& device) {
    if (!device.empty() && content.part(device) == nullptr) {
        throw InputError{fmt::format("`{}` is no device; `canproof devices` lists them", device)};
    }
    std::size_t found = 0;
    for (const Part& part : content.parts) {
        const Manual* manual = content.manual(part.info.manual);
        if (manual == nullptr || (!device.empty() && part.name != device)) {
            continue;
        }
        for (const auto& section : manual->sections) {
            for (const auto& condition : section.conditions) {
                fmt::print("{}:{} {}\n", manual->key, section.ref, condition);
                ++found;
            }
        }
    }
    fmt::print("{} condition(s) of use\n", found);
    return 0;
}

/// The parts that an audit of this device is about: a device rests on the shared rules. All without a name.
std::vector<PartAudit> parts_for(std::vector<PartAudit> audits, const std::string& device) {
    const auto other = [&](const PartAudit& one) {
        return !device.empty() && one.part->is_device() && one.part->name != device;
    };
    audits.erase(std::remove_if(audits.begin(), audits.end(), other), audits.end());
    return audits;
}

/// Says which items are shown by tests that notice a mutant; how much of the record no longer holds. A project without
/// a record is not asked.
std::size_t print_kills(const std::filesystem::path& root, const std::vector<PartAudit>& audits,
                        const Evidence& evidence) {
    const KillRecord record = read_kill_record(root / "reports" / "kills.csv");
    if (record.empty()) {
        return 0;
    }
    std::vector<std::string> ids;
    for (const auto& one : audits) {
        for (const auto& item : one.items) {
            ids.push_back(item.item->id);
        }
    }
    const KillAudit kills = audit_kills(ids, evidence, record, root);
    fmt::print("{}", kill_summary(kills));
    return kills.regressions.size();
}

/// No gap, no suspect, no orphan, no test that failed.
bool is_sound(const std::vector<PartAudit>& audits, const Evidence& evidence) {
    return evidence.failed == 0 && orphans(evidence).empty() &&
           std::all_of(audits.begin(), audits.end(),
                       [](const PartAudit& one) { return one.gaps.empty() && one.suspects.empty(); });
}

}  // namespace

int audit(const AuditOptions& options) {
    const std::filesystem::path root{options.root};
    const Register content = sound_register(root / "spec");
    if (options.filter.kind == "condition-of-use") {
        return list_conditions(content, options.subject);
    }
    const auto verdicts = options.verdicts.empty() ? newest_verdicts(root) : std::filesystem::path{options.verdicts};
    const Evidence evidence = collect_evidence(root, verdicts, content);
    std::vector<PartAudit> audits = audit_all(content, evidence);
    const bool is_device = content.part(options.subject) != nullptr;
    if (!options.subject.empty() && !is_device) {
        const auto mutations = read_mutation_json(root / "build" / "mutation" / "mutation.json");
        const auto story = StoryTeller{content, audits, evidence, mutations}.tell(options.subject);
        if (!story) {
            throw InputError{fmt::format(
                "`{}` is no device, id, section (AX130751:1.3), source file or test (Suite.Name)", options.subject)};
        }
        if (options.json) {
            throw InputError{"--json is for a device or for all; `canproof audit --json` holds every item"};
        }
        fmt::print("{}", story->text);
        return story->open ? 1 : 0;
    }
    audits = parts_for(std::move(audits), options.subject);
    if (options.json) {
        fmt::print("{}", write_audit_json(content, audits, resolved(options.filter, content, audits),
                                          {{"orphans", orphans(evidence)}}, evidence));
        return is_sound(audits, evidence) ? 0 : 1;
    }
    if (!options.filter.empty()) {
        return list_items(audits, resolved(options.filter, content, audits));
    }
    std::size_t gaps = 0;
    std::size_t suspects = 0;
    for (const auto& one : audits) {
        print_part(one);
        gaps += one.gaps.size();
        suspects += one.suspects.size();
    }
    const auto strays = orphans(evidence);
    for (const auto& stray : strays) {
        fmt::print("orphan: {}\n", stray);
    }
    const std::size_t regressions = print_kills(root, audits, evidence);
    fmt::print("{} test(s), {} failed, {} gap(s), {} orphan(s), {} suspect(s), {} regression(s) of noticed mutants\n",
               evidence.tests, evidence.failed, gaps, strays.size(), suspects, regressions);
    return gaps + suspects + strays.size() + evidence.failed + regressions == 0 ? 0 : 1;
}

}  // namespace canproof::host
