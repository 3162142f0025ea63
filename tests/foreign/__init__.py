"""Models of dm_control, robosuite and gymnasium: is the library right on robots it never saw?

Runs in an environment of its own, which ``python -m tests.foreign`` (``make foreign``) makes.
"""
