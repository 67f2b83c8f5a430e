// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Lock {
    explicit Lock(int& held);
    ~Lock();
};
int held(int& value) {
    const Lock lock{value};
    return value;
}
