// evidence: the pack to hand over.
#include <fmt/format.h>

#include "host/bus/candump.hpp"
#include "host/cli/commands.hpp"
#include "host/cli/files.hpp"
#include "host/cli/sound_register.hpp"
#include "host/evidence/pack.hpp"
#include "host/plot/figures.hpp"
#include "host/trace/target_html.hpp"

namespace canproof::host {

namespace {

std::optional<MeasuredCoverage> coverage_of(const std::filesystem::path& file, const std::filesystem::path& root) {
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    MeasuredCoverage made;
    made.files = read_coverage(file, root);
    made.verdict = judge_coverage(made.files, read_coverage_records(root / "reports" / "coverage.toml"));
    return made;
}

/// A pack written before goes first; a folder that holds anything else is not ours to clear.
void clear(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder) || std::filesystem::is_empty(folder)) {
        return;
    }
    if (!std::filesystem::exists(folder / "manifest.json")) {
        throw InputError{fmt::format("{} holds other files; name an empty folder or remove it", folder.string())};
    }
    std::filesystem::remove_all(folder);
}

}  // namespace

int write_evidence(const EvidenceOptions& options) {
    const std::filesystem::path root{options.root};
    const Register content = sound_register(root / "spec");
    PackInput input;
    input.content = &content;
    input.evidence = collect_evidence(
        root,
        options.verdicts.empty() ? root / "build" / "release" / "verdicts" : std::filesystem::path{options.verdicts},
        content);
    input.audits = audit_all(content, input.evidence);
    input.coverage = coverage_of(options.coverage.empty() ? root / "build" / "coverage" / "coverage.json"
                                                          : std::filesystem::path{options.coverage},
                                 root);
    input.argument = read_argument(root / "reports" / "argument.toml");
    input.exhibits =
        read_exhibits(options.exhibits.empty() ? root / "build" / "exhibits" : std::filesystem::path{options.exhibits});
    if (const auto target = root / "build" / "target"; std::filesystem::exists(target / "footprint.json")) {
        input.target = write_target_html(target);
    }
    for (const auto& [name, plot] : all_figures()) {
        input.figures[name] = write_svg(plot);
    }
    input.provenance = provenance_of(root);
    const PackFiles files = make_pack(input);
    const std::filesystem::path folder{options.out};
    clear(folder);
    for (const auto& [name, bytes] : files) {
        write_file(folder / name, bytes);
    }
    write_file(folder / "manifest.json", write_manifest(files, input.provenance));
    fmt::print("{} files; open {}\n", files.size() + 1, (folder / "index.html").string());
    return 0;
}

}  // namespace canproof::host
