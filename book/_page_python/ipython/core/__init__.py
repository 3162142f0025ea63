"""Where IPython keeps its shell."""
