// SPDX-License-Identifier: Apache-2.0
// The records of reports/packages.toml about the Debian packages: scope, licence, and assessed vulnerabilities.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct PackageRecord {
    std::string name;
    std::string scope;    ///< required, optional or excluded, as in CycloneDX
    std::string licence;  ///< SPDX expression; empty: not recorded
};

struct VulnerabilityRecord {
    std::string id;       ///< CVE-2024-1234
    std::string package;  ///< name of a recorded package
    std::string state;    ///< not_affected, affected, fixed or in_triage
    std::string detail;
};

struct PackageRecords {
    std::vector<PackageRecord> packages;
    std::vector<VulnerabilityRecord> vulnerabilities;

    /// Returns the record of a package; nullptr when there is none.
    const PackageRecord* package(const std::string& name) const;
};

/// Reads the records; returns none when the file does not exist. For invalid content, throws InputError with file, line
/// and fix.
PackageRecords read_package_records(const std::filesystem::path& file);

}  // namespace canproof::host
