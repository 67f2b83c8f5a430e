// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
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
