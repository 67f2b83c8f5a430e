// evidence: the pack to hand over.
#include "host/app/cli/evidence_command.hpp"

#include <fmt/format.h>

#include "devices/catalogue.hpp"
#include "host/app/cli/sound_register.hpp"
#include "host/assess/coverage/coverage_records.hpp"
#include "host/assess/coverage/read_coverage.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/freshness.hpp"
#include "host/assess/evidence/pack.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/provenance.hpp"
#include "host/assess/evidence/target_html.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/input_error.hpp"
#include "host/base/replace_folder.hpp"

namespace canproof::host {

namespace {

/// Where everything lies that a pack is made from.
struct Places {
    explicit Places(const EvidenceOptions& options)
        : root{options.root},
          verdicts{options.verdicts.empty() ? newest_verdicts(root) : std::filesystem::path{options.verdicts}},
          coverage{or_below(options.coverage, "build/coverage/coverage.json")},
          exhibits{or_below(options.exhibits, "build/exhibits")},
          mutation{root / "build/mutation/mutation.json"},
          target{root / "build/target"},
          socketcan{root / "build/socketcan/verdicts"} {}

    std::filesystem::path or_below(const std::string& given, const char* place) const {
        return given.empty() ? root / place : std::filesystem::path{given};
    }

    std::filesystem::path root;
    std::filesystem::path verdicts;
    std::filesystem::path coverage;
    std::filesystem::path exhibits;
    std::filesystem::path mutation;
    std::filesystem::path target;
    std::filesystem::path socketcan;
};

std::optional<MeasuredCoverage> coverage_of(const std::filesystem::path& file, const std::filesystem::path& root) {
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    MeasuredCoverage made;
    made.files = read_coverage(file, root);
    made.verdict = judge_coverage(made.files, read_coverage_records(root / "reports" / "coverage.toml"));
    return made;
}

std::optional<MeasuredMutation> mutation_of(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    return MeasuredMutation{read_mutation_json(file), bytes_of(file)};
}

/// What was measured before a source that it speaks of was written.
std::map<std::string, std::string> stale_ones(const Places& places) {
    const auto& root = places.root;
    const auto tests = firmware_and_tests(root);
    std::map<std::string, std::string> stale{
        {"tests", newer_source(root, tests, oldest_file(places.verdicts))},
        {"coverage", newer_source(root, tests, places.coverage)},
        {"mutation", newer_source(root, tests, places.mutation)},
        {"socketcan", newer_source(root, socketcan_sources(root), oldest_file(places.socketcan))},
        {"target", newer_source(root, target_sources(root), places.target / "footprint.json")}};
    for (auto one = stale.begin(); one != stale.end();) {
        one = one->second.empty() ? stale.erase(one) : std::next(one);
    }
    return stale;
}

std::vector<Exhibit> exhibits_in(const Places& places) {
    std::vector<Exhibit> all;
    for (const auto& folder : exhibit_folders(places.exhibits)) {
        all.push_back(read_exhibit(folder));
        // What notices a mutant are the tests.
        const auto sources =
            all.back().key == "code-mutation" ? firmware_and_tests(places.root) : firmware_sources(places.root);
        mark_stale(all.back(), newer_source(places.root, sources, folder / "exhibit.json"));
    }
    return all;
}

/// A pack written before is replaced; a folder that holds anything else is not ours.
void check_place(const std::filesystem::path& folder) {
    if (!std::filesystem::exists(folder) || std::filesystem::is_empty(folder)) {
        return;
    }
    if (!std::filesystem::exists(folder / "manifest.json")) {
        throw InputError{fmt::format("{} holds other files; name an empty folder or remove it", folder.string())};
    }
}

}  // namespace

int write_evidence(const EvidenceOptions& options) {
    const Places places{options};
    const std::filesystem::path& root = places.root;
    const Register content = sound_register(root / "spec");
    PackInput input;
    input.content = &content;
    input.evidence = collect_evidence(root, places.verdicts, content);
    input.audits = audit_all(content, input.evidence);
    if (std::filesystem::exists(places.socketcan)) {
        input.socketcan = read_verdict_files(places.socketcan);
    }
    input.orphans = orphans(input.evidence);
    input.coverage = coverage_of(places.coverage, root);
    input.mutation = mutation_of(places.mutation);
    input.argument = read_argument(root / "reports" / "argument.toml");
    input.exhibits = exhibits_in(places);
    if (std::filesystem::exists(places.target / "footprint.json")) {
        input.target = write_target_html(places.target);
    }
    input.newer = stale_ones(places);
    for (const auto& [name, plot] : all_figures()) {
        input.figures[name] = write_svg(plot);
    }
    input.provenance = provenance_of(root);
    input.provenance.configuration += ", tests in " + places.verdicts.parent_path().filename().string();
    PackFiles files = make_pack(input);
    const std::filesystem::path folder{options.out};
    check_place(folder);
    const std::string manifest = write_manifest(files, input.provenance);
    files["manifest.json"] = manifest;
    replace_folder(folder, files);
    fmt::print("{} files; open {}\n", files.size(), (folder / "index.html").string());
    return 0;
}

}  // namespace canproof::host
