# SPDX-License-Identifier: Apache-2.0
"""Describes the worst path of a bound: how often it runs each function, each call and each loop."""
from ipet import Flow


def lines_of(flow: Flow):
    """Yields the lines about the worst path of a solved Flow. Each function on the path has one paragraph, callers before the functions
    that they call. A number is a sum over all calls of the function; it may be a fraction, because the optimum is over real numbers."""
    counts, name = flow.values, flow.program.name
    for key in flow.in_order():
        calls = counts[flow.calls[key]]
        if calls < 0.001:
            continue
        yield f"{name(key[0])}: {calls:g} calls, {flow.own_cost(key):.0f} instructions of its own"
        called = {}
        for callee, variable in flow.calls_from(key):
            called[name(callee[0])] = called.get(name(callee[0]), 0) + counts[variable]
        for callee, count in sorted(called.items(), key=lambda one: -one[1]):
            if count >= 0.001:
                yield f"    {count:g} x {callee}"
        for loop, back in flow.loops_of(key):
            if back >= 0.001:
                yield f"    {back:g} turns of {loop}"
