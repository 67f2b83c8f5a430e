#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Tests the rules of independence.py: pairs of calls, each with the known answer whether their order matters."""
import sys

import clang.cindex
from clang.cindex import CursorKind as K

sys.dont_write_bytecode = True
from independence import are_independent  # noqa: E402

DECLARATIONS = """
namespace std {
template <typename T, unsigned long N> struct array { T held[N]; void fill(T value); };
template <typename T> struct optional { T held; const T* operator->() const; };
}
template <typename T> struct Field { unsigned offset; };
template <typename T> struct ArrayField { Field<T> operator[](unsigned at) const; };
namespace field {
constexpr Field<int> one{0};
constexpr Field<int> two{1};
extern const ArrayField<int> list;
extern const ArrayField<int> other_list;
}
struct ObjectDictionary {
    template <typename T> void set(Field<T> field, T value);
    template <typename T> void set_given(Field<T> field, const std::optional<T>& value);
    template <typename T> T get(Field<T> field) const;
    int& bytes;
};
int twice(int value);
int count(int& value);
int asked(const ObjectDictionary& objects);
struct Values { int one; int two; bool flag; void set(int value); void set(int value, ObjectDictionary& objects); int get() const; };
struct Inner { Values values; std::array<Values, 2> several; void reset(); };
struct View { int* bytes; void reset(); };
struct Holder { View view; void reset(); };
struct Device {
    ObjectDictionary& objects;
    Values a; Values b; Inner c; View v; View w; Holder h; Values& r; std::array<int, 3> x; std::array<int, 3> y; Values parts[2];
    int number; std::optional<Values> found; std::optional<int> given;
    Field<int> held;
    int own() const;
    void run(int n, int m);
};
"""

INDEPENDENT = """
objects.set(field::one, 1); objects.set(field::two, 2);
objects.set(field::one, n); objects.set(field::two, twice(number));
objects.set(field::one, found->one); objects.set(field::two, found->two);
objects.set_given(field::one, given); objects.set_given(field::two, given);
objects.set(field::list[1], n); objects.set(field::list[2], n);
objects.set(field::list[n], n); objects.set(field::other_list[n], n);
a.set(n); b.set(m);
a.set(n); c.reset();
a.set(n); c.values.set(n);
c.values.set(number); b.set(twice(n));
x.fill(n); y.fill(n);
"""

BOUND = """
objects.set(field::one, 1); objects.set(field::one, 2);
objects.set(field::one, 1); objects.set(field::two, objects.get(field::one));
objects.set(field::one, 1); objects.set(field::two, asked(objects));
objects.set(field::one, n++); objects.set(field::two, n);
objects.set(field::one, count(n)); objects.set(field::two, n);
objects.set(field::one, own()); objects.set(field::two, own());
objects.set(field::list[1], n); objects.set(field::list[1], m);
objects.set(field::list[n], n); objects.set(field::list[m], n);
objects.set(field::list[n], n); objects.set(field::list[1], n);
objects.set(field::list[1 + n], n); objects.set(field::list[2 + m], n);
objects.set(held, n); objects.set(field::one, m);
a.set(n); a.set(m);
a.set(n); b.set(a.get());
a.set(n); b.set(a.one);
a.set(n = m); b.set(n);
a.set(n, objects); b.set(m, objects);
a.set(n); r.set(m);
c.reset(); c.values.set(n);
v.reset(); w.reset();
a.set(n); h.reset();
parts[n].set(1); parts[m].set(2);
a.set(n); own();
"""


def pairs(lines):
    """Returns (text, first call, second call) for each line of the text, which contains two calls."""
    bodies = lines.strip().splitlines()
    text = DECLARATIONS.replace("    void run(int n, int m);\n", "".join(
        f"    void run_{i}(int n, int m) {{ {body} }}\n" for i, body in enumerate(bodies)))
    unit = clang.cindex.Index.create().parse("pairs.cpp", args=["-std=c++17"], unsaved_files=[("pairs.cpp", text)])
    errors = [d.format() for d in unit.diagnostics if d.severity >= clang.cindex.Diagnostic.Error]
    if errors:
        raise SystemExit("\n".join(errors))
    for cursor in unit.cursor.walk_preorder():
        if cursor.kind == K.CXX_METHOD and cursor.spelling.startswith("run_"):
            first, second = list(list(cursor.get_children())[-1].get_children())
            yield bodies[int(cursor.spelling[4:])], first, second


def main():
    faults = [f"{text}: not independent" for text, first, second in pairs(INDEPENDENT) if not are_independent(first, second)]
    faults += [f"{text}: independent" for text, first, second in pairs(BOUND) if are_independent(first, second)]
    print("\n".join([*faults, f"{len(faults)} faults"]))
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    clang.cindex.Config.set_library_file("/usr/lib/llvm-19/lib/libclang-19.so.1")
    main()
