// SPDX-License-Identifier: Apache-2.0
#include "host/datasheet/check/eds_finding.hpp"

namespace canproof::host {

const char* to_text(EdsSeverity severity) {
    return severity == EdsSeverity::error ? "error" : "warning";
}

}  // namespace canproof::host
