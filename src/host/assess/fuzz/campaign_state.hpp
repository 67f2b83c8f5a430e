// SPDX-License-Identifier: Apache-2.0
// The state of a fuzzing campaign. The corpus folder keeps it, so that the same command without --restart continues an
// interrupted campaign.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace canproof::host {

/// The progress of one target at one moment of its fuzzing time: executions, edges (jumps between blocks of code) …
struct Sample {
    double seconds{0.0};
    std::uint64_t executions{0};
    std::uint64_t edges{0};
    std::uint64_t features{0};
};

struct TargetRecord {
    std::string name;
    unsigned slices{0};  ///< number of finished slices (parts of the fuzzing time)
    double seconds{0.0};
    std::uint64_t executions{0};
    std::vector<Sample> samples;
    std::size_t inputs_before{0};  ///< number of inputs in the corpus folder before the campaign, without the seeds
    std::size_t inputs_found{0};
    std::size_t inputs_kept{0};         ///< number of inputs after minimisation
    unsigned broken_slices{0};          ///< number of slices that ended too early without a finding
    std::size_t inputs_second_pass{0};  ///< number of inputs that the second pass ran

    std::uint64_t edges() const { return samples.empty() ? 0 : samples.back().edges; }
    /// Returns when the target last reached a new edge, in seconds of its fuzzing time.
    double last_gain() const;
    /// Returns whether the second half of the target's time reached no new edge (jump between two blocks of code).
    bool plateaued() const { return seconds > 0.0 && last_gain() < seconds / 2.0; }
};

struct Finding {
    std::string target;
    std::string title;
    std::string signature;
    std::string first_seen;  ///< UTC time
    std::string folder;      ///< folder with input and output.txt; also frames.log and replay, if the target sends CAN
                             ///< frames
    std::string regression;  ///< path of the input in the committed corpus; empty: it is not there
    std::string pass;        ///< the pass that found the bug: libFuzzer with sanitizers, or valgrind
    std::size_t bytes{0};
    std::size_t times{0};  ///< number of inputs that showed the bug
    bool reproduces{true};
};

struct LinePoint {
    double share{0.0};  ///< elapsed share of the campaign's time, 0 to 1
    std::uint64_t hit{0};
};

/// The lines of one source file that all targets together reach.
struct FileLines {
    std::string path;  ///< path of the source, as firmware_path() returns it
    std::uint64_t lines{0};
    std::uint64_t hit{0};
    std::string unreached;               ///< line numbers such as `12-15, 30`
    std::vector<std::string> functions;  ///< functions that no target calls
};

struct LineCoverage {
    bool measured{false};
    std::vector<FileLines> files;
    std::vector<LinePoint> over_time;

    std::uint64_t lines() const;
    std::uint64_t hit() const;
};

struct CampaignState {
    std::string started;  ///< UTC time
    double minutes{0.0};
    std::uint64_t seed{0};
    unsigned jobs{1};
    unsigned rounds{1};
    std::string sources;  ///< source_hash() of the tree in which the campaign began
    std::string shard;    ///< `2/3`: this machine fuzzes that part of the targets; empty: all
    std::string phase;    ///< the phase in which the campaign is; `done` after the last phase
    std::vector<TargetRecord> targets;
    std::vector<Finding> findings;
    LineCoverage coverage;
    std::vector<std::string> remarks;  ///< sentences about interruptions and failed steps

    std::uint64_t executions() const;
    double seconds() const;
};

/// The figures of one finished campaign, with which the next campaign compares its own figures.
struct Night {
    std::string started;
    double minutes{0.0};
    std::uint64_t executions{0};
    std::uint64_t lines_hit{0};
    std::map<std::string, std::uint64_t> edges;
    std::map<std::string, double> per_second;
    std::size_t findings{0};
};

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Sample, seconds, executions, edges, features)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TargetRecord, name, slices, seconds, executions, samples, inputs_before,
                                   inputs_found, inputs_kept, broken_slices, inputs_second_pass)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Finding, target, title, signature, first_seen, folder, regression, pass, bytes,
                                   times, reproduces)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LinePoint, share, hit)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FileLines, path, lines, hit, unreached, functions)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LineCoverage, measured, files, over_time)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CampaignState, started, minutes, seed, jobs, rounds, sources, shard, phase, targets,
                                   findings, coverage, remarks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Night, started, minutes, executions, lines_hit, edges, per_second, findings)

/// Returns the JSON of the file; `null` when the file does not exist. Throws InputError for invalid content.
nlohmann::json read_json(const std::filesystem::path& file);
/// Replaces the file atomically: after an interruption the file has the old or the new content. Throws InputError when
/// the file cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);
void write_json(const std::filesystem::path& file, const nlohmann::json& content);
/// Returns a duration in minutes as text, such as `1.8 minutes` for 0.03 h * 60 = 1.7999999999999998.
std::string minutes_text(double minutes);
/// Returns the current time as `2026-11-21T04:05:06Z`.
std::string utc_now();

}  // namespace canproof::host
