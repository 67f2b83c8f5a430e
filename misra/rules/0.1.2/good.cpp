// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
int answer();
void run();
int ask() {
    run();
    static_cast<void>(answer());
    return answer();
}
