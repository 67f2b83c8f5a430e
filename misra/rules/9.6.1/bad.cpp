// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int leave(const int value) {
    if (value > 3) {
        goto end;  // flagged
    }
    return value;
end:
    return 3;
}
