// SPDX-License-Identifier: Apache-2.0
#include "host/register/read_hazard.hpp"

#include <fmt/format.h>

#include "host/register/read_item.hpp"

namespace canproof::host {

namespace {

Hazard::Failure read_failure(TomlItem& item) {
    Hazard::Failure failure;
    failure.place = item.place();
    failure.text = item.text("text");
    failure.prevented_by = item.texts("prevented_by", false);
    failure.reason = item.text_or("reason", "");
    if (failure.prevented_by.empty() == failure.reason.empty()) {
        item.fault("a failure needs `prevented_by` or `reason`, and not both",
                   "name the requirements that prevent the failure, or give the reason why no requirement does");
    }
    item.finish();
    return failure;
}

}  // namespace

Hazard read_hazard(TomlItem& item) {
    Hazard hazard;
    hazard.place = item.place();
    read_id(item, hazard);
    hazard.text = item.text("text");
    hazard.at = item.texts("at", true);
    hazard.at_place = item.place("at");
    hazard.safe_state = item.text("safe_state");
    hazard.decisions = item.texts("decisions", false);
    hazard.decisions_place = item.place("decisions");
    for (TomlItem& one : item.items("failure")) {
        hazard.failures.push_back(read_failure(one));
    }
    if (hazard.failures.empty()) {
        item.fault(fmt::format("{} has no failure", hazard.id), "write a [[hazard.failure]] for each cause");
    }
    item.finish();
    return hazard;
}

}  // namespace canproof::host
