// SPDX-License-Identifier: Apache-2.0
// Determines the provenance of a build from git, dpkg and the compiler of this program.
#include "host/assess/evidence/provenance.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <regex>
#include <sstream>

#include "host/base/child_process.hpp"
#include "host/base/reading.hpp"
#include "host/base/sha256.hpp"

namespace canproof::host {

namespace {

/// Returns the standard output of a shell command without trailing line breaks; its error output is discarded.
std::string said_by(const std::string& command) {
    std::string text = output_of({"sh", "-c", "{ " + command + "; } 2>/dev/null || true"}).value_or("");
    while (!text.empty() && text.back() == '\n') {
        text.pop_back();
    }
    return text;
}

/// Returns the path in single quotes for a shell.
std::string quoted(const std::filesystem::path& path) {
    std::string text{"'"};
    for (const char one : path.string()) {
        text += one == '\'' ? "'\\''" : std::string(1, one);
    }
    return text + "'";
}

std::string date_of(const std::string& git) {
    std::time_t seconds = 0;
    if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
        seconds = std::strtoll(epoch, nullptr, 10);
    } else {
        seconds = std::strtoll(said_by(git + " log -1 --format=%ct").c_str(), nullptr, 10);
    }
    std::tm utc{};
    gmtime_r(&seconds, &utc);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text.data();
}

/// Returns the Debian packages that ./run installs, with their installed versions.
std::map<std::string, std::string> packages_of(const std::filesystem::path& root) {
    const auto file = root / "run";
    const std::string text = std::filesystem::exists(file) ? read_file(file) : "";
    std::smatch list;
    std::map<std::string, std::string> found;
    if (!std::regex_search(text, list, std::regex{R"(packages=\(([^)]*)\))"})) {
        return found;
    }
    std::string names = list[1].str();
    for (char& one : names) {
        one = one == '\n' ? ' ' : one;
    }
    std::istringstream lines{said_by(R"(dpkg-query -W -f='${Package} ${Version}\n' )" + names)};
    for (std::string name, version; lines >> name >> version;) {
        found[name] = version;
    }
    return found;
}

/// Returns the SHA-256 of each package's .deb file from the package lists of apt. Leaves out a package whose version
/// the lists do not contain.
std::map<std::string, std::string> package_sums(const std::map<std::string, std::string>& packages) {
    std::string names;
    for (const auto& [name, version] : packages) {
        names += " " + name + "=" + version;
    }
    std::map<std::string, std::string> sums;
    if (names.empty()) {
        return sums;
    }
    std::istringstream lines{said_by("apt-cache show" + names)};
    std::string package;
    for (std::string line; std::getline(lines, line);) {
        const auto colon = line.find(": ");
        const std::string key = line.substr(0, colon);
        if (key == "Package") {
            package = line.substr(colon + 2);
        } else if (key == "SHA256") {
            sums[package] = line.substr(colon + 2);
        }
    }
    return sums;
}

}  // namespace

Provenance provenance_of(const std::filesystem::path& root) {
    const std::string git = "git -C " + quoted(root);
    Provenance made;
    made.commit = said_by(git + " rev-parse HEAD");
    if (!said_by(git + " status --porcelain --untracked-files=no").empty()) {
        made.commit += "+";
    }
    made.date = date_of(git);
#ifdef NDEBUG
    made.configuration = "release";
#else
    made.configuration = "debug";
#endif
    made.tools["compiler"] = fmt::format("{} {}",
#ifdef __clang__
                                         "clang",
#else
                                         "g++",
#endif
                                         __VERSION__);
    made.packages = packages_of(root);
    made.package_sums = package_sums(made.packages);
    return made;
}

std::map<std::string, std::string> source_sums(const std::filesystem::path& root) {
    std::map<std::string, std::string> sums;
    std::istringstream names{said_by("git -C " + quoted(root) + " ls-files -z")};
    for (std::string name; std::getline(names, name, '\0');) {
        if (std::filesystem::is_regular_file(root / name)) {
            sums[name] = sha256(read_file(root / name));
        }
    }
    return sums;
}

}  // namespace canproof::host
