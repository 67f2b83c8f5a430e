// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Row {
    int first;
    int read() {
        const auto get = [=] { return first; };  // flagged
        return get();
    }
};
