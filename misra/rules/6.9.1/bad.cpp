// SPDX-License-Identifier: Apache-2.0
// The marked definition names its type by another alias than its declaration.
namespace aliases {
using Index = int;
using Count = int;
int next(Index at);
int next(const Count at) {  // flagged
    return at + 1;
}
}  // namespace aliases
