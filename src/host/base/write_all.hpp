// SPDX-License-Identifier: Apache-2.0
// Writes bytes to a descriptor.
#pragma once

#include <string_view>

namespace canproof::host {

/// Writes all bytes, also when signals interrupt the calls. Returns false on an error, whose number errno then has.
bool write_all(int descriptor, std::string_view bytes);

}  // namespace canproof::host
