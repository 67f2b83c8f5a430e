// What reports/packages.toml says of the Debian packages: scope, licence, vulnerabilities that somebody looked at.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace canproof::host {

struct PackageRecord {
    std::string name;
    std::string scope;    ///< required, optional or excluded, as CycloneDX has it
    std::string licence;  ///< SPDX expression; empty: nobody has said
};

struct VulnerabilityRecord {
    std::string id;       ///< CVE-2024-1234
    std::string package;  ///< of the records
    std::string state;    ///< not_affected, affected, fixed or in_triage
    std::string detail;
};

struct PackageRecords {
    std::vector<PackageRecord> packages;
    std::vector<VulnerabilityRecord> vulnerabilities;

    /// nullptr when there is none.
    const PackageRecord* package(const std::string& name) const;
};

/// Empty without the file. Throws InputError with file, line and fix.
PackageRecords read_package_records(const std::filesystem::path& file);

}  // namespace canproof::host
