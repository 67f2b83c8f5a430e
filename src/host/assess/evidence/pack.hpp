// The evidence pack: what is claimed, what shows it, what is open, for people and for the tools of others.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/assess/coverage/coverage.hpp"
#include "host/assess/evidence/argument.hpp"
#include "host/assess/evidence/exhibit.hpp"
#include "host/assess/mutation/mutation.hpp"
#include "host/assess/trace/audit.hpp"

namespace canproof::host {

/// How this build came about; what the manifest says of it.
struct Provenance {
    std::string commit;                           ///< with `+` when files differ from it
    std::string date;                             ///< of the commit, or of SOURCE_DATE_EPOCH
    std::string configuration;                    ///< of this program, and of the tests
    std::map<std::string, std::string> tools;     ///< version by name
    std::map<std::string, std::string> packages;  ///< version by Debian package
};

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
    std::vector<Exhibit> exhibits;               ///< of other tools
    std::map<std::string, std::string> figures;  ///< SVG text by file name; each begins with its device's name
    Provenance provenance;
};

/// Of the working copy at `root` and of this program. A date comes from SOURCE_DATE_EPOCH when that is set.
Provenance provenance_of(const std::filesystem::path& root);

/// Bytes by path within the pack.
using PackFiles = std::map<std::string, std::string>;

/// All files of the pack but the manifest. The same input gives the same bytes.
PackFiles make_pack(const PackInput& input);

/// manifest.json: SHA-256 of every file, and the provenance.
std::string write_manifest(const PackFiles& files, const Provenance& provenance);

// --- the same as data that other tools import ---

/// ReqIF 1.2: items of the register as SpecObjects, links to decisions as SpecRelations, one specification a part.
std::string write_reqif(const Register& content, const std::vector<PartAudit>& audits);
/// JUnit XML of all test cases, without times: the same verdicts give the same bytes.
std::string write_junit(const Evidence& evidence);
/// CycloneDX 1.5: this program and the Debian packages that it is built from.
std::string write_sbom(const Provenance& provenance);
std::string write_requirements_csv(const std::vector<PartAudit>& audits, const Evidence& evidence);
std::string write_decisions_csv(const std::vector<PartAudit>& audits);

}  // namespace canproof::host
