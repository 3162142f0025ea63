"""The completion problems, one file each, named like the exercise that they lead to."""
