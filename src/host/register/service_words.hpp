// SPDX-License-Identifier: Apache-2.0
// The words for the services that an entry of the dictionary can configure or show.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// Returns the register's words for the firmware's Service, in the order of that enumeration.
const std::vector<std::string>& service_words();

}  // namespace canproof::host
