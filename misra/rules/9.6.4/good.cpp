// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
[[noreturn]] void stop();
void go(const bool now) {
    if (now) {
        stop();
    }
}
