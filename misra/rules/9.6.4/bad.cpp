// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
[[noreturn]] void stop(const bool now) {
    while (now) {
    }
}  // flagged
