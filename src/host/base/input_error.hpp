// SPDX-License-Identifier: Apache-2.0
// The error type for unusable input.
#pragma once

#include <stdexcept>

namespace canproof::host {

/// Input that cannot be used; the message contains file, line and remedy.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace canproof::host
