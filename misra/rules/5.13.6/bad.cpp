// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
long long big() {
    return 12345678998L;  // flagged
}
