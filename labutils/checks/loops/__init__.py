"""Answers that act: a controller is put into loops, and judged by what happens there.

Two controllers that are right move differently, so nothing here is compared with a right answer. A
`Loop` says what happens to the ball; `run_loop` lets the controller act and writes down a trace;
`labutils.checks.kinds.closed_loop` reads from the trace which properties hold.
"""
