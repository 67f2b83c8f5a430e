// SPDX-License-Identifier: Apache-2.0
#include "host/assess/evidence/sbom.hpp"

#include <nlohmann/json.hpp>

#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

namespace {

using Json = nlohmann::ordered_json;

std::string purl_of(const std::string& name, const std::string& version) {
    return "pkg:deb/debian/" + name + "@" + version;
}

Json component_of(const std::string& name, const std::string& version, const Provenance& provenance,
                  const PackageRecord* record) {
    const std::string purl = purl_of(name, version);
    Json component{{"type", "library"}, {"bom-ref", purl}, {"name", name}, {"version", version}};
    if (record != nullptr) {
        component["scope"] = record->scope;
    }
    if (const auto sum = provenance.package_sums.find(name); sum != provenance.package_sums.end()) {
        component["hashes"] = Json::array({Json{{"alg", "SHA-256"}, {"content", sum->second}}});
    }
    if (record != nullptr) {
        const Json many{{"license", {{"name", "several licences: /usr/share/doc/" + name + "/copyright"}}}};
        component["licenses"] = Json::array({record->licence.empty() ? many : Json{{"expression", record->licence}}});
    }
    component["purl"] = purl;
    return component;
}

/// Converts the state of a recorded vulnerability from the words of OpenVEX to those of CycloneDX.
std::string cyclonedx_state(const std::string& state) {
    return state == "fixed" ? "resolved" : state == "affected" ? "exploitable" : state;
}

Json vulnerabilities_of(const Provenance& provenance, const PackageRecords& records) {
    Json all = Json::array();
    for (const auto& one : records.vulnerabilities) {
        if (const auto version = provenance.packages.find(one.package); version != provenance.packages.end()) {
            all.push_back({{"id", one.id},
                           {"analysis", {{"state", cyclonedx_state(one.state)}, {"detail", one.detail}}},
                           {"affects", Json::array({Json{{"ref", purl_of(one.package, version->second)}}})}});
        }
    }
    return all;
}

}  // namespace

std::string write_sbom(const Provenance& provenance, const PackageRecords& records) {
    const std::string ref = "pkg:generic/canproof@" + provenance.commit;
    Json components = Json::array();
    Json uses = Json::array();
    for (const auto& [name, version] : provenance.packages) {
        const Json component = component_of(name, version, provenance, records.package(name));
        components.push_back(component);
        if (component.value("scope", "required") != "excluded") {
            uses.push_back(component.at("bom-ref"));
        }
    }
    Json document{{"$schema", "http://cyclonedx.org/schema/bom-1.6.schema.json"},
                  {"bomFormat", "CycloneDX"},
                  {"specVersion", "1.6"},
                  {"version", 1}};
    Json metadata = Json::object();
    if (!provenance.date.empty()) {
        metadata["timestamp"] = provenance.date;
    }
    metadata["component"] = {{"type", "application"},
                             {"bom-ref", ref},
                             {"name", "canproof"},
                             {"version", provenance.commit},
                             {"licenses", Json::array({Json{{"expression", "Apache-2.0"}}})}};
    metadata["properties"] = Json::array(
        {Json{{"name", "canproof:vulnerabilities"},
              {"value",
               "no vulnerability database was searched; reports/packages.toml records the assessed vulnerabilities "
               "and the lists that were read"}}});
    document["metadata"] = metadata;
    document["components"] = components;
    document["dependencies"] = Json::array({Json{{"ref", ref}, {"dependsOn", uses}}});
    document["vulnerabilities"] = vulnerabilities_of(provenance, records);
    return document.dump(2) + "\n";
}

}  // namespace canproof::host
