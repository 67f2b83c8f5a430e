// SPDX-License-Identifier: Apache-2.0
// Each marked line must be flagged.
int answer();
struct Big {
    ~Big();
};
Big big();
void ask() {
    answer();  // flagged
    big();     // flagged
}
