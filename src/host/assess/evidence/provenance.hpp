// SPDX-License-Identifier: Apache-2.0
// The provenance of a build: commit, date, tools and packages.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// The provenance of this build, as the manifest contains it.
struct Provenance {
    std::string commit;         ///< commit id; a `+` follows when the working copy differs from the commit
    std::string date;           ///< date of SOURCE_DATE_EPOCH if that is set, otherwise date of the commit
    std::string configuration;  ///< build configuration of this program and of the tests
    std::map<std::string, std::string> tools;     ///< version of each tool by its name
    std::map<std::string, std::string> packages;  ///< installed version of each Debian package by its name
    /// SHA-256 of the .deb file of each package, for versions that the package lists of apt contain.
    std::map<std::string, std::string> package_sums;
};

/// Returns the provenance of the working copy at `root` and of this program. If SOURCE_DATE_EPOCH is set, it replaces
/// the date.
Provenance provenance_of(const std::filesystem::path& root);

/// Returns the SHA-256 of each file that git tracks at `root`, by name. Returns nothing when git is missing or `root`
/// is no working copy.
std::map<std::string, std::string> source_sums(const std::filesystem::path& root);

}  // namespace canproof::host
