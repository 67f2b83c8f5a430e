// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/package_records.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/register/toml_records.hpp"

namespace canproof::host {

const PackageRecord* PackageRecords::package(const std::string& name) const {
    const auto found =
        std::find_if(packages.begin(), packages.end(), [&name](const PackageRecord& one) { return one.name == name; });
    return found == packages.end() ? nullptr : &*found;
}

PackageRecords read_package_records(const std::filesystem::path& file) {
    PackageRecords records;
    if (!std::filesystem::exists(file)) {
        return records;
    }
    read_toml_records(file, [&records](TomlItem& whole) {
        for (auto& item : whole.items("package")) {
            records.packages.push_back({item.text("name"), item.word("scope", {"required", "optional", "excluded"}, ""),
                                        item.text_or("licence", "")});
            item.finish();
        }
        for (auto& item : whole.items("vulnerability")) {
            const VulnerabilityRecord one{item.text("id"), item.text("package"),
                                          item.word("state", {"not_affected", "affected", "fixed", "in_triage"}, ""),
                                          item.text("detail")};
            if (records.package(one.package) == nullptr) {
                item.fault(item.place("package"), fmt::format("there is no package `{}`", one.package),
                           "name a package of this file");
            }
            records.vulnerabilities.push_back(one);
            item.finish();
        }
    });
    return records;
}

}  // namespace canproof::host
