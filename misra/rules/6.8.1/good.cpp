// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
struct View {
    explicit View(const int& seen [[clang::lifetimebound]]) : value{seen} {}
    const int& value;
};
int make();
int look() {
    const int made{make()};
    const View view{made};
    return view.value;
}
