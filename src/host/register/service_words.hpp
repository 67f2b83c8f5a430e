// SPDX-License-Identifier: Apache-2.0
// The words for the services that an entry of the dictionary can configure or show.
#pragma once

#include <string>
#include <vector>

namespace canproof::host {

/// Returns the register's word for each enumerator of the firmware's enumeration Service, in the order of the
/// enumeration.
const std::vector<std::string>& service_words();

}  // namespace canproof::host
