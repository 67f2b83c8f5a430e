#include "host/assess/evidence/sbom.hpp"

#include <nlohmann/json.hpp>

#include "host/assess/evidence/provenance.hpp"

namespace canproof::host {

std::string write_sbom(const Provenance& provenance) {
    using Json = nlohmann::ordered_json;
    const std::string ref = "pkg:generic/canproof@" + provenance.commit;
    Json components = Json::array();
    Json uses = Json::array();
    for (const auto& [name, version] : provenance.packages) {
        const std::string purl = "pkg:deb/debian/" + name + "@" + version;
        components.push_back(
            {{"type", "library"}, {"bom-ref", purl}, {"name", name}, {"version", version}, {"purl", purl}});
        uses.push_back(purl);
    }
    Json document{{"bomFormat", "CycloneDX"}, {"specVersion", "1.5"}, {"version", 1}};
    document["metadata"] = {
        {"component",
         {{"type", "application"}, {"bom-ref", ref}, {"name", "canproof"}, {"version", provenance.commit}}}};
    if (!provenance.date.empty()) {
        document["metadata"]["timestamp"] = provenance.date;
    }
    document["components"] = components;
    document["dependencies"] = Json::array({Json{{"ref", ref}, {"dependsOn", uses}}});
    return document.dump(2) + "\n";
}

}  // namespace canproof::host
