// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct Lock {
    explicit Lock(int& held);
    ~Lock();
};
int held(int& value) {
    Lock{value};  // flagged
    return value;
}
