// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/freshness.hpp"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "host/assess/firmware_scope.hpp"
#include "host/base/read_file.hpp"
#include "host/base/replace_file.hpp"
#include "host/base/sha256.hpp"
#include "host/base/source_hash.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

/// Returns whether a measurement depends on this file. Ignores reviews of the requirements register, which change no
/// result, but not reviews of MISRA guidelines. Ignores fuzz corpora, because a new input is no reason to repeat a
/// fuzzing campaign.
bool measured_by(const fs::path& file) {
    const bool of_misra = file.parent_path().filename() == "misra";
    const bool in_corpus = std::find(file.begin(), file.end(), "corpus") != file.end();
    return (file.filename() != "reviews.toml" || of_misra) && file.extension() != ".md" && !in_corpus;
}

std::string first_newer(const fs::path& root, const fs::path& folder, const fs::file_time_type time) {
    std::string first;
    for (const auto& one : fs::recursive_directory_iterator{folder}) {
        if (one.is_regular_file() && measured_by(one.path()) && one.last_write_time() > time) {
            const auto name = one.path().lexically_relative(root).generic_string();
            first = first.empty() || name < first ? name : first;
        }
    }
    return first;
}

std::vector<std::string> with(std::vector<std::string> folders, const std::vector<std::string>& more) {
    folders.insert(folders.end(), more.begin(), more.end());
    return folders;
}

/// Returns the first file that differs or is missing in `now` or `before`; returns an empty text when both
/// are equal.
std::string first_difference(const FileHashes& before, const FileHashes& now) {
    for (const auto& [name, sum] : now) {
        const auto found = before.find(name);
        if (found == before.end() || found->second != sum) {
            return name;
        }
    }
    for (const auto& [name, sum] : before) {
        if (now.count(name) == 0) {
            return name;
        }
    }
    return "";
}

/// Returns the path of the file that records the sources of a measurement. Returns nothing when the measurement is not
/// below build/.
std::optional<fs::path> record_of(const fs::path& root, const fs::path& measured) {
    const auto from = fs::weakly_canonical(measured).lexically_relative(fs::weakly_canonical(root)).generic_string();
    if (from.rfind("build/", 0) != 0) {
        return std::nullopt;
    }
    return root / "build" / "freshness" / (sha256(from) + ".json");
}

/// Returns the hashes of the sources in the record. Returns nothing when the record is missing, is not valid, or
/// belongs to another measurement.
std::optional<FileHashes> recorded(const fs::path& record, const std::string& measurement) {
    if (!fs::exists(record)) {
        return std::nullopt;
    }
    const auto json = nlohmann::json::parse(read_file(record), nullptr, false);
    if (!json.is_object() || json.value("measurement", "") != measurement || !json.contains("sources")) {
        return std::nullopt;
    }
    return json.at("sources").get<FileHashes>();
}

}  // namespace

std::vector<std::string> firmware_sources(const fs::path& root) {
    std::vector<std::string> folders = firmware_folders(root);
    folders.emplace_back("spec");
    return folders;
}

std::vector<std::string> firmware_and_tests(const fs::path& root) {
    return with(firmware_sources(root), {"tests", "properties"});
}

std::vector<std::string> covered_sources(const fs::path& root) {
    return with(firmware_and_tests(root), {"src/host/sim/bus", "src/host/sim/replay"});
}

std::vector<std::string> socketcan_sources(const fs::path& root) {
    return with(firmware_sources(root), {"src/host/sim/bus", "src/host/sim/run", "tests/socketcan"});
}

std::vector<std::string> exhibit_sources(const fs::path& root, const std::string& key) {
    static const std::map<std::string, std::vector<std::string>> more{
        {"code-mutation", {"tests", "properties"}},  // the results of code mutation depend on the tests
        {"coupling", {"src/devices", "src/target/image", "tests/coupling"}},
        {"faults", {"src/devices", "src/target", "tests/devices"}},
        {"fuzz", {"fuzz"}},
        {"growth", {"src/host/sim", "tests/bench"}},
        {"instructions", {"tests/bench"}},
        {"misra", {"misra", "src/devices"}},
        {"object_coverage", {"fuzz", "properties", "src/devices", "src/target", "tests"}},
        {"proofs", {"properties/invariants", "properties/proofs", "src/host/prove"}},
        {"scale", {"src/host/sim", "tests/bench"}},
        {"socketcan_arm", {"src/host/conform", "src/host/sim", "src/target", "tests/socketcan"}},
        {"worst_case", {"src/devices", "src/target"}}};
    const auto found = more.find(key);
    return found == more.end() ? firmware_sources(root) : with(firmware_sources(root), found->second);
}

std::vector<std::string> target_sources(const fs::path& root) {
    return with(firmware_sources(root), {"src/target"});
}

std::string newer_source(const fs::path& root, const std::vector<std::string>& folders, const fs::path& measured) {
    if (!fs::exists(measured)) {
        return "";
    }
    const auto time = fs::last_write_time(measured);
    for (const auto& folder : folders) {
        if (fs::is_directory(root / folder)) {
            if (const auto name = first_newer(root, root / folder, time); !name.empty()) {
                return name;
            }
        }
    }
    return "";
}

std::string changed_source(const fs::path& root, const std::vector<std::string>& folders, const fs::path& measured) {
    const auto record = fs::exists(measured) ? record_of(root, measured) : std::nullopt;
    if (!record) {
        return newer_source(root, folders, measured);
    }
    const std::string measurement = sha256(read_file(measured));
    const FileHashes now = file_hashes(root, folders, measured_by);
    if (const auto before = recorded(*record, measurement)) {
        return first_difference(*before, now);
    }
    const std::string newer = newer_source(root, folders, measured);
    if (newer.empty()) {
        fs::create_directories(record->parent_path());
        replace_file(*record, nlohmann::json{{"measurement", measurement}, {"sources", now}}.dump(1) + "\n");
    }
    return newer;
}

fs::path oldest_file(const fs::path& folder) {
    fs::path oldest;
    if (fs::is_directory(folder)) {
        for (const auto& one : fs::directory_iterator{folder}) {
            if (one.is_regular_file() && (oldest.empty() || one.last_write_time() < fs::last_write_time(oldest))) {
                oldest = one.path();
            }
        }
    }
    return oldest;
}

}  // namespace canproof::host
