// SPDX-License-Identifier: Apache-2.0
// Writes the verdicts of theorems for the audit, in the form in which the test programs write their results.
#pragma once

#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Returns a test case for each theorem that names a requirement, with an XML property of the kind `proof` for each
/// requirement. A refuted theorem is a failed test case. An unknown theorem is left out, because it shows nothing.
std::string verdict_xml(const std::vector<TheoremResult>& results);

}  // namespace canproof::host::prove
