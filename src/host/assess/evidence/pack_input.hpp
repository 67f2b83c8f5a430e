// What the evidence pack is made from.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/coverage/coverage_records.hpp"
#include "host/assess/documents/analysis.hpp"
#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/evidence/package_records.hpp"
#include "host/assess/evidence/provenance.hpp"
#include "host/assess/mutation/mutation_counts.hpp"
#include "host/assess/trace/audit.hpp"
#include "host/assess/trace/evidence.hpp"

namespace canproof::host {

struct MeasuredCoverage {
    std::vector<FileCoverage> files;
    CoverageVerdict verdict;
};

/// What `canproof mutate` left of the generated cells.
struct MeasuredMutation {
    CountsByItem items;
    std::string json;
};

struct PackInput {
    const Register* content{nullptr};
    Evidence evidence;
    std::vector<PartAudit> audits;
    std::optional<Evidence> socketcan;                ///< runs on CAN interfaces of a real kernel
    std::optional<std::vector<std::string>> orphans;  ///< code or tests without a requirement, each a sentence
    std::optional<MeasuredCoverage> coverage;
    std::optional<MeasuredMutation> mutation;
    std::optional<std::string> target;  ///< markup: figures measured on the microcontroller
    /// By key of what was measured before a source was written: that source. The audit, tests, properties and corpora
    /// have the key `tests`.
    std::map<std::string, std::string> newer;
    Argument argument;
    Analysis analysis;                           ///< of reports/analysis
    std::vector<Exhibit> exhibits;               ///< of other tools
    std::map<std::string, std::string> figures;  ///< SVG text by file name; each begins with its device's name
    Provenance provenance;
    PackageRecords packages;
};

}  // namespace canproof::host
