// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
#include <memory>
int* give();
int hold() {
    const std::unique_ptr<int> held{give()};  // flagged
    return *held;
}
