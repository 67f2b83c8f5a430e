// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int leave(const int value) {
    if (value > 3) {
        goto end;  // flagged
    }
    return value;
end:
    return 3;
}
