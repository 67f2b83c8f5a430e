// SPDX-License-Identifier: Apache-2.0
// The provenance of a build.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// The provenance of this build, as the manifest contains it.
struct Provenance {
    std::string commit;                           ///< commit; a `+` follows when files differ from it
    std::string date;                             ///< date of the commit, or of SOURCE_DATE_EPOCH
    std::string configuration;                    ///< configuration of this program and of the tests
    std::map<std::string, std::string> tools;     ///< version by name
    std::map<std::string, std::string> packages;  ///< version by Debian package
    /// SHA-256 of the .deb by package, for versions that the lists of apt contain.
    std::map<std::string, std::string> package_sums;
};

/// Returns the provenance of the working copy at `root` and of this program. SOURCE_DATE_EPOCH replaces the date.
Provenance provenance_of(const std::filesystem::path& root);

/// Returns the SHA-256 of each file that git tracks at `root`, by name; of none without git.
std::map<std::string, std::string> source_sums(const std::filesystem::path& root);

}  // namespace canproof::host
