// SPDX-License-Identifier: Apache-2.0
// The checkers must flag each line marked `flagged`, and no other line.
struct View {
    explicit View(const int& seen [[clang::lifetimebound]]) : value{seen} {}
    const int& value;
};
int make();
int look() {
    const View view{make()};  // flagged
    return view.value;
}
