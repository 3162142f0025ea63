"""What draws: one protocol, and one module for each way of drawing.

Both ways have a ``read_raw_depth(model, renderer)``: how a raw depth buffer is read is theirs to
know. Which of them draws on this machine, `labutils.rendering` decides.
"""
