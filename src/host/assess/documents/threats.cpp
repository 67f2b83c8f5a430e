// SPDX-License-Identifier: Apache-2.0
#include "host/assess/documents/threats.hpp"

#include <fmt/format.h>

#include "host/assess/documents/words.hpp"

namespace canproof::host {

Document threats(const Part& part, const Analysis& analysis) {
    DocumentTable table{"Threats", {"Service", "Foundational requirement", "Threat", "Limited by", "What is left"}, {}};
    for (const auto& one : analysis.threats) {
        if (holds(one.condition, part)) {
            table.rows.push_back({one.service, one.requirement, one.text, joined_or(one.by, missing), one.rest});
        }
    }
    return {
        "threats",
        fmt::format("Threats to the {}", part.info.title),
        "The attacks that each service of the device permits to an attacker on the bus, each with its foundational "
        "requirement of IEC 62443, and the requirements that limit the attack.",
        {Chapter{
            "Services",
            {"CANopen has no authentication, no encryption and no source address: anyone with access to the bus can "
             "send every message. The device cannot change this. The bus is a zone of its own, and the gateway to it "
             "is the conduit that must be guarded.",
             "This is an analysis by the authors. Nobody else has reviewed it, and no security level is claimed."},
            {table}}}};
}

}  // namespace canproof::host
