// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/verify_pack.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "host/assess/evidence/in_toto.hpp"
#include "host/base/input_error.hpp"
#include "host/base/read_file.hpp"
#include "host/base/sha256.hpp"
#include "host/base/signature.hpp"

namespace canproof::host {

namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> sums_in(const std::string& manifest, const fs::path& file) {
    const auto content = nlohmann::json::parse(manifest, nullptr, false);
    try {
        return content.at("sha256").get<std::map<std::string, std::string>>();
    } catch (const nlohmann::json::exception&) {
        throw InputError{fmt::format("{} is no manifest of a pack; `canproof evidence` writes a pack with its manifest",
                                     file.string())};
    }
}

/// Returns the files that the manifest must list: all except the manifest, its signature and the files for in-toto.
std::set<std::string> files_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& one : fs::recursive_directory_iterator{folder}) {
        const std::string name = one.path().lexically_relative(folder).generic_string();
        if (!one.is_directory() && name != "manifest.json" && name != manifest_signature && !is_in_toto_file(name)) {
            names.insert(name);
        }
    }
    return names;
}

}  // namespace

std::vector<std::string> faults_of_pack(const fs::path& folder, const fs::path& public_key) {
    const fs::path file = folder / "manifest.json";
    if (!fs::exists(file)) {
        throw InputError{fmt::format("{} has no manifest.json; name the folder of a pack", folder.string())};
    }
    const std::string manifest = read_file(file);
    std::vector<std::string> faults;
    auto there = files_in(folder);
    for (const auto& [name, sum] : sums_in(manifest, file)) {
        if (there.erase(name) == 0) {
            faults.push_back(name + " is missing");
        } else if (sha256(read_file(folder / name)) != sum) {
            faults.push_back(name + " differs from the manifest");
        }
    }
    for (const auto& name : there) {
        faults.push_back(name + " is not in the manifest");
    }
    if (!public_key.empty()) {
        const fs::path signature = folder / manifest_signature;
        if (!fs::exists(signature)) {
            faults.push_back(
                fmt::format("there is no {}; `canproof evidence --sign KEY` writes it", manifest_signature));
        } else if (!is_signed(manifest, read_file(signature), public_key)) {
            faults.push_back(fmt::format(
                "{} is not valid for {}: the manifest has changed since it was signed, or another key signed it",
                manifest_signature, public_key.string()));
        }
    }
    return faults;
}

}  // namespace canproof::host
