// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
int read(const int value) {
    const auto get = [value] { return value + 1; };
    return get();
}
