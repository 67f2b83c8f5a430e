// How a build came about.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace canproof::host {

/// How this build came about; what the manifest says of it.
struct Provenance {
    std::string commit;                           ///< with `+` when files differ from it
    std::string date;                             ///< of the commit, or of SOURCE_DATE_EPOCH
    std::string configuration;                    ///< of this program, and of the tests
    std::map<std::string, std::string> tools;     ///< version by name
    std::map<std::string, std::string> packages;  ///< version by Debian package
    /// SHA-256 of the .deb by package, where the lists of apt have this version.
    std::map<std::string, std::string> package_sums;
};

/// Of the working copy at `root` and of this program. A date comes from SOURCE_DATE_EPOCH when that is set.
Provenance provenance_of(const std::filesystem::path& root);

}  // namespace canproof::host
