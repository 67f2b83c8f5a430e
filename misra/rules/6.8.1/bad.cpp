// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
struct View {
    explicit View(const int& seen [[clang::lifetimebound]]) : value{seen} {}
    const int& value;
};
int make();
int look() {
    const View view{make()};  // flagged
    return view.value;
}
