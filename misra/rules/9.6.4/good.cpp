// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
[[noreturn]] void stop();
void go(const bool now) {
    if (now) {
        stop();
    }
}
