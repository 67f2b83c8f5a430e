// audit: gaps and an exit status, or one requirement's whole story.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/sound_register.hpp"
#include "host/trace/audit.hpp"

namespace canproof::host {

namespace {

void print_part(const PartAudit& audit) {
    fmt::print("{:<12} {:>4} items, {:>3} normative sections, {:>3} decisions, {:>3} gap(s)\n", audit.part->name,
               audit.items.size(), audit.sections.size(), audit.part->decisions.size(), audit.gaps.size());
    for (const auto& gap : audit.gaps) {
        fmt::print("  {}\n", gap);
    }
}

int print_story(const AuditedItem& audited, const Part& part, const Evidence& evidence) {
    const Item& item = *audited.item;
    fmt::print("{} ({} of {}, {}:{})\n  {}\n", item.id, audited.word, part.name, item.place.file, item.place.line,
               item.text);
    fmt::print("  sources      {}\n", fmt::join(item.sources, ", "));
    fmt::print("  decisions    {}\n", fmt::join(audited.decisions, ", "));
    if (const auto code = evidence.implemented.find(item.id); code != evidence.implemented.end()) {
        fmt::print("  code         {}\n", fmt::join(code->second, ", "));
    }
    fmt::print("  demanded     {}\n", fmt::join(audited.demanded, ", "));
    if (const auto found = evidence.verdicts.find(item.id); found != evidence.verdicts.end()) {
        for (const auto& verdict : found->second) {
            fmt::print("  {:<12} {} {}\n", verdict.kind, verdict.passed ? "passed" : "FAILED", verdict.test);
        }
    }
    const bool open = audited.failed || !audited.missing.empty();
    fmt::print("  verdict      {}\n", open ? "open" : "shown");
    return open ? 1 : 0;
}

}  // namespace

int audit(const AuditOptions& options) {
    const std::filesystem::path root{options.root};
    const Register content = sound_register(root / "spec");
    const auto verdicts =
        options.verdicts.empty() ? root / "build" / "release" / "verdicts" : std::filesystem::path{options.verdicts};
    const Evidence evidence = collect_evidence(root, verdicts);
    const Part* device = content.part(options.subject);
    std::vector<PartAudit> audits;
    std::size_t gaps = 0;
    for (const auto& part : content.parts) {
        PartAudit one = audit_part(content, part, evidence);
        for (const auto& item : one.items) {
            if (item.item->id == options.subject) {
                return print_story(item, part, evidence);
            }
        }
        // A device rests on the shared rules: its audit includes theirs.
        if (options.subject.empty() || &part == device || !part.is_device()) {
            gaps += one.gaps.size();
            audits.push_back(std::move(one));
        }
    }
    if (!options.subject.empty() && device == nullptr) {
        throw InputError{fmt::format("`{}` is neither a device nor an id of the register", options.subject)};
    }
    for (const auto& one : audits) {
        print_part(one);
    }
    fmt::print("{} test(s), {} failed, {} gap(s)\n", evidence.tests, evidence.failed, gaps);
    return gaps == 0 && evidence.failed == 0 ? 0 : 1;
}

}  // namespace canproof::host
