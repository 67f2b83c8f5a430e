// What a campaign has done so far: kept in the corpus folder, so that the same command goes on where it was stopped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace canproof::host {

/// Of one target, at one moment of its own fuzzing time.
struct Sample {
    double seconds{0.0};
    std::uint64_t executions{0};
    std::uint64_t edges{0};
    std::uint64_t features{0};
};

struct TargetRecord {
    std::string name;
    unsigned slices{0};  ///< done
    double seconds{0.0};
    std::uint64_t executions{0};
    std::vector<Sample> samples;
    std::size_t inputs_before{0};  ///< in the corpus folder, less the seeds
    std::size_t inputs_found{0};
    std::size_t inputs_kept{0};         ///< after minimisation
    unsigned broken_slices{0};          ///< ended before their time and left no finding
    std::size_t inputs_second_pass{0};  ///< looked at by the second pass

    std::uint64_t edges() const { return samples.empty() ? 0 : samples.back().edges; }
    /// Own fuzzing time at which an edge came last.
    double last_gain() const;
    /// No new edge in the second half of its time.
    bool plateaued() const { return seconds > 0.0 && last_gain() < seconds / 2.0; }
};

struct Finding {
    std::string target;
    std::string title;
    std::string signature;
    std::string first_seen;  ///< UTC
    std::string folder;      ///< input, output.txt and, where the target has frames, frames.log and replay
    std::string regression;  ///< the input among the committed corpus; empty: not landed
    std::string pass;        ///< what showed it: libFuzzer with sanitizers, or valgrind
    std::size_t bytes{0};
    std::size_t times{0};  ///< inputs that led to it
    bool reproduces{true};
};

struct LinePoint {
    double share{0.0};  ///< of the campaign's time, 0 to 1
    std::uint64_t hit{0};
};

/// Lines of one source, by all targets together.
struct FileLines {
    std::string path;  ///< as firmware_path() gives it
    std::uint64_t lines{0};
    std::uint64_t hit{0};
    std::string unreached;               ///< `12-15, 30`
    std::vector<std::string> functions;  ///< that no target calls
};

struct LineCoverage {
    bool measured{false};
    std::vector<FileLines> files;
    std::vector<LinePoint> over_time;

    std::uint64_t lines() const;
    std::uint64_t hit() const;
};

struct CampaignState {
    std::string started;  ///< UTC
    double minutes{0.0};
    std::uint64_t seed{0};
    unsigned jobs{1};
    unsigned rounds{1};
    std::string shard;  ///< `2/3`: this machine fuzzes that part of the targets; empty: all
    std::string phase;  ///< the one under way; `done` at the end
    std::vector<TargetRecord> targets;
    std::vector<Finding> findings;
    LineCoverage coverage;
    std::vector<std::string> remarks;  ///< what could not be done, and why

    std::uint64_t executions() const;
    double seconds() const;
};

/// One finished campaign, to compare with.
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
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CampaignState, started, minutes, seed, jobs, rounds, shard, phase, targets, findings,
                                   coverage, remarks)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Night, started, minutes, executions, lines_hit, edges, per_second, findings)

/// The file's JSON; `null` when it does not exist. Throws InputError, with the remedy, when it cannot be understood.
nlohmann::json read_json(const std::filesystem::path& file);
/// The old file or the new, whatever happens in between. Throws InputError when it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);
void write_json(const std::filesystem::path& file, const nlohmann::json& content);
/// `2026-11-21T04:05:06Z`, now.
std::string utc_now();

}  // namespace canproof::host
