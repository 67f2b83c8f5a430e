// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int answer();
void run();
int ask() {
    run();
    static_cast<void>(answer());
    return answer();
}
