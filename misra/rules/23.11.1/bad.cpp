// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
#include <memory>
int* give();
int hold() {
    const std::unique_ptr<int> held{give()};  // flagged
    return *held;
}
