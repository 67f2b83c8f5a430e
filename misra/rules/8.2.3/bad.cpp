// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int& open_up(const int& value) {
    return const_cast<int&>(value);  // flagged
}
int* open_too(const int* const value) {
    return (int*)value;  // flagged
}
