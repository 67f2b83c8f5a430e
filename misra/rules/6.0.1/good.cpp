// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
struct Lock {};
int held() {
    const Lock lock{};
    static_cast<void>(lock);
    return 3;
}
