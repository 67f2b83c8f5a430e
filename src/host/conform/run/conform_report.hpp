// SPDX-License-Identifier: Apache-2.0
// The results of a conformance test.
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/conform/link/bus_use.hpp"
#include "host/conform/link/measured.hpp"
#include "host/conform/link/target.hpp"
#include "host/conform/run/cases.hpp"

namespace canproof::host::conform {

enum class Verdict {
    passed,
    failed,     ///< the slave does not do what the case demands
    unstable,   ///< the slave failed the case first and then passed it
    skipped,    ///< the case does not apply or is not allowed
    no_answer,  ///< the slave stopped answering
    broken,     ///< the case itself is wrong
    not_run     ///< the run ended before this case
};
/// Returns the verdict as words: `passed`, `no answer` …
const char* words_of(Verdict verdict);

struct CaseResult {
    std::string id;
    std::string group;
    std::vector<std::string> numbers;
    std::string shows;
    std::string section;
    std::vector<std::string> tests;
    Verdict verdict{Verdict::not_run};
    std::string why;   ///< reason for any verdict except `passed`
    std::string step;  ///< the step at which the case ended, such as `spec/conformance/sdo.toml:12: answer 43 00 10 00`
    std::vector<std::string> notes;
    std::vector<std::string> left;          ///< entries that could not be restored after the case
    std::map<std::string, Measured> times;  ///< measured times by their meaning, such as `SDO answer`
    std::vector<FrameRecord> frames;        ///< all frames of the case; empty if its steps passed or were skipped
    unsigned runs{0};
    Duration time{};
};

/// Returns the result of a case that has not run yet, with the data of the case.
CaseResult result_of(const Case& one);

struct ConformReport {
    std::vector<CaseResult> results;
    std::string program;  ///< name and version of canproof
    std::string sheet;
    std::string checksum;  ///< SHA-256 of the data sheet
    std::string sheet_notes;
    std::string target;
    unsigned node{0};
    std::uint32_t bit_rate{0};
    double traffic{0.0};  ///< load by background frames during the run, in per cent of the bus capacity
    /// vendor, product, revision, serial number, name and versions of the slave
    std::map<std::string, std::string> identity;
    Duration time{};
    BusUse bus_use;
    std::uint64_t error_frames{0};
    /// number of frames that were lost because they came faster than the tester read them
    std::uint64_t lost_frames{0};
    bool interrupted{false};
    std::vector<std::string> troubles;  ///< wrong behaviour of the slave before the first case
    std::vector<std::string> left;      ///< entries that could not be restored at the end of the run

    std::size_t count(Verdict verdict) const {
        return static_cast<std::size_t>(std::count_if(results.begin(), results.end(),
                                                      [&](const CaseResult& one) { return one.verdict == verdict; }));
    }
    /// Returns the mean bus load of all frames of the run, in per cent of the bit rate. Returns nothing when the bit
    /// rate is not known.
    std::optional<double> mean_load() const;
    /// Returns the bus load of the second with the highest load, in per cent. For a run shorter than a second, returns
    /// the load over its duration.
    std::optional<double> highest_load() const;
    /// Returns the exit status. 2: the run was interrupted, had no case, or a case is broken. 1: a case failed, was
    /// unstable or got no answer, or an entry could not be restored at the end of the run. 0: none of these.
    int exit_status() const;

  private:
    double seconds() const { return static_cast<double>(time.us) / 1.0e6; }
    std::optional<double> load_of(std::uint64_t bits, double during) const;
};

}  // namespace canproof::host::conform
