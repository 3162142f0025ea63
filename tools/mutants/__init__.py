"""Wrong functions made from the right ones, and how many of them the cases of a card refuse.

A mutant is the reference of an exercise with one small fault: another constant, a flipped
comparison, a lost line. `tools.mutants.score` makes all of them, drops those that never differ from
the reference on a fixed stream of valid inputs, and counts how many of the others the visible and
the hidden cases refuse. What survives is listed with its reason (`tools.mutants.reasons`).

Why an own mutator: mutmut and cosmic-ray write each mutant into the source file and run a test
command for it, which costs an import of NumPy, OpenCV and MuJoCo and a run of pytest, seconds each.
There are thousands of mutants here, and each is judged on cases of 50 seeds and thousands of
inputs. So a mutant is compiled in memory, beside the reference, and both answer in one process in
microseconds. It also keeps mutants of the library from reaching the checker, which uses the same
library.
"""
