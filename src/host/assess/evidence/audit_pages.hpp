// SPDX-License-Identifier: Apache-2.0
// The audit as pages: one for each device and one for the shared rules, with their items by service, and one page that
// links to these pages.
#pragma once

#include <string>

#include "host/assess/evidence/pack_input.hpp"

namespace canproof::host {

/// Returns the service of an item, which is the name of its file in the register: `sdo_block`. Files of the same name
/// in `objects/` and in `behaviour/` belong to the same service.
std::string service_of(const Item& item);
/// Returns the title of a service: `SDO block` for `sdo_block`.
std::string service_title(const std::string& service);

/// Returns the title of a device, or that of the rules that all devices share.
std::string title_of(const Part& part);

/// Returns the body of the page with the counts of items by device and service, the gaps, and the suspects (items that
/// have changed since their review).
std::string audit_page(const PackInput& input);

/// Returns the body of the page with the items of one device, or of the shared rules, by service. It shows sources,
/// code, tests and state; a reader can search and filter the items.
std::string part_audit_page(const PackInput& input, const PartAudit& audit);

}  // namespace canproof::host
