// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int count(const int value) {
    using Count = int;
    const Count result{value};
    return result;
}
