// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
template <typename T>
struct Base {
    int read();
};
template <typename T>
struct Derived : Base<T> {  // flagged
};
template <typename T>
struct Mixed : T {  // flagged
};
