// SPDX-License-Identifier: Apache-2.0
// The input from which the evidence pack is made.
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

/// The result of `canproof mutate` for the cells (values in generated tables).
struct MeasuredMutation {
    CountsByItem items;
    std::string json;
};

/// A plot of a device's behaviour.
struct Figure {
    std::string title;
    std::string svg;
    std::string words;  ///< description for readers who do not see the plot
};

struct PackInput {
    const Register* content{nullptr};
    Evidence evidence;
    std::vector<PartAudit> audits;
    std::optional<Evidence> socketcan;  ///< results of the tests on CAN interfaces of a real kernel
    /// one sentence for each function or test that belongs to no requirement
    std::optional<std::vector<std::string>> orphans;
    std::optional<MeasuredCoverage> coverage;
    std::optional<MeasuredMutation> mutation;
    std::optional<std::string> target;  ///< HTML markup with the results that were measured on the microcontroller
    /// The sources that have changed since a measurement: the path of one source by the key of the measurement. Audit,
    /// tests, properties and corpora share the key `tests`.
    std::map<std::string, std::string> newer;
    Argument argument;
    Analysis analysis;                           ///< content of reports/analysis
    std::vector<Exhibit> exhibits;               ///< exhibits: results of other tools
    std::map<std::string, Figure> figures;       ///< plots by file name, which begins with the device's name
    std::map<std::string, std::string> sources;  ///< text of each source that implements or tests an item, by its path
    Provenance provenance;
    PackageRecords packages;
};

}  // namespace canproof::host
