// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Row {
    int first;
    int read() {
        const auto get = [this] { return first; };
        return get();
    }
};
