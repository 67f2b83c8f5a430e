// What every command says of input that it cannot use.
#pragma once

#include <stdexcept>

namespace canproof::host {

/// Input that cannot be used: says file, line and remedy.
class InputError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace canproof::host
