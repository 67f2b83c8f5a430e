// SPDX-License-Identifier: Apache-2.0
// The exception that ends a proof without a decision.
#pragma once

#include <stdexcept>

namespace canproof::host::prove {

/// Reports that the program contains something that the prover does not model, or that a limit was reached. The text
/// gives the reason, and the function and line in the source where they are known. The verdict of the theorem is then
/// unknown, never proven.
class Unknown : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace canproof::host::prove
