// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct Lock {
    explicit Lock(int& held);
    ~Lock();
};
int held(int& value) {
    Lock{value};  // flagged
    return value;
}
