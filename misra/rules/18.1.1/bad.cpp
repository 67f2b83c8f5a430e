// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
void fail(const int& value) {
    throw &value;  // flagged
}
