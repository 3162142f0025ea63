"""The example answers to the open tasks, one file for each step: the code that measured them."""
