// SPDX-License-Identifier: Apache-2.0
// The error type for unusable input.
#pragma once

#include <stdexcept>

namespace canproof::host {

/// Reports input that cannot be used. The message says what is wrong, where, and how to fix it.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace canproof::host
