// SPDX-License-Identifier: Apache-2.0
// Verdicts of theorems for the audit, in the form in which the test programs leave theirs.
#pragma once

#include <string>
#include <vector>

#include "host/prove/theorem.hpp"

namespace canproof::host::prove {

/// Returns a test case for each theorem that names a requirement, with a claim of the kind `proof` for each
/// requirement. A refuted theorem has failed. An unknown theorem is left out, because it shows nothing.
std::string verdict_xml(const std::vector<TheoremResult>& results);

}  // namespace canproof::host::prove
