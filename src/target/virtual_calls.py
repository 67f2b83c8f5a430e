# SPDX-License-Identifier: Apache-2.0
"""The functions that a call through a virtual table or a pointer may reach, as virtual_calls.toml lists them."""
import re


def name_of(demangled):
    """Returns the name that a caller has in virtual_calls.toml."""
    return re.sub(r"^.*?canproof::", "", demangled.split("(")[0])


def answers_of(table, demangled, names):
    """Returns the symbols that the indirect calls of a function may reach; `names`: demangled names by symbol."""
    caller = name_of(demangled)
    if caller not in table["callers"]:
        raise ValueError(f"{caller} calls through a pointer: say in virtual_calls.toml what may answer")
    found = set()
    for function in table["callers"][caller]:
        if function == "constructors":
            found.update(one for one in names if one.startswith("_GLOBAL__sub_I"))
            continue
        method = function.removeprefix("memory_")
        pattern = re.compile(rf"::(?:{'|'.join(table['answers'][function])})(?:<[^>]*>)?::{method}\(")
        answers = {one for one, name in names.items() if pattern.search(name)}
        if not answers:
            raise ValueError(f"nothing in the image answers {function}, which {caller} calls; correct virtual_calls.toml")
        found |= answers
    return found
