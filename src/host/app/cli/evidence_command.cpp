// SPDX-License-Identifier: Apache-2.0
// The `evidence` command: writes the evidence pack.
#include "host/app/cli/evidence_command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "devices/catalogue.hpp"
#include "host/app/cli/sound_register.hpp"
#include "host/assess/coverage/coverage_records.hpp"
#include "host/assess/coverage/read_coverage.hpp"
#include "host/assess/documents/analysis.hpp"
#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/argument_page.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/freshness.hpp"
#include "host/assess/evidence/in_toto.hpp"
#include "host/assess/evidence/make_evidence.hpp"
#include "host/assess/evidence/own_exhibits.hpp"
#include "host/assess/evidence/pack.hpp"
#include "host/assess/evidence/pack_input.hpp"
#include "host/assess/evidence/package_records.hpp"
#include "host/assess/evidence/provenance.hpp"
#include "host/assess/evidence/source_pages.hpp"
#include "host/assess/evidence/target_html.hpp"
#include "host/assess/evidence/verify_pack.hpp"
#include "host/assess/mutation/mutation_json.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"
#include "host/base/files.hpp"
#include "host/base/input_error.hpp"
#include "host/base/replace_folder.hpp"
#include "host/base/sha256.hpp"
#include "host/base/signature.hpp"

namespace canproof::host {

namespace {

/// The files and folders from which an evidence pack is made.
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

/// Returns the measured coverage; nothing when there is no measurement. Also returns nothing when a source has changed
/// since the measurement, because its line numbers then do not match the file.
std::optional<MeasuredCoverage> coverage_of(const std::filesystem::path& file, const std::filesystem::path& root) {
    if (!std::filesystem::exists(file) || !changed_source(root, covered_sources(root), file).empty()) {
        return std::nullopt;
    }
    MeasuredCoverage made;
    made.files = read_coverage(file, root, SourceAge::compared);
    made.verdict = judge_coverage(made.files, read_coverage_records(root / "reports" / "coverage.toml"));
    return made;
}

std::optional<MeasuredMutation> mutation_of(const std::filesystem::path& file) {
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    return MeasuredMutation{read_mutation_json(file), bytes_of(file)};
}

/// Returns the keys of the measurements that are stale, because a source has changed since the measurement. The value
/// is the path of one changed source.
std::map<std::string, std::string> stale_ones(const Places& places) {
    const auto& root = places.root;
    const auto tests = firmware_and_tests(root);
    std::map<std::string, std::string> stale{
        {"tests", changed_source(root, tests, oldest_file(places.verdicts))},
        {"coverage", changed_source(root, covered_sources(root), places.coverage)},
        {"mutation", changed_source(root, tests, places.mutation)},
        {"socketcan", changed_source(root, socketcan_sources(root), oldest_file(places.socketcan))},
        {"target", changed_source(root, target_sources(root), places.target / "footprint.json")}};
    for (auto one = stale.begin(); one != stale.end();) {
        one = one->second.empty() ? stale.erase(one) : std::next(one);
    }
    return stale;
}

std::vector<Exhibit> exhibits_in(const Places& places) {
    std::vector<Exhibit> all;
    for (const auto& folder : exhibit_folders(places.exhibits)) {
        all.push_back(read_exhibit(folder));
        const auto sources = exhibit_sources(places.root, all.back().key);
        mark_stale(all.back(), changed_source(places.root, sources, folder / "exhibit.json"));
    }
    return all;
}

/// Checks that the folder may be replaced: it is absent or empty, or it contains an earlier evidence pack. Throws
/// InputError.
void check_place(const std::filesystem::path& folder) {
    check_replaceable(folder);
    if (!std::filesystem::exists(folder) || std::filesystem::is_empty(folder)) {
        return;
    }
    if (!std::filesystem::exists(folder / "manifest.json")) {
        throw InputError{
            fmt::format("{} contains files but no evidence pack; name an empty folder or one that does not exist yet",
                        folder.string())};
    }
}

/// Checks that the key can sign and that its public key can be derived, before the work of hours. Throws InputError.
void check_key(const std::filesystem::path& key) {
    sign("", key);
    public_key_of(key);
}

PackInput gather(const Places& places, const Register& content) {
    const std::filesystem::path& root = places.root;
    PackInput input;
    input.content = &content;
    input.evidence = collect_evidence(root, places.verdicts, content);
    input.audits = audit_all(content, input.evidence);
    if (std::filesystem::exists(places.socketcan)) {
        input.socketcan = read_verdict_files(places.socketcan);
    }
    input.orphans = orphans(input.evidence);
    input.sources = sources_named_by(input.evidence, root);
    input.coverage = coverage_of(places.coverage, root);
    input.mutation = mutation_of(places.mutation);
    input.argument = read_argument(root / "reports" / "argument.toml");
    input.argument.techniques = read_techniques(root / "reports" / "techniques");
    input.analysis = read_analysis(root / "reports" / "analysis", content);
    input.exhibits = exhibits_in(places);
    if (std::filesystem::exists(places.target / "footprint.json")) {
        input.target = write_target_html(places.target);
    }
    input.newer = stale_ones(places);
    for (const auto& [name, plot] : all_figures()) {
        input.figures[name] = {plot.title, write_svg(plot, DrawnTitle::no), plot_words(plot)};
    }
    input.packages = read_package_records(root / "reports" / "packages.toml");
    input.provenance = provenance_of(root);
    input.provenance.configuration += ", tests in " + places.verdicts.parent_path().filename().string();
    return input;
}

/// Returns the SHA-256 of each file from which the pack is made, by path: the tracked files, and the files of test
/// results as `verdicts/NAME`.
std::map<std::string, std::string> materials_in(const Places& places) {
    auto sums = source_sums(places.root);
    for (const auto& file : std::filesystem::directory_iterator{places.verdicts}) {
        if (file.is_regular_file()) {
            sums["verdicts/" + file.path().filename().string()] = sha256(bytes_of(file.path()));
        }
    }
    return sums;
}

/// Returns the evidence that is absent or stale and that `--full` can make with a command. Without test results,
/// returns all evidence that a command can make.
std::vector<ExpectedEvidence> needed(const EvidenceOptions& options, const Register& content) {
    const Places places{options};
    const bool tested = read_verdict_files(places.verdicts).tests != 0;
    if (!tested) {
        return makeable(read_argument(places.root / "reports" / "argument.toml"), {});
    }
    const PackInput input = gather(places, content);
    return makeable(input.argument, exhibits_of(input));
}

std::size_t make_missing(const EvidenceOptions& options, const Register& content) {
    const std::filesystem::path root = std::filesystem::canonical(options.root);
    std::FILE* const stream = options.json ? stderr : stdout;
    return make_evidence(needed(options, content), root, [stream](const std::string& line) {
        fmt::print(stream, "{}\n", line);
        std::fflush(stream);
    });
}

}  // namespace

int write_evidence(const EvidenceOptions& options) {
    if (!options.key.empty()) {
        check_key(options.key);
    }
    const Register content = sound_register(std::filesystem::path{options.root} / "spec");
    const std::filesystem::path folder{options.out};
    check_place(folder);
    const std::size_t failed = options.full ? make_missing(options, content) : 0;
    const Places places{options};
    const PackInput input = gather(places, content);
    PackFiles files = make_pack(input);
    const std::string manifest = write_manifest(files, input.provenance);
    files["manifest.json"] = manifest;
    if (!options.key.empty()) {
        files.merge(in_toto_files(files, materials_in(places), input.provenance, options.key));
        files[manifest_signature] = sign(manifest, options.key);
    }
    replace_folder(folder, files);
    if (options.json) {
        fmt::print("{}", files.at("data/argument.json"));
    } else {
        fmt::print("{} files; open {}\n{}\n", files.size(), (folder / "index.html").string(),
                   claims_sentence(count_claims(input.argument, exhibits_of(input))));
    }
    return failed == 0 ? 0 : 1;
}

int verify_evidence(const VerifyOptions& options) {
    const auto faults = faults_of_pack(options.pack, options.key);
    if (options.json) {
        const nlohmann::ordered_json json{{"signature_verified", faults.empty() && !options.key.empty()},
                                          {"faults", faults}};
        fmt::print("{}\n", json.dump(2));
        return faults.empty() ? 0 : 1;
    }
    for (const auto& fault : faults) {
        fmt::print("{}\n", fault);
    }
    if (faults.empty()) {
        fmt::print("every file matches the manifest{}\n",
                   options.key.empty() ? "; to verify a signature, name the public key with --key"
                                       : ", and the key has signed it");
    }
    return faults.empty() ? 0 : 1;
}

}  // namespace canproof::host
