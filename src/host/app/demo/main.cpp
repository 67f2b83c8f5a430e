// SPDX-License-Identifier: Apache-2.0
// canproof_demo is a program with only the command `demo` of canproof. `./run` builds it first, because it needs a
// third of the sources: so the first CAN frames of the devices appear early.
#include <exception>
#include <iostream>

#include "host/app/cli/demo_command.hpp"
#include "host/base/standard_streams.hpp"

int main() {
    canproof::host::keep_standard_descriptors();
    try {
        const int status = canproof::host::play_examples();
        canproof::host::finish_standard_output();
        return status;
    } catch (const std::exception& error) {
        std::cerr << "canproof_demo: " << error.what() << '\n';
        return 2;
    }
}
