// SPDX-License-Identifier: Apache-2.0
// The checkers must flag no line of this file.
namespace own {
int begin();
}
int main() { return own::begin(); }
