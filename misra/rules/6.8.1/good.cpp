// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
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
