// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
int& open_up(const int& value) {
    return const_cast<int&>(value);  // flagged
}
int* open_too(const int* const value) {
    return (int*)value;  // flagged
}
